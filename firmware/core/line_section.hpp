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

constexpr std::uint64_t magnitude(std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); }
// v 2^-shift, rounded down.
constexpr std::int64_t shifted_down(std::int64_t v, int shift) {
  return shift >= 0 ? v >> shift : v * (std::int64_t{1} << std::min(-shift, 62));
}
constexpr std::uint32_t high_product(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32);
}
constexpr std::int32_t high_product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(std::int64_t{a} * b >> 32);
}

// A polynomial of the line in 32 bits: v0 + 4 v1 tau + 8 v2 tau^2, tau = t 2^-half_bits with 31 bits of fraction. Without v2 a
// value is off by less than 16 units, with it by 40: a cut v2 counts 8, v1 4, v0 1, the products 16 and 8.
struct ShortPolynomial {
  std::int32_t v0 = 0, v1 = 0, v2 = 0;

  [[nodiscard]] std::int32_t linear(std::int32_t tau) const { return v0 + (high_product(v1, tau) << 3); }
  [[nodiscard]] std::int32_t at(std::int32_t tau) const {
    return v0 + (high_product(v1 + (high_product(v2, tau) << 2), tau) << 3);
  }
};

// One dot of the section; its level follows from `light`.
struct LitDot {
  std::int32_t t, s, r;
  Light light;
};

// What a quick dot may be off by: s, L, and |N|^2 in units of 2^16.
struct QuickErrors {
  std::int32_t root, light, square;
};

class LineSection {
 public:
  LineSection(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);

  [[nodiscard]] std::int32_t middle() const { return middle_; }
  [[nodiscard]] std::int32_t half() const { return half_; }
  [[nodiscard]] int half_bits() const { return half_bits_; }
  // L = 0 on the whole line.
  [[nodiscard]] bool dark() const { return dark_; }

  [[nodiscard]] LitDot dot(std::int32_t t) const {
    LitDot dot;
    dot.t = t;
    dot.s = root(t);
    dot.r = static_cast<std::int32_t>(r_.linear(t) >> 32);
    dot.light.l = (l_.linear(t) >> light_fraction) + (std::int64_t{m_} * dot.s >> 30);
    // The error of s can take a small |N|^2 below 0; the true one is not.
    dot.light.n2 = std::max<std::int64_t>(q_.at(t) + std::int64_t{dot.r} * dot.s, 0);
    return dot;
  }
  // s alone.
  [[nodiscard, gnu::always_inline]] std::int32_t root(std::int32_t t) const {
    const std::int64_t d = d_.at(t);
    return d > 0 ? quick_root(static_cast<std::uint64_t>(d)) : 0;
  }
  // The dot in shorter words, to within quick_errors().
  [[nodiscard, gnu::always_inline]] LitDot quick_dot(std::int32_t t) const {
    LitDot dot;
    const std::int32_t tau = t << tau_shift_;
    dot.t = t;
    dot.s = root(t);
    dot.r = short_r_.linear(tau);
    dot.light.l = short_l_.linear(tau) + static_cast<std::int32_t>(std::int64_t{m_} * dot.s >> 30);
    dot.light.n2 =
        std::max<std::int64_t>(std::int64_t{short_q_.at(tau)} * (1 << short_unit) + std::int64_t{dot.r} * dot.s, 0);
    return dot;
  }
  // What s may be off by at a dot.
  [[nodiscard]] std::int32_t root_error(std::int32_t s) const { return s >= deep_from_ ? 6 : half_ + 6; }
  [[nodiscard]] std::int32_t root_error(const LitDot& dot) const { return root_error(dot.s); }
  [[nodiscard]] const QuickErrors& quick_errors(const LitDot& dot) const { return quick_errors_[deep(dot) ? 1 : 0]; }
  // Of dot(): of L, and of L^2 - square |N|^2 / 2^32.
  [[nodiscard]] Margin margin(const LitDot& dot, std::uint32_t square) const {
    return margin_of(errors_[deep(dot) ? 1 : 0], dot.light, square);
  }

  [[nodiscard]] const LinePolynomial& discriminant() const { return d_; }
  [[nodiscard]] const LinePolynomial& square() const { return q_; }
  [[nodiscard]] const LinePolynomial& square_root() const { return r_; }  // 32 bits of fraction
  [[nodiscard]] const LinePolynomial& light() const { return l_; }        // 28 bits of fraction
  [[nodiscard]] std::int32_t light_root() const { return m_; }            // of 2^30 parts

  static constexpr int light_fraction = 28;
  static constexpr int short_unit = 28;  // log2 of the unit of short_q_

 private:
  // Away from limbs, where s is off by no more than a root's own error.
  [[nodiscard]] bool deep(const LitDot& dot) const { return dot.s >= deep_from_; }

  static constexpr int error_unit = 10;
  struct Errors {
    std::uint32_t light, square;  // of L; of |N|^2 in 2^error_unit
    std::uint64_t light_squared;
  };
  [[nodiscard]] static Margin margin_of(const Errors& e, const Light& light, std::uint32_t square) {
    const std::uint64_t from_l = (magnitude(light.l) & 0xffffffffU) * (2 * e.light) + e.light_squared;
    const std::uint64_t from_n = (std::uint64_t{square} * e.square >> 32) + 1;
    // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
    return {e.light, static_cast<std::int64_t>(from_l + (from_n << error_unit)) + (light.n2 >> 32) + 4};
  }
  void load(const RootSurface& f, int light_bits, std::int32_t x, std::int32_t y);
  void prepare_errors();
  [[nodiscard]] Errors errors_for(std::int64_t root_error) const;

  std::int32_t middle_, half_;
  int half_bits_, tau_shift_;
  LinePolynomial d_, q_, r_, l_;
  std::int32_t m_ = 0;
  ShortPolynomial short_q_, short_r_, short_l_;
  std::int32_t deep_from_ = 0;  // from this s on its error is 6
  bool dark_ = false;
  Errors errors_[2] = {};  // at a limb, and elsewhere
  QuickErrors quick_errors_[2] = {};
};

}  // namespace halfspace
