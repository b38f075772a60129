// line_section.hpp - one scan line of a root face: what light and normal are at any dot of it, in words of 32 bits.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  t counts dots from the middle of the face's block (section_forms.hpp).
// Errors  D and q are told to 41 units of 2^28 (SectionForms counts less than 1 of them), so s to root_error() below; with r off by
//         18 and s < 2^30, |r| < 2^28, that makes root_error + 72 + 41 + 5 units of 2^28 in |N|^2 (the last for what RootSurface
//         lost, and a shift), and |m| root_error + 22 in L.
// Depth   Where the forms are by z (section_forms.hpp), so are L and |N|^2; z takes 64 bits.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/quick_root.hpp"
#include "firmware/core/section_forms.hpp"

namespace halfspace {

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

// sqrt(v 2^28) for 0 < v < 2^31, to within 3: quick_root(), shorter.
[[gnu::always_inline]] inline std::int32_t short_root(std::int32_t v) {
  const int z = std::countl_zero(static_cast<std::uint32_t>(v)) & ~1;
  return root_of_leading(static_cast<std::uint32_t>(v) << z) >> (z / 2);
}

// One dot of the section.
struct ShortDot {
  std::int32_t s, z, r, l;                 // r the derivative of |N|^2 by s or z
  std::int32_t square;                     // |N|^2, in units of 2^28
  std::int32_t root_error;                 // of s
  std::int32_t light_error, square_error;  // of l and square
};

class LineSection {
 public:
  // One line of the block; both outlive the section.
  LineSection(const SectionForms& forms, const LineForms& line);

  [[nodiscard]] std::int32_t middle() const { return forms_.middle; }
  [[nodiscard]] std::int32_t tau(std::int32_t t) const { return t << tau_shift_; }  // of 2^31 parts

  // s alone. Where D is told to be 0 or less it is below 41 units, so that the root of one, 2^14, errs by less than root_error(0).
  [[nodiscard, gnu::always_inline]] std::int32_t root(std::int32_t t) const {
    return short_root(std::max<std::int32_t>(d_.at(tau(t)), 1));
  }
  // Off by the root's 3 and by 41 2^28 / s, or at most by the root of 41 2^28, 409 2^8; the rest is for cut quotients.
  [[nodiscard]] static std::int32_t root_error(std::int32_t s) {
    return (41 << 20) / std::max<std::int32_t>(s >> 8, 409) + 8;
  }
  [[nodiscard, gnu::always_inline]] ShortDot dot(std::int32_t t) const {
    if (by_depth()) return asked_depth_dot(t);
    return plain_dot(t);
  }
  // By s; by z.
  [[nodiscard, gnu::always_inline]] ShortDot plain_dot(std::int32_t t) const {
    ShortDot dot;
    dot.s = root(t);
    dot.r = r_.linear(tau(t));
    dot.l = l_.linear(tau(t)) + (high_product(forms_.m, dot.s << 1) << 1);
    dot.square = q_.at(tau(t)) + high_product(dot.r << 3, dot.s << 1);
    dot.root_error = root_error(dot.s);
    dot.light_error = dot.root_error * forms_.m_size + 22;
    dot.square_error = dot.root_error + 118;
    return dot;
  }

  // Whether a dot reaches a level, by its entry in LevelTable::squares: by L^2, T^2 |N|^2 in units of 2^56, without a root for |N|.
  [[nodiscard, gnu::always_inline]] Answer reaches(std::int32_t t, std::uint32_t square) const {
    const ShortDot at = dot(t);
    if (at.l <= at.light_error) return at.l < -at.light_error ? Answer::no : Answer::unsure;
    const auto l = static_cast<std::uint32_t>(at.l);
    const auto light_error = static_cast<std::uint32_t>(at.light_error);
    const auto normal = static_cast<std::uint32_t>(std::max<std::int32_t>(at.square, 0));
    const auto lead = static_cast<std::int64_t>(std::uint64_t{l} * l - (std::uint64_t{normal} * square >> 4));
    // The level's square is rounded, as is its product.
    const auto margin =
        static_cast<std::int64_t>(std::uint64_t{2 * l + light_error} * light_error +
                                  (std::uint64_t{static_cast<std::uint32_t>(at.square_error)} << 28) + normal);
    return lead > margin ? Answer::yes : lead < -margin ? Answer::no : Answer::unsure;
  }

  [[nodiscard]] const SectionForms& forms() const { return forms_; }
  [[nodiscard]] ShortDot depth_dot(std::int32_t t) const;
  [[nodiscard]] ShortDot asked_depth_dot(std::int32_t t) const;  // the same, out of line
  [[nodiscard]] bool by_depth() const { return forms_.by_depth; }
  [[nodiscard]] const LineDepth& depth() const { return on_line_.depth; }
  [[nodiscard]] const ShortPolynomial& d() const { return d_; }
  [[nodiscard]] const ShortPolynomial& q() const { return q_; }
  [[nodiscard]] const ShortPolynomial& r() const { return r_; }
  [[nodiscard]] const ShortPolynomial& l() const { return l_; }
  [[nodiscard]] int tau_shift() const { return tau_shift_; }

 private:
  const SectionForms& forms_;
  const LineForms& on_line_;
  int tau_shift_;
  ShortPolynomial d_, q_, r_, l_;
};

// Off by 41 in q and, with |z| < 2^29, by 36 for r and 4 for the square of z, by some floors, and by what z is. Where that is not known the
// errors are so large that nothing follows.
[[gnu::always_inline]] inline ShortDot LineSection::depth_dot(std::int32_t t) const {
  const DotDepth at = forms_.depth_at(on_line_.d, on_line_.depth, t);
  if (at.is_far()) return {at.s, 0, 0, 0, 0, at.root_error, 1 << 30, 1 << 26};
  const std::int32_t twice = at.z << 1;
  const std::int32_t half_rise = static_cast<std::int32_t>(std::int64_t{forms_.zz} * at.z >> 30);
  const std::int32_t r = r_.linear(tau(t));
  const std::int32_t l = l_.linear(tau(t)) + (high_product(forms_.m, twice) << 1);
  const std::int32_t square = q_.at(tau(t)) + static_cast<std::int32_t>(std::int64_t{r + half_rise} * at.z >> 28);
  const std::int32_t rise = r + 2 * half_rise;
  const std::int32_t steepness = (static_cast<std::int32_t>(magnitude(rise)) >> 28) + 1;
  return {at.s, at.z, rise, l, square, at.error, at.error * forms_.m_size + 22, at.error * steepness + 128};
}

}  // namespace halfspace
