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

// How s, L and, in units of 2^28, |N|^2 change from dot to dot there.
struct LitSlope {
  std::int32_t s, l, n2;
  bool known, steady;
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
  // The dot in shorter words, to within quick_margin() where it is deep().
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
  // Not known at limbs; steady where s' is off by less than 2^7 and at most s / 16, and |D2| at most s^2 / 9.
  [[nodiscard, gnu::always_inline]] LitSlope slope(const LitDot& dot) const {
    LitSlope slope{0, 0, 0, dot.s >= sloped_from_, false};
    if (!slope.known) return slope;
    const std::int32_t tau = dot.t << tau_shift_;
    slope.s = halved_ratio(d_slope_.linear(tau), dot.s);
    const std::int32_t size = slope.s < 0 ? -slope.s : slope.s;
    slope.known = size < 1 << 29;
    if (!slope.known) return slope;
    slope.steady = size < dot.s >> 4 && dot.s >= steady_from_;
    slope.l = l_slope_ + static_cast<std::int32_t>(std::int64_t{m_} * slope.s >> 30);
    slope.n2 = q_slope_.linear(tau) + high_product(r_slope_, dot.s) +
               static_cast<std::int32_t>(std::int64_t{dot.r} * slope.s >> 28);
    return slope;
  }

  // What s may be off by at a dot.
  [[nodiscard]] std::int32_t root_error(std::int32_t s) const { return s >= deep_from_ ? 6 : half_ + 6; }
  [[nodiscard]] std::int32_t root_error(const LitDot& dot) const { return root_error(dot.s); }
  // Of a quick dot away from limbs, for every square.
  [[nodiscard]] bool deep(const LitDot& dot) const { return dot.s >= deep_from_; }
  [[nodiscard]] const Margin& quick_margin() const { return quick_margin_; }
  // Of dot(): of L, and of L^2 - square |N|^2 / 2^32.
  [[nodiscard]] Margin margin(const LitDot& dot, std::uint32_t square) const {
    return margin_of(errors_[deep(dot) ? 1 : 0], dot.light, square);
  }

  // Where the slope is steady: whether, to the neighbouring dots, s leaves its tangent by so little, eps, that 2 L eps times what
  // L - t |N| changes with s is less than room (in 2^24).
  //   s'' = K / s^3, K = D0 D2 - D1^2 / 4. |s'| <= s / 16 and |D2| <= s^2 / 9 make D >= 4 (|D'| + |D2|), so neighbours have
  //   s >= sqrt(3/4) of here, and eps, half of the largest s'', is less than 0.78 K / s^3. L - t |N| changes with s by
  //   |m| + |v| at most, so 2 L (|m| + |v|) K <= room s^3 is enough.
  [[nodiscard, gnu::always_inline]] bool straight(const LitDot& dot, std::int32_t room) const {
    const std::uint32_t s = static_cast<std::uint32_t>(dot.s) << 2;
    const std::uint32_t cube = high_product(high_product(s, s), s);  // of s 2^-30, 32 bits of fraction
    const std::uint32_t bend = high_product(static_cast<std::uint32_t>(dot.light.l), bend_);
    return bend < 1U << 30 && 2 * bend + 2 < high_product(cube, static_cast<std::uint32_t>(room));
  }

  [[nodiscard]] const LinePolynomial& discriminant() const { return d_; }
  [[nodiscard]] const LinePolynomial& square() const { return q_; }
  [[nodiscard]] const LinePolynomial& square_root() const { return r_; }  // 32 bits of fraction
  [[nodiscard]] const LinePolynomial& light() const { return l_; }        // 28 bits of fraction
  [[nodiscard]] std::int32_t light_root() const { return m_; }            // of 2^30 parts

  static constexpr int light_fraction = 28;
  static constexpr int short_unit = 28;  // log2 of the unit of short_q_

 private:
  static constexpr int error_unit = 10;
  struct Errors {
    std::uint32_t light, square;  // of L; of |N|^2 in 2^error_unit
    std::uint64_t light_squared;
  };
  // 2^slope_shift d / 2 s, for s >= 2^slope_shift
  [[nodiscard, gnu::always_inline]] std::int32_t halved_ratio(std::int32_t d, std::int32_t s) const {
    // 1 / s = inverse 2^(zeros - 62): a division for 15 bits, Newton's step for 29
    const int zeros = std::countl_zero(static_cast<std::uint32_t>(s));
    const std::uint32_t top = static_cast<std::uint32_t>(s) << zeros;
    const std::uint32_t guess = ~0U / (top >> 16 | 1U << 15);
    const auto rest = static_cast<std::int32_t>((1U << 31) - high_product(top, guess << 15));
    const std::int32_t inverse =
        static_cast<std::int32_t>(guess << 14) + (static_cast<std::int32_t>(guess) * (rest >> 2) >> 15);
    return high_product(d, inverse) >> (31 - slope_shift_ - zeros);
  }
  [[nodiscard]] static Margin margin_of(const Errors& e, const Light& light, std::uint32_t square) {
    const std::uint64_t from_l = (magnitude(light.l) & 0xffffffffU) * (2 * e.light) + e.light_squared;
    const std::uint64_t from_n = (std::uint64_t{square} * e.square >> 32) + 1;
    // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
    return {e.light, static_cast<std::int64_t>(from_l + (from_n << error_unit)) + (light.n2 >> 32) + 4};
  }
  void load(const RootSurface& f, int light_bits, std::int32_t x, std::int32_t y);
  void prepare_slopes();
  void prepare_errors();
  [[nodiscard]] Errors errors_for(std::int64_t root_error) const;

  std::int32_t middle_, half_;
  int half_bits_, tau_shift_;
  LinePolynomial d_, q_, r_, l_;
  std::int32_t m_ = 0;
  int slope_shift_ = 0;                // d_slope_ in 2^slope_shift
  ShortPolynomial d_slope_, q_slope_;  // of the latter a unit is 2^28
  ShortPolynomial short_q_, short_r_, short_l_;
  std::int32_t r_slope_ = 0, l_slope_ = 0;
  std::int32_t deep_from_ = 0;                      // from this s on its error is 6
  std::int32_t sloped_from_ = 0, steady_from_ = 0;  // see slope()
  std::uint32_t bend_ = 0;                          // see straight()
  bool dark_ = false;
  Errors errors_[2] = {};  // at a limb, and elsewhere
  Margin quick_margin_;
};

}  // namespace halfspace
