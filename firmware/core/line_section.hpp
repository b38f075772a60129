// line_section.hpp - one scan line of a root face: what light and normal are at any dot of it, by products instead of steps.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  D and q quadratic, l and r linear in t, the dot counted from the middle.
// Units   D < 2^60 and |N|^2 < 2^60, s < 2^30, |L| < 2^31; level k is reached when L > 0 and L^2 >= squares[k] |N|^2 / 2^32.
// Errors  Bounded as for a walk (docs/core.md): polynomials are rounded once for a line, and h dots from the middle a rounded
//         quadratic is off by less than h^2 + h + 2.
#pragma once

#include <cstdint>

#include "firmware/core/certified_root.hpp"
#include "firmware/core/level_search.hpp"

namespace halfspace {

// A section has at most so many dots on either side of its middle, which keeps a polynomial's error far under a root's.
inline constexpr std::int32_t longest_half = 1024;

// A polynomial of the line: v0 + v1 t + v2 t^2.
struct LinePolynomial {
  std::int64_t v0 = 0, v1 = 0, v2 = 0;

  // Unsigned, so that a job that lies about its widths wraps and nothing worse.
  [[nodiscard]] std::int64_t at(std::int32_t t) const { return sum(v0, t, sum(v1, t, v2)); }
  [[nodiscard]] std::int64_t slope(std::int32_t t) const { return sum(v1, 2 * t, v2); }

 private:
  // a + t b
  static std::int64_t sum(std::int64_t a, std::int32_t t, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                     static_cast<std::uint64_t>(std::int64_t{t}) * static_cast<std::uint64_t>(b));
  }
};

// One dot of the section.
struct LitDot {
  std::int32_t t = 0;
  Root root;
  Light light;
};

// How L, |N|^2 and s change from dot to dot there.
struct LitSlope {
  std::int64_t l = 0, n2 = 0, s = 0;
  bool known = false;
};

class LineSection {
 public:
  LineSection(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);

  [[nodiscard]] std::int32_t middle() const { return middle_; }
  [[nodiscard]] std::int32_t half() const { return half_; }
  [[nodiscard]] int half_bits() const { return half_bits_; }
  // L = 0 on the whole face.
  [[nodiscard]] bool grazing() const { return l_.v0 == 0 && l_.v1 == 0 && m_ == 0 && dark_; }

  [[nodiscard]] LitDot dot(std::int32_t t) const;
  [[nodiscard]] LitSlope slope(const LitDot& dot) const;
  // What s may be off by at a dot.
  [[nodiscard]] std::int64_t root_error(const LitDot& dot) const { return dot.root.s >= deep_from_ ? 6 : half_ + 6; }
  // Of L^2 - square |N|^2 / 2^32, and of L.
  [[nodiscard]] Margin margin(const LitDot& dot, std::uint32_t square) const;

  // False where, to the neighbouring dots, s leaves its tangent by so little, eps, that 4 L |v| eps < room, v the part of N that
  // goes with s; where s >= 2^24, and |s'| <= s / 8.
  [[nodiscard]] bool bent(const LitDot& dot, std::int64_t room) const;

  [[nodiscard]] const LinePolynomial& discriminant() const { return d_; }
  [[nodiscard]] const LinePolynomial& square() const { return q_; }
  [[nodiscard]] const LinePolynomial& square_root() const { return r_; }  // 32 bits of fraction
  [[nodiscard]] const LinePolynomial& light() const { return l_; }        // 28 bits of fraction
  [[nodiscard]] std::int32_t light_root() const { return m_; }            // of 2^30 parts

 private:
  LinePolynomial d_, q_, r_, l_;
  std::int32_t m_ = 0;
  std::int32_t middle_ = 0, half_ = 0;
  int half_bits_ = 0;
  bool dark_ = false;
  int slope_shift_ = 0;     // D's slope in 31 bits
  std::uint32_t bend_ = 0;  // see bent()
  std::int64_t deep_from_ = 0;
  std::int64_t light_error_[2] = {}, square_error_[2] = {};  // where s is small, and where not
};

}  // namespace halfspace
