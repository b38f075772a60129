// level_chord.hpp - where between two dots of a scan line a level begins or ends, from what is known at the two dots alone.
//   Level k is reached where F = L - T |N| >= 0, T its bar. Let dots a and b be h apart, u go from 0 to 1 between them, and write
//   d for a difference b - a. What is of second degree leaves its chord by u (1-u) times a second difference:
//     s     = (1-u) s_a + u s_b + u (1-u) E       E = (ds^2 - D2 h^2) / (s + the chord of s)
//     |N|^2 = A^2 - u (1-u) J                     J = q2 h^2 + dr ds - dn^2 - r E,   A = (1-u) n_a + u n_b,   n = |N|
//     F     = (1-u) F_a + u F_b + u (1-u) B       B = m E + T J / 2A, to first order in J / A^2
//   These are identities: no derivative need be bounded. E and J / 2A hardly change, and those of the middle make a quadratic of F:
//     u = u0 + kappa u (1-u),   u0 = F_a / (F_a - F_b),   kappa = B / (F_a - F_b)
// Depth   By z in place of s, with s = b + a z and (s + b) z = c, and r the derivative of |N|^2 by z:
//     E     = (2 b' h dz + a dz^2 - c2 h^2) / (s + chord of s)
//     J     = q2 h^2 + dr dz - zz dz^2 - dn^2 - r E - u (1-u) zz E^2
// Across  At a limb E does not stay what it is, but there x is a smooth function of s. So with u linear in s, and M the mean of D' between x and
//         its chord, G that of |N|^2 by x where s is kept:
//     x     = (1-u) x_a + u x_b + u (1-u) X       X = (D2 h^2 - ds^2) / M
//     J     = q2 h^2 + dr ds - dn^2 - X G         B = l' X + T J / 2A + ...
// Error   What taking the middle leaves out of F: level_chord.cpp.
// Source  Ours.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "firmware/core/line_section.hpp"

namespace halfspace {

// How far from 0 F is, or -F, at a dot: F / 2, as a bar has 31 bits of fraction.
struct Lead {
  std::int32_t l, n;
  [[nodiscard]] std::int32_t of(std::uint32_t bar) const { return l - high_product(static_cast<std::int32_t>(bar), n); }
};

// A dot as levels see it. |L|, n <= 2^30.
struct LevelDot {
  std::int32_t t, s, z, r;
  std::int32_t l, n;                      // L / 2, |N|
  std::int32_t root_error, normal_error;  // of s or z, and n
  std::int32_t error;                     // of F / 2

  LevelDot() = default;
  // `bar_error` of T in 2^-30.
  LevelDot(const LineSection& line, std::int32_t at, std::int32_t bar_error);
  // F / 2.
  [[nodiscard]] std::int32_t above(std::uint32_t bar) const { return Lead{l, n}.of(bar); }
  // By `sign` -1, of -F.
  [[nodiscard]] Lead lead(std::int32_t sign) const { return {sign * l, sign * n}; }

 private:
  void set(const ShortDot& dot, std::int32_t of_n, std::int32_t bar_error);
  void set_by_depth(const LineSection& line, std::int32_t bar_error);
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
  // the bow at most, and turns only where the bow is larger than what the ends differ by.
  [[nodiscard]] bool keeps_sign(int sign, std::uint32_t bar, std::int32_t at_a, std::int32_t at_b) const {
    const auto way = static_cast<std::int64_t>(magnitude(std::int64_t{at_b} - at_a));
    std::int64_t inward = -std::int64_t{sign} * bow(bar);
    inward = inward > way ? inward / 4 : 0;
    return error_ != LevelPlace::unknown &&
           std::min<std::int64_t>(std::int64_t{sign} * at_a, std::int64_t{sign} * at_b) >
               error_ + 1 + std::max<std::int64_t>(inward, 0);
  }

  // From here on the chord is that of -F.
  void mirror() {
    bow_ = -bow_;
    normal_bow_ = -normal_bow_;
  }
  // Where F is 0 on its way up, given its values at the ends: below 0 at the left one and above it at the right one, but for their errors.
  //   The smaller root of the quadratic is u = 2 u0 / (1 - kappa + q), q^2 = (1 - kappa)^2 + 4 kappa u0, and F's slope there q times
  //   that of its chord. Where F is off by P, with e = P / |F_a - F_b| q <= 1/32 the root is off by less than 5/4 e: so far from it
  //   the quadratic is worth 5/4 P (1 - 5/4 |kappa| e / q) at least, and |kappa| <= 1, q >= 1/2.
  [[nodiscard, gnu::always_inline]] LevelPlace place(std::uint32_t bar, std::int32_t at_a, std::int32_t at_b) const {
    const auto from = static_cast<std::uint32_t>(std::max<std::int32_t>(-at_a, 0));
    const std::uint32_t all = from + static_cast<std::uint32_t>(std::max<std::int32_t>(at_b, 0));
    const std::uint32_t most = all - (all >> 5);
    const std::int32_t b = -bow(bar);
    if (all < least_ || static_cast<std::uint32_t>(b) + most > 2 * most) return {0, LevelPlace::unknown};
    const int shift = 16 - std::countl_zero(all);
    const auto inverse = static_cast<std::int32_t>(0x7fffffffU / (all >> shift));  // 2^31 / the leading 16 bits
    const std::uint32_t u0 = (from >> shift) * static_cast<std::uint32_t>(inverse) >> 15;
    const std::int32_t kappa = (b >> shift) * inverse >> 16;
    const auto rest = static_cast<std::uint32_t>((1 << 15) - kappa);
    const std::uint32_t square = rest * rest + static_cast<std::uint32_t>(kappa) * u0 * 2;
    if (square < 1U << 28) return {0, LevelPlace::unknown};
    const std::uint32_t guess = first_roots[square >> 24];
    const std::uint32_t q = (guess + square / guess) >> 1;
    const auto u = static_cast<std::int32_t>((u0 << 15) / ((rest + q) >> 1));
    const auto left =
        static_cast<std::int32_t>((wide_error_ >> shift) * static_cast<std::uint32_t>(inverse) / q) + rounding;
    const std::int32_t bend = high_product(way_bow_, u * ((1 << 16) - u));
    return {width_ * u + bend, left > 1 << 11 ? LevelPlace::unknown : steepness_ * left + way_error_};
  }

 private:
  template <bool by_depth>
  void set(const LineSection& line, const LevelDot& a, const LevelDot& b);
  void set_by_depth(const LineSection& line, const LevelDot& a, const LevelDot& b);
  void set_across(const LineSection& line, const LevelDot& a, const LevelDot& b);

  [[nodiscard]] std::int32_t bow(std::uint32_t bar) const {
    return bow_ + high_product(normal_bow_, static_cast<std::int32_t>(bar));
  }

  // Of u, 2^-16, where 1 / q <= 2: 12 of u0, 4 of kappa, 8 of q and its sum, 1 of the quotient, 14 of e's.
  static constexpr std::int32_t rounding = 39;

 protected:
  // Of h dots; nothing is known yet.
  explicit LevelChord(std::int32_t width) : width_(width), steepness_(width) {}
  // What F / 2 errs by, once the bows are known.
  void keep(std::int32_t error);

  std::int32_t width_;           // h
  std::int32_t steepness_;       // of x in u, at most
  std::int32_t way_bow_ = 0;     // X, 16 bits of fraction; 0 where u is linear in x
  std::int32_t way_error_ = 0;   // of x, besides what u's makes
  std::int32_t bow_ = 0;         // m E / 2
  std::int32_t normal_bow_ = 0;  // J / A

 private:
  std::int32_t error_ = LevelPlace::unknown;  // of F / 2 on the whole chord
  std::uint32_t wide_error_ = 0;              // 5/4 of it
  std::uint32_t least_ = ~0U;                 // |F_a - F_b| that makes e small enough, and rounding too
};

}  // namespace halfspace
