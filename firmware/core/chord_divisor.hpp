// chord_divisor.hpp - quotients of a chord's second differences by the sum of what it has at its ends, without a division of 64 bits.
#pragma once

#include <bit>
#include <cstdint>

#include "firmware/core/line_section.hpp"

namespace halfspace {

// The least sum of two sizes, such as s_a + s_b or n_a + n_b, that is divided by.
inline constexpr std::uint32_t shortest = 1U << 22;

// Unsigned, so that a job that lies about its widths wraps and nothing worse.
constexpr std::uint32_t size(std::int32_t v) {
  return v < 0 ? 0 - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
}

// v <= sum / times, and sum >= shortest.
constexpr bool dwarfs(std::uint32_t sum, std::uint32_t v, std::uint32_t times) {
  return sum >= shortest && v <= sum / times;
}

// Division by a sum of two sizes, shortest <= sum < 2^31.
class Divisor {
 public:
  explicit Divisor(std::uint32_t sum)
      : sum_(sum), zeros_(std::countl_zero(sum)), inverse_(static_cast<std::int32_t>(~0U / (sum << zeros_ >> 16))) {}

  // Whether |v| is at most 1/32 of the sum's square, so that the quotient fits.
  [[nodiscard]] bool divides(std::int64_t v) const {
    const auto upper = static_cast<std::int32_t>(v >> 32);
    return size(upper) < high_product(sum_, sum_) >> 5;
  }
  // v / sum, to 2^-14 of itself and 3: by the upper half of v 2^zeros, which fits.
  [[nodiscard]] std::int32_t quotient(std::int64_t v) const {
    const auto bits = static_cast<std::uint64_t>(v);
    const auto upper = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 32) << zeros_ |
                                                 static_cast<std::uint32_t>(bits) >> (32 - zeros_));
    return static_cast<std::int32_t>(std::int64_t{upper} * inverse_ >> 16);
  }
  // a b / 8 sum, b < sum / 2.
  [[nodiscard]] std::uint32_t eighth_part(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t part = (b << zeros_ >> 16) * static_cast<std::uint32_t>(inverse_) >> 16;  // b / sum 2^16
    return static_cast<std::uint32_t>(std::uint64_t{a} * part >> 19);
  }

 private:
  std::uint32_t sum_;
  int zeros_;             // 1 .. 9
  std::int32_t inverse_;  // 2^48 / sum 2^zeros
};

}  // namespace halfspace
