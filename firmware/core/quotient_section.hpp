// quotient_section.hpp - one scan line of a face whose z is a quotient (quotient_forms.hpp): what light and normal are at any dot, in words
// of 32 bits, and where levels lie between two dots.
//   N_i and L are of second degree in t, which counts dots from the middle of the face's block.
// Ranges  |N_i| < 2^29, so that |N| < 2^30, and |L| < 2^30.
// Errors  A component is told to within 41 (ShortPolynomial's 40, less than 1 of the block's), so |N| to 41 sqrt(3) + 3 of the root.
// Chords  As in level_chord.hpp, with
//           L = (1-u) L_a + u L_b - u (1-u) l2 h^2                                               exactly
//           J = |dN|^2 - dn^2 + ((1-u) N_a + u N_b) . 2 N2 h^2 - u (1-u) |N2 h^2|^2              exactly
//         whose change along the chord is left out of F (quotient_section.cpp).
// Source  Ours.
#pragma once

#include <cstdint>

#include "firmware/core/level_chord.hpp"
#include "firmware/core/quotient_forms.hpp"

namespace halfspace {

class QuotientSection {
 public:
  // One line of the block; `forms` outlive the section.
  QuotientSection(const QuotientForms& forms, const QuotientLine& line);

  [[nodiscard]] std::int32_t middle() const { return forms_.middle; }
  [[nodiscard]] const QuotientForms& forms() const { return forms_; }

  static constexpr std::int32_t value_error = 41, normal_error = 75;

  struct Dot {
    std::int32_t n[3], l;
    std::uint64_t square;  // of N
  };
  [[nodiscard, gnu::always_inline]] Dot dot(std::int32_t t) const {
    const std::int32_t tau = t << tau_shift_;
    Dot at{{n_[0].at(tau), n_[1].at(tau), n_[2].at(tau)}, l_.at(tau), 0};
    for (const std::int32_t n : at.n) at.square += static_cast<std::uint64_t>(std::int64_t{n} * n);
    return at;
  }
  // Whether a dot reaches a level, by its entry in LevelTable::squares.
  [[nodiscard]] Answer reaches(std::int32_t t, std::uint32_t square) const;

  // h^2 in parts of 4^half_bits, at most 4: 29 bits of fraction. It gives what a chord of h dots is left by, N2 h^2 and l2 h^2.
  [[nodiscard]] std::int32_t part(std::int32_t h) const {
    const std::uint32_t of_block = static_cast<std::uint32_t>(h) << (tau_shift_ - 16);  // 15 bits of fraction
    return static_cast<std::int32_t>(of_block * of_block >> 1);
  }
  [[nodiscard]] std::int64_t normal_bend(int i, std::int32_t part) const { return bend(n_[i], part); }
  [[nodiscard]] std::int64_t light_bend(std::int32_t part) const { return bend(l_, part); }

 private:
  [[nodiscard]] static std::int64_t bend(const ShortPolynomial& p, std::int32_t part) {
    return std::int64_t{p.v2} * part >> 26;
  }

  const QuotientForms& forms_;
  int tau_shift_;
  ShortPolynomial n_[3], l_;
};

// A dot as levels see it. |L|, |N| <= 2^30.
struct QuotientDot {
  std::int32_t t;
  std::int32_t n_at[3];
  std::int32_t l, n;   // L / 2, |N|
  std::int32_t error;  // of F / 2

  QuotientDot() = default;
  // `bar_error` of T in 2^-30.
  QuotientDot(const QuotientSection& line, std::int32_t at, std::int32_t bar_error);
  // F / 2.
  [[nodiscard]] std::int32_t above(std::uint32_t bar) const { return Lead{l, n}.of(bar); }
  // By `sign` -1, of -F.
  [[nodiscard]] Lead lead(std::int32_t sign) const { return {sign * l, sign * n}; }
};

class QuotientChord : public LevelChord {
 public:
  QuotientChord(const QuotientSection& line, const QuotientDot& a, const QuotientDot& b);
};

}  // namespace halfspace
