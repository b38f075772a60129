// level_chord.hpp - where between two dots of a scan line a level begins or ends, from what is known at the two dots alone.
//   Level k is reached where F = L - T |N| >= 0, T its bar. Let dots a and b be h apart, u go from 0 to 1 between them, and write
//   d for a difference b - a. What is of second degree leaves its chord by u (1-u) times a second difference:
//     s     = (1-u) s_a + u s_b + u (1-u) E       E = (ds^2 - D2 h^2) / (s + the chord of s)
//     |N|^2 = A^2 - u (1-u) J                     J = q2 h^2 + dr ds - dn^2 - r E,   A = (1-u) n_a + u n_b,   n = |N|
//     F     = (1-u) F_a + u F_b + u (1-u) B       B = m E + T J / 2A, to first order in J / A^2
//   These are identities: no derivative need be bounded. E and J / 2A hardly change, and those of the middle make a quadratic of F:
//     u = u0 + kappa u (1-u),   u0 = F_a / (F_a - F_b),   kappa = B / (F_a - F_b)
// Error   What taking the middle leaves out of F: level_chord.cpp.
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

  LevelDot() = default;
  // `bar_error` of T in 2^-30.
  LevelDot(const LineSection& line, std::int32_t at, std::int32_t bar_error);
  // F; the bar has 32 bits of fraction.
  [[nodiscard]] std::int32_t above(std::uint32_t bar) const {
    return l - static_cast<std::int32_t>(high_product(bar, static_cast<std::uint32_t>(n)));
  }
};

// In dots right of the chord's left end, 16 bits of fraction; `error` is LevelPlace::unknown where nothing is known.
struct LevelPlace {
  std::int32_t at, error;
  static constexpr std::int32_t unknown = std::int32_t{1} << 30;
};

class LevelChord {
 public:
  LevelChord(const LineSection& line, const LevelDot& a, const LevelDot& b);

  // Whether F is surely above 0 all along, given its values at the ends; or, by `sign` -1, below. It leaves its chord by a quarter of
  // the bow at most.
  [[nodiscard]] bool keeps_sign(int sign, std::uint32_t bar, std::int32_t at_a, std::int32_t at_b) const {
    const std::int64_t inward = -std::int64_t{sign} * bow(bar) / 4;
    return error_ != LevelPlace::unknown &&
           std::min<std::int64_t>(std::int64_t{sign} * at_a, std::int64_t{sign} * at_b) >
               error_ + 1 + std::max<std::int64_t>(inward, 0);
  }

  // Where F is 0, given its values at the ends, of different signs but for their errors.
  //   The smaller root of the quadratic is u = 2 u0 / (1 - kappa + q), q^2 = (1 - kappa)^2 + 4 kappa u0, and F's slope there q times
  //   that of its chord. Where F is off by P, with e = P / |F_a - F_b| q <= 1/32 the root is off by less than 5/4 e: so far from it
  //   the quadratic is worth 5/4 P (1 - 5/4 |kappa| e / q) at least, and |kappa| <= 1/2 <= q.
  [[nodiscard, gnu::always_inline]] LevelPlace place(std::uint32_t bar, std::int32_t at_a, std::int32_t at_b) const {
    const bool falls = at_a > at_b;
    const auto from = static_cast<std::uint32_t>(std::max<std::int32_t>(falls ? at_a : -at_a, 0));
    const std::uint32_t all = from + static_cast<std::uint32_t>(std::max<std::int32_t>(falls ? -at_b : at_b, 0));
    const auto most = static_cast<std::int32_t>((all >> 1) - (all >> 6));
    const std::int32_t b = bow(bar);
    if (all < least || b > most || -b > most || error_ > static_cast<std::int32_t>(all >> 5)) {
      return {0, LevelPlace::unknown};
    }
    const int shift = 16 - std::countl_zero(all);
    const auto inverse = static_cast<std::int32_t>(0x7fffffffU / (all >> shift));  // 2^31 / the leading 16 bits
    const std::uint32_t u0 = (from >> shift) * static_cast<std::uint32_t>(inverse) >> 15;
    const std::int32_t kappa = ((falls ? b : -b) >> shift) * inverse >> 16;
    const auto rest = static_cast<std::uint32_t>((1 << 15) - kappa);
    const std::uint32_t square = rest * rest + static_cast<std::uint32_t>(kappa) * u0 * 2;  // 2^28 at least
    const std::uint32_t guess = first_roots[square >> 24];
    const std::uint32_t q = (guess + square / guess) >> 1;
    const auto u = static_cast<std::int32_t>((u0 << 15) / ((rest + q) >> 1));
    const std::uint32_t e = static_cast<std::uint32_t>((error_ >> shift) * inverse >> 15) + 4;
    const auto left = static_cast<std::int32_t>((e * 5 << 13) / q) + rounding;
    return {width_ * u, left > 1 << 11 ? LevelPlace::unknown : width_ * left};
  }

 private:
  [[nodiscard]] std::int32_t bow(std::uint32_t bar) const {
    return bow_ + high_product(normal_bow_, static_cast<std::int32_t>(bar >> 1));
  }

  static constexpr std::uint32_t least = 1 << 17;
  // Of u, 2^-16, where 1 / q <= 2: 12 of u0, 3 of kappa, 8 of q and its sum, 1 of the quotient, 4 of e's.
  static constexpr std::int32_t rounding = 28;

  std::int32_t width_;                        // h
  std::int32_t bow_ = 0;                      // m E
  std::int32_t normal_bow_ = 0;               // J / A
  std::int32_t error_ = LevelPlace::unknown;  // of F on the whole chord
};

}  // namespace halfspace
