// level_chord.hpp - where between two dots of a scan line a level begins or ends, from what is known at the two dots alone.
//   Level k is reached where F = L - T |N| >= 0, T its bar. Let dots a and b be h apart, u go from 0 to 1 between them, and write
//   d for a difference b - a. What is of second degree leaves its chord by u (1-u) times a second difference:
//     s     = (1-u) s_a + u s_b + u (1-u) E       E = (ds^2 - D2 h^2) / (s + the chord of s)
//     |N|^2 = A^2 - u (1-u) J                     J = q2 h^2 + dr ds - dn^2 - r E,   A = (1-u) n_a + u n_b,   n = |N|
//     F     = (1-u) F_a + u F_b + u (1-u) B       B = m E + T J / 2A, to first order in J / A^2
//   These are identities: no derivative need be bounded. E and J / 2A hardly change, and those of the middle give the root
//     u = u0 + p (1 + kappa (1 - 2 u0)),   u0 = F_a / (F_a - F_b),   kappa = B / (F_a - F_b),   p = kappa u0 (1-u0)
// Error   What taking the middle leaves out: level_chord.cpp. The series errs by kappa^3 / 12, for |kappa| <= 1/4.
// Source  Ours.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "firmware/core/line_section.hpp"

namespace halfspace {

// A dot as levels see it. |L|, n <= 2^30.
struct LevelDot {
  std::int32_t t, s, r;
  std::int32_t l, n;
  std::int32_t root_error, normal_error;  // of s and n
  std::int32_t error;                     // of F

  // `bar_error` of T in 2^-30.
  LevelDot(const LineSection& line, std::int32_t at, std::int32_t bar_error);
  // F; the bar has 32 bits of fraction.
  [[nodiscard]] std::int32_t above(std::uint32_t bar) const {
    return l - static_cast<std::int32_t>(high_product(bar, static_cast<std::uint32_t>(n)));
  }
};

// In dots right of the chord's left end, 16 bits of fraction.
struct LevelPlace {
  bool known;
  std::int32_t at, error;
};

class LevelChord {
 public:
  LevelChord(const LineSection& line, const LevelDot& a, const LevelDot& b);

  // Where F is 0, given its values at the ends, of different signs (but for their errors).
  [[nodiscard]] LevelPlace place(std::uint32_t bar, std::int32_t at_a, std::int32_t at_b) const {
    const bool falls = at_a > at_b;
    const auto from = static_cast<std::uint32_t>(std::max<std::int32_t>(falls ? at_a : -at_a, 0));
    const std::uint32_t all = from + static_cast<std::uint32_t>(std::max<std::int32_t>(falls ? -at_b : at_b, 0));
    if (all < least_) return {false, 0, 0};
    const int shift = 16 - std::countl_zero(all);
    const auto inverse = static_cast<std::int32_t>(0x7fffffffU / (all >> shift));  // 2^31 / the leading 16 bits
    const auto of_all = [&](std::int32_t v) { return (v >> shift) * inverse >> 15; };
    const std::int32_t bow = bow_ + static_cast<std::int32_t>(std::int64_t{normal_bow_} * bar >> 32);
    const auto quarter = static_cast<std::int32_t>(all >> 2);
    if (bow > quarter || bow < -quarter || error_ > quarter) return {false, 0, 0};
    const std::int32_t kappa = of_all(falls ? bow : -bow);
    const auto u = static_cast<std::int32_t>((from >> shift) * static_cast<std::uint32_t>(inverse) >> 15);
    const std::int32_t p = kappa * (u * ((1 << 16) - u) >> 16) >> 16;
    const std::int32_t step = p + (p * (kappa * ((1 << 15) - u) >> 15) >> 16);
    const std::int32_t series = (kappa * kappa >> 16) * (kappa < 0 ? -kappa : kappa) >> 19;
    return {true, width_ * (u + step), width_ * (of_all(error_) * 3 / 2 + series + rounding)};
  }

 private:
  // Of u, 2^-16: 2 each for the three cuts of its quotient, 2 for kappa's, 1 each for the products, 3 for the errors.
  static constexpr std::int32_t rounding = 16;

  std::int32_t width_;           // h
  std::uint32_t least_ = ~0U;    // of |F_a - F_b|; never: nothing is known
  std::int32_t bow_ = 0;         // m E
  std::int32_t normal_bow_ = 0;  // J / 2A
  std::int32_t error_ = 0;       // of F on the whole chord
};

}  // namespace halfspace
