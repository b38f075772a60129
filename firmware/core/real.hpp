// real.hpp - a real number known to within an error: what filters and set-ups compute where 64-bit integers are too short.
//   value in [m - error, m + error] 2^e
// Exact   Every operation widens the error by what it may have lost, so a sign that is told is the sign. With 62 bits of m, a
//         short computation without cancellation is good to about 2^-58.
// Ranges  |m| < 2^62, 0 <= error < 2^32; exponents are not checked: numbers of 1152 bits leave 2^20 operations to go.
// Cost    On a Cortex-M3 a sum some 60 instructions, a product 90, a quotient or a root about 1,000.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "firmware/core/isqrt.hpp"
#include "firmware/core/wide.hpp"

namespace halfspace {

// floor(a b / 2^64)
constexpr std::uint64_t high_product(std::uint64_t a, std::uint64_t b) {
  if constexpr (limb_bits == 64) {
    return static_cast<std::uint64_t>((static_cast<DoubleLimb>(a) * b) >> 64);
  } else {
    const auto low = [](std::uint64_t v) { return v & 0xffffffffU; };
    const std::uint64_t middle = (a >> 32) * low(b) + (low(a) * low(b) >> 32);
    return (a >> 32) * (b >> 32) + (middle >> 32) + ((low(middle) + low(a) * (b >> 32)) >> 32);
  }
}

// floor(a 2^60 / b) for a < 2 b and b < 2^62
constexpr std::uint64_t quotient(std::uint64_t a, std::uint64_t b) {
  if constexpr (limb_bits == 64) {
    return static_cast<std::uint64_t>((static_cast<DoubleLimb>(a) << 60) / b);
  } else {
    std::uint64_t bits = 0;
    for (int bit = 0; bit <= 60; ++bit) {
      bits <<= 1;
      if (a >= b) {
        a -= b;
        bits |= 1;
      }
      a <<= 1;
    }
    return bits;
  }
}

class BoundedReal {
 public:
  constexpr BoundedReal() = default;
  constexpr BoundedReal(std::int64_t value)  // NOLINT(google-explicit-constructor): exact below 2^62
      : BoundedReal(normalised(value, 0, 0)) {}
  // value 2^exponent, the value known to within `error`.
  template <int Bits>
  constexpr BoundedReal(const Wide<Bits>& value, int exponent, std::int64_t error = 0) {
    const int shift = std::max(0, value.bit_length() - 61);
    const std::int64_t lost = shift > 0 ? 1 : 0;
    *this = normalised(scaled(value, shift), (error >> std::min(shift, 63)) + 2 * lost, exponent + shift);
  }

  // The sign where it is certain, else 0.
  [[nodiscard]] constexpr int sign() const { return m_ > error_ ? 1 : (m_ < -error_ ? -1 : 0); }
  // Exactly: it has no exponent to align to.
  [[nodiscard]] constexpr bool is_zero() const { return m_ == 0 && error_ == 0; }
  // Widened by as much as `other` can be, times 2^bits.
  [[nodiscard]] constexpr BoundedReal blurred(const BoundedReal& other, int bits) const {
    return other.is_zero() ? *this : *this + normalised(0, 1, other.bits() + bits);
  }
  [[nodiscard]] constexpr BoundedReal half() const { return BoundedReal(m_, error_, e_ - 1); }
  constexpr BoundedReal operator-() const { return BoundedReal(-m_, error_, e_); }

  friend constexpr BoundedReal operator+(const BoundedReal& a, const BoundedReal& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const bool swap = a.e_ < b.e_;
    const BoundedReal& high = swap ? b : a;
    const BoundedReal& low = swap ? a : b;
    const int shift = high.e_ - low.e_;
    const std::int64_t m = low.m_ >> std::min(shift, 63);
    const std::int64_t lost = shift > 0 ? 2 : 0;  // of m, and of the error
    return normalised(high.m_ + m, high.error_ + (low.error_ >> std::min(shift, 63)) + lost, high.e_);
  }
  friend constexpr BoundedReal operator-(const BoundedReal& a, const BoundedReal& b) { return a + -b; }

  // The product's error in units of 2^62 is |m_a| error_b + |m_b| error_a + error_a error_b, under error_a + error_b + 1.
  friend constexpr BoundedReal operator*(const BoundedReal& a, const BoundedReal& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const auto product = static_cast<std::int64_t>(high_product(magnitude(a.m_) << 1, magnitude(b.m_) << 1));
    return normalised((a.m_ < 0) != (b.m_ < 0) ? -product : product, a.error_ + b.error_ + 2, a.e_ + b.e_ + 62);
  }

  // With |m_b| >= 2^61 the quotient is below 2, so it is off by less than (error_a + 2 error_b) 2^60 / (2^61 - 2^32) + 1.
  friend constexpr BoundedReal operator/(const BoundedReal& a, const BoundedReal& b) {
    const std::uint64_t divisor = magnitude(b.m_);
    if (divisor >> 61 == 0) return unknown();
    if (a.is_zero()) return {};
    const auto m = static_cast<std::int64_t>(quotient(magnitude(a.m_), divisor));
    return normalised((a.m_ < 0) != (b.m_ < 0) ? -m : m, a.error_ + 2 * b.error_ + 2, a.e_ - b.e_ - 60);
  }

  // v = m 2^0 or 2^1 below 2^62; with r = floor(sqrt(v)) >= 2^30 and rest = v - r^2 <= 2 r the root of v 2^62 is
  // r 2^31 + rest 2^30 / r, less at most (2^31)^2 / 2^62 = 1. The error of v counts 2^62 / (2 sqrt(v) 2^31) <= 1 times.
  [[nodiscard]] constexpr BoundedReal root() const {
    if (m_ >> 60 == 0 || m_ < 0) return is_zero() ? BoundedReal() : unknown();
    const bool odd = (e_ & 1) != 0;
    const std::int64_t v = odd ? m_ >> 1 : m_;
    const std::int64_t r = isqrt(static_cast<std::uint64_t>(v));
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): r >= 2^29, as v >= 2^59
    const std::int64_t s = (r << 31) + ((v - r * r) << 30) / r;
    return normalised(s, error_ + 4, (e_ + (odd ? 1 : 0) - 62) / 2);
  }

  // floor(value 2^bits) to within `error_of(bits)`; modulo 2^64 where the value is not below 2^(62 - bits).
  [[nodiscard]] constexpr std::int64_t fixed(int bits) const {
    const int shift = e_ + bits;
    return shift >= 0 ? m_ << std::min(shift, 62) : m_ >> std::min(-shift, 63);
  }
  [[nodiscard]] constexpr std::int64_t error_of(int bits) const {
    const int shift = e_ + bits;
    return shift >= 0 ? shifted_up(error_, shift) : (error_ >> std::min(-shift, 63)) + 2;
  }
  // The least b with |value| < 2^b.
  [[nodiscard]] constexpr int bits() const {
    return e_ + static_cast<int>(std::bit_width(magnitude(m_) + static_cast<std::uint64_t>(error_)));
  }

 private:
  constexpr BoundedReal(std::int64_t m, std::int64_t error, int e) : m_(m), error_(error), e_(e) {}
  static constexpr BoundedReal unknown() { return BoundedReal(0, most_error, 1 << 20); }
  static constexpr std::uint64_t magnitude(std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); }
  static constexpr std::int64_t shifted_up(std::int64_t error, int shift) {
    return error == 0 ? 0 : (shift > 30 ? most_error << 29 : std::min(error, most_error) << shift);
  }
  // To 62 bits, as far as the error stays below 2^32. |m| < 2^63, error < 2^62.
  static constexpr BoundedReal normalised(std::int64_t m, std::int64_t error, int e) {
    const int m_bits = static_cast<int>(std::bit_width(magnitude(m)));
    const int error_bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(error)));
    if (m == 0 && error == 0) return {};
    const int down = std::max({0, m_bits - 62, error_bits - 31});
    if (down > 0) return BoundedReal(m >> down, (error >> down) + 2, e + down);
    const int up = error == 0 ? 62 - m_bits : std::min(62 - m_bits, std::max(0, 31 - error_bits));
    return BoundedReal(m * (std::int64_t{1} << up), error << up, e - up);
  }
  static constexpr std::int64_t most_error = std::int64_t{1} << 31;

  std::int64_t m_ = 0, error_ = 0;
  int e_ = 0;
};

}  // namespace halfspace
