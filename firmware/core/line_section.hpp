// line_section.hpp - one scan line of a root face: what light and normal are at any dot of it, by products instead of steps.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  t counts dots from the middle of the face's block (section_forms.hpp).
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/level_search.hpp"
#include "firmware/core/quick_root.hpp"
#include "firmware/core/section_forms.hpp"

namespace halfspace {

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

class LineSection {
 public:
  // Line y of the block; `forms` outlive the section.
  LineSection(const SectionForms& forms, std::int32_t y);

  [[nodiscard]] std::int32_t middle() const { return forms_.middle; }
  [[nodiscard]] int half_bits() const { return half_bits_; }

  [[nodiscard]] LitDot dot(std::int32_t t) const {
    LitDot dot;
    dot.t = t;
    dot.s = root(t);
    dot.r = static_cast<std::int32_t>(r_.linear(t) >> 32);
    dot.light.l = (l_.linear(t) >> SectionForms::light_fraction) + (std::int64_t{forms_.m} * dot.s >> 30);
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
    dot.light.l = short_l_.linear(tau) + static_cast<std::int32_t>(std::int64_t{forms_.m} * dot.s >> 30);
    dot.light.n2 =
        std::max<std::int64_t>(std::int64_t{short_q_.at(tau)} * (1 << short_unit) + std::int64_t{dot.r} * dot.s, 0);
    return dot;
  }
  // What s may be off by at a dot.
  [[nodiscard]] std::int32_t root_error(std::int32_t s) const { return errors(s).root; }
  [[nodiscard]] SectionErrors quick_errors(const LitDot& dot) const {
    const SectionErrors& e = errors(dot.s);
    return {e.root, e.light + short_light_error, e.square + short_square_error};
  }
  // Of dot(): of L, and of L^2 - square |N|^2 / 2^32.
  [[nodiscard]] Margin margin(const LitDot& dot, std::uint32_t square) const {
    const SectionErrors& e = errors(dot.s);
    const auto light = static_cast<std::uint64_t>(e.light);
    const std::uint64_t from_l = (magnitude(dot.light.l) & 0xffffffffU) * (2 * light) + light * light;
    const std::uint64_t from_n = (std::uint64_t{square} * static_cast<std::uint32_t>(e.square) >> 32) + 1;
    // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
    return {e.light, static_cast<std::int64_t>(from_l + (from_n << 16)) + (dot.light.n2 >> 32) + 4};
  }

  [[nodiscard]] const LinePolynomial& discriminant() const { return d_; }
  [[nodiscard]] const LinePolynomial& square() const { return q_; }
  [[nodiscard]] const LinePolynomial& square_root() const { return r_; }  // 32 bits of fraction
  [[nodiscard]] const LinePolynomial& light() const { return l_; }        // 28 bits of fraction
  [[nodiscard]] std::int32_t light_root() const { return forms_.m; }      // of 2^30 parts

  static constexpr int short_unit = 28;  // log2 of the unit of short_q_

 private:
  // What is short adds 16 units to l, 16 s to r s and 40 2^short_unit to q: the last two less than 2^35.
  static constexpr std::int32_t short_light_error = 16, short_square_error = 1 << 19;

  [[nodiscard]] const SectionErrors& errors(std::int32_t s) const {
    return forms_.errors[s >= forms_.deep_from ? 1 : 0];
  }

  const SectionForms& forms_;
  int half_bits_, tau_shift_;
  LinePolynomial d_, q_, r_, l_;
  ShortPolynomial short_q_, short_r_, short_l_;
};

}  // namespace halfspace
