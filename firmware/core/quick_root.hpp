// quick_root.hpp - square roots of 60 bits by a table and two divisions of 32 bits, with proven errors.
//   r0  from a table of the leading byte i of h:  off by at most 2^22 / sqrt(h), half of what h may differ by
//   r   = floor((r0 + floor(h / r0)) / 2):        Newton's is high by the square of that over 2 r0; the floors take less than 1
//   s   = 2^14 r + floor(2^13 (h - r^2) / r):     high by 2^14 (r - sqrt(h))^2 / 2r, low by less than 1
// Error   h >= 2^28: r0 is within 256 of sqrt(h) >= 2^14, r from 1 below to 2 above, s within 2 + 1. h >= 2^30: r0 within 128
//         of 2^15, r from 1 below to 1/4 above, s within 1/4 + 1. What v has below h's last bit is 1/2 and 1/4 more.
// Cost    On a Cortex-M3, which divides in one instruction, 11 and 18 instructions.
// Source  Newton's iteration; tests/core/root_test.cpp.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "firmware/core/isqrt.hpp"

namespace halfspace {

// Of h from i 2^24 on, below (i + 1) 2^24.
inline constexpr std::array<std::uint16_t, 256> first_roots = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint64_t i = 16; i < 256; ++i) table[i] = static_cast<std::uint16_t>(isqrt((2 * i + 1) << 23));
  return table;
}();

// 2^14 sqrt(h) for h >= 2^28.
[[gnu::always_inline]] constexpr std::int32_t root_of_leading(std::uint32_t h) {
  const std::uint32_t guess = first_roots[h >> 24];
  const std::uint32_t r = (guess + h / guess) >> 1;
  const auto rest =
      static_cast<std::int32_t>(h - r * r);  // below 2^17.6: 2^44 / h of Newton's, 2 sqrt(h) of the floors
  return static_cast<std::int32_t>(r << 14) + rest * (1 << 13) / static_cast<std::int32_t>(r);
}

// sqrt(v) for 0 < v < 2^60, to within 3.
[[gnu::always_inline]] constexpr std::int32_t quick_root(std::uint64_t v) {
  const auto upper = static_cast<std::uint32_t>(v >> 32);
  const int z = (upper != 0 ? std::countl_zero(upper) : 32 + std::countl_zero(static_cast<std::uint32_t>(v))) & ~1;
  return root_of_leading(static_cast<std::uint32_t>(v << z >> 32)) >> (z / 2 - 2);
}

// sqrt(v) for 2^56 <= v < 2^60, to within 4.
[[gnu::always_inline]] constexpr std::int32_t quick_large_root(std::uint64_t v) {
  return root_of_leading(static_cast<std::uint32_t>(v >> 28));
}

}  // namespace halfspace
