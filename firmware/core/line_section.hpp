// line_section.hpp - one scan line of a root face: what light and normal are at any dot of it, by products instead of steps.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  D and q quadratic, l and r linear in t, the dot counted from the middle.
// Units   D < 2^60 and |N|^2 < 2^60, s < 2^30, |L| < 2^31; level k is reached when L > 0 and L^2 >= squares[k] |N|^2 / 2^32.
// Errors  Bounded as for a walk (docs/core.md): polynomials are rounded once for a line, and h dots from the middle a rounded
//         quadratic is off by less than h^2 + h + 2.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/level_search.hpp"
#include "firmware/core/quick_root.hpp"

namespace halfspace {

// A section has at most so many dots on either side of its middle, which keeps a polynomial's error far under a root's.
inline constexpr std::int32_t longest_half = 1024;

// A polynomial of the line: v0 + v1 t + v2 t^2.
struct LinePolynomial {
  std::int64_t v0 = 0, v1 = 0, v2 = 0;

  // Unsigned, so that a job that lies about its widths wraps and nothing worse.
  [[nodiscard]] std::int64_t at(std::int32_t t) const { return sum(v0, t, sum(v1, t, v2)); }
  [[nodiscard]] std::int64_t linear(std::int32_t t) const { return sum(v0, t, v1); }
  [[nodiscard]] std::int64_t slope(std::int32_t t) const { return sum(v1, 2 * t, v2); }

 private:
  // a + t b
  static std::int64_t sum(std::int64_t a, std::int32_t t, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                     static_cast<std::uint64_t>(std::int64_t{t}) * static_cast<std::uint64_t>(b));
  }
};

// One dot of the section; its level follows from `light`.
struct LitDot {
  std::int32_t t, s, r;
  Light light;
};

// How L and |N|^2 change from dot to dot there.
struct LitSlope {
  std::int64_t l, n2;
  bool known;
};

class LineSection {
 public:
  LineSection(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);

  [[nodiscard]] std::int32_t middle() const { return middle_; }
  [[nodiscard]] std::int32_t half() const { return half_; }
  [[nodiscard]] int half_bits() const { return half_bits_; }
  // L = 0 on the whole line.
  [[nodiscard]] bool dark() const { return dark_; }

  [[nodiscard, gnu::always_inline]] LitDot dot(std::int32_t t) const {
    LitDot dot;
    dot.t = t;
    const std::int64_t d = d_.at(t);
    dot.s = d > 0 ? quick_root(static_cast<std::uint64_t>(d)) : 0;
    dot.r = static_cast<std::int32_t>(r_.linear(t) >> 32);
    dot.light.l = (l_.linear(t) >> light_fraction) + (std::int64_t{m_} * dot.s >> 30);
    // The error of s can take a small |N|^2 below 0; the true one is not.
    dot.light.n2 = std::max<std::int64_t>(q_.at(t) + std::int64_t{dot.r} * dot.s, 0);
    return dot;
  }
  // Not known where s is small: at limbs.
  [[nodiscard]] LitSlope slope(const LitDot& dot) const;

  // What s may be off by at a dot.
  [[nodiscard]] std::int32_t root_error(const LitDot& dot) const { return dot.s >= deep_from_ ? 6 : half_ + 6; }
  // Of L, and of L^2 - square |N|^2 / 2^32.
  [[nodiscard, gnu::always_inline]] Margin margin(const LitDot& dot, std::uint32_t square) const {
    const Errors& e = errors_[dot.s >= deep_from_ ? 1 : 0];
    const std::int64_t l = dot.light.l < 0 ? -dot.light.l : dot.light.l;
    const std::uint64_t from_l = std::uint64_t{static_cast<std::uint32_t>(l)} * (2 * e.light) + e.light_squared;
    const std::uint64_t from_n = (std::uint64_t{square} * e.square >> 32) + 1;
    // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
    return {e.light, static_cast<std::int64_t>(from_l + (from_n << error_unit)) + (dot.light.n2 >> 32) + 4};
  }

  // False where, to the neighbouring dots, s leaves its tangent by so little, eps, that eps times what L - t |N| changes with s,
  // times 2 L, is less than room; where s >= 2^24, and |s'| <= s / 8.
  [[nodiscard]] bool bent(const LitDot& dot, std::int64_t room) const;

  [[nodiscard]] const LinePolynomial& discriminant() const { return d_; }
  [[nodiscard]] const LinePolynomial& square() const { return q_; }
  [[nodiscard]] const LinePolynomial& square_root() const { return r_; }  // 32 bits of fraction
  [[nodiscard]] const LinePolynomial& light() const { return l_; }        // 28 bits of fraction
  [[nodiscard]] std::int32_t light_root() const { return m_; }            // of 2^30 parts

  static constexpr int light_fraction = 28;

 private:
  static constexpr int error_unit = 10;
  struct Errors {
    std::uint32_t light, square;  // of L; of |N|^2 in 2^error_unit
    std::uint64_t light_squared;
  };
  [[nodiscard]] Errors errors_for(std::int64_t root_error) const;

  LinePolynomial d_, q_, r_, l_;
  std::int32_t m_ = 0;
  std::int32_t middle_ = 0, half_ = 0;
  int half_bits_ = 0;
  int slope_shift_ = 0;         // D's slope in 31 bits
  std::int32_t deep_from_ = 0;  // from this s on its error is 6
  std::uint32_t bend_ = 0;      // see bent()
  bool dark_ = false;
  Errors errors_[2] = {};  // at a limb, and elsewhere
};

}  // namespace halfspace
