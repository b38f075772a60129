// ball.hpp - a double and a bound of its error: the filter in front of the exact oracle.
//   true value within [v - e, v + e]; an overflow or a NaN makes every question "not known", never a wrong
//   answer.
// Whole   e == 0 means: v is a whole number, exactly. Sums and products of such stay so up to 2^53.
// Exact   Otherwise each operation adds the rounding of v (half an ulp, u |v|) and of e itself (slack: fewer than six
// roundings
//         of u each) to e, and `tiny` for results that underflow. Default rounding mode; nothing is switched.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace halfspace::oracle {

struct Ball {
  double v = 0;
  double e = 0;

  static constexpr double u = 0x1p-53;
  static constexpr double slack = 1 + 0x1p-50;
  static constexpr double tiny = std::numeric_limits<double>::min();

  static Ball unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  static Ball of(std::int64_t n) {
    const auto v = static_cast<double>(n);
    return {v, std::abs(v) <= 0x1p53 ? 0 : std::abs(v) * 0x1p-52};
  }

  static Ball of(const mpz_class& n) {
    const std::size_t bits = mpz_sizeinbase(n.get_mpz_t(), 2);
    if (bits > 1000) return unknown();
    const double v = n.get_d();
    return {v, bits <= 53 ? 0 : std::abs(v) * 0x1p-51};
  }

  // The sign, if the error leaves no doubt.
  [[nodiscard]] std::optional<int> sign() const {
    if (v > e) return 1;
    if (v < -e) return -1;
    if (v == 0 && e == 0) return 0;
    return std::nullopt;
  }

  [[nodiscard]] double lower() const { return v - (e + std::abs(v) * 4 * u) * slack; }
  [[nodiscard]] double upper() const { return v + (e + std::abs(v) * 4 * u) * slack; }

  static bool whole(const Ball& a, const Ball& b, double result) {
    return a.e == 0 && b.e == 0 && std::abs(result) <= 0x1p53;
  }

  Ball operator-() const { return {-v, e}; }

  friend Ball operator+(const Ball& a, const Ball& b) {
    const double value = a.v + b.v;
    if (whole(a, b, value)) return {value, 0};
    return {value, (a.e + b.e + std::abs(value) * u) * slack};
  }

  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }

  friend Ball operator*(const Ball& a, const Ball& b) {
    const double value = a.v * b.v;
    if (whole(a, b, value)) return {value, 0};
    return {value, (std::abs(a.v) * b.e + std::abs(b.v) * a.e + a.e * b.e + std::abs(value) * u + tiny) * slack};
  }

  // Unknown when b may be zero.
  friend Ball operator/(const Ball& a, const Ball& b) {
    const double room = std::abs(b.v) - b.e;
    if (!(room > 0)) return unknown();
    const double value = a.v / b.v;
    return {value, ((a.e + std::abs(value) * b.e) / room + std::abs(value) * u + tiny) * slack};
  }

  // Of the part of the ball that is not negative: the caller knows that the true value is not.
  friend Ball sqrt(const Ball& a) {
    if (a.v > a.e) {
      const double value = std::sqrt(a.v);
      return {value, (a.e / value + value * u) * slack};
    }
    const double half = std::sqrt((std::abs(a.v) + a.e) * slack) / 2 * slack;
    return {half, half};
  }
};

}  // namespace halfspace::oracle
