// interval.hpp - doubles with outward rounding: every result contains the exact one.
// An IEEE operation errs by at most half a unit in the last place, or half the least denormal; `outward` adds more than both.
// Nothing here depends on a libm: +, -, *, / and sqrt are correctly rounded everywhere, ldexp and abs are exact.
// Ranges  Products need factors below 2^300, so that nothing overflows and no NaN arises; sums and quotients may be infinite.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/algebra/truncated.hpp"

namespace halfspace {

struct Interval {
  double low = 0, high = 0;

  [[nodiscard]] bool positive() const { return low > 0; }
  [[nodiscard]] bool negative() const { return high < 0; }
  [[nodiscard]] bool may_vanish() const { return !positive() && !negative(); }
  [[nodiscard]] bool is_zero() const { return low == 0 && high == 0; }
};

[[nodiscard]] inline Interval outward(double low, double high) {
  const auto margin = [](double v) { return std::abs(v) * 0x1p-51 + 0x1p-1070; };
  return {low - margin(low), high + margin(high)};
}

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) { return outward(a.low + b.low, a.high + b.high); }
inline Interval operator-(const Interval& a, const Interval& b) { return outward(a.low - b.high, a.high - b.low); }
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double r = a.high * b.low;
  const double s = a.high * b.high;
  return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

// b is positive.
inline Interval operator/(const Interval& a, const Interval& b) {
  return outward(a.low / (a.low < 0 ? b.low : b.high), a.high / (a.high < 0 ? b.high : b.low));
}

[[nodiscard]] inline Interval squared(const Interval& a) {
  const double size = std::max(std::abs(a.low), std::abs(a.high));
  const double least = a.may_vanish() ? 0 : std::min(std::abs(a.low), std::abs(a.high));
  const Interval square = outward(least * least, size * size);
  return {std::max(square.low, 0.0), square.high};
}

// Of the part that is not negative.
[[nodiscard]] inline Interval square_root(const Interval& a) {
  const Interval root = outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
  return {std::max(root.low, 0.0), root.high};
}

// value / 2^exponent; a quotient of 2^900 or more is only bounded by infinity.
[[nodiscard]] inline Interval enclosure(const mpz_class& value, long exponent) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (sgn(value) == 0) return {};
  if (mpz_size(value.get_mpz_t()) <= 14 && exponent >= 0 && exponent <= 900) {  // no shorter than 2^-900
    const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
    const double scaled = truncated(value) * unit;
    return outward(scaled, scaled);
  }
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, value.get_mpz_t());  // truncated: off by less than one unit
  const long shift = std::max(own - exponent, -4000L);
  if (shift > 900) return {-infinity, infinity};
  const double scaled = std::ldexp(mantissa, static_cast<int>(shift));
  return outward(scaled, scaled);
}

}  // namespace halfspace
