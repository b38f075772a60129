// quick_root.hpp - square roots of 60 bits to within 3 units, by a table and two divisions of 32 bits.
// Error   With h the leading 32 bits of v 2^z, 2^30 <= h < 2^32: the table's root is within 255 of sqrt(h) >= 2^15 (half a step
//         of h is 127, half a step of the table 128), so Newton's is high by less than 255^2 / 2^16 < 1 and, floors included,
//         r within 1. The last step, on 2^14 r, errs by 1/4, h by what it lacks of v by 1/4, the division by 1: 1.5; and the
//         shift back by 1. static_assert below; tests/core/root_test.cpp.
// Cost    Some 22 instructions on a Cortex-M3.
// Source  Newton; Hennessy and Patterson's initial approximation by table.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "firmware/core/isqrt.hpp"

namespace halfspace {

// table[i]: bits 15 .. 8 of the root of (i + 64.5) 2^24.
inline constexpr std::array<std::uint8_t, 192> quick_roots = [] {
  std::array<std::uint8_t, 192> table{};
  for (std::uint32_t i = 0; i < 192; ++i)
    table[i] = static_cast<std::uint8_t>(isqrt((2 * i + 129) * (1ULL << 23)) >> 8);
  return table;
}();

// 0 < v < 2^60. |result - sqrt(v)| <= 3.
[[gnu::always_inline]] constexpr std::int32_t quick_root(std::uint64_t v) {
  const auto upper = static_cast<std::uint32_t>(v >> 32);
  const int z = (upper != 0 ? std::countl_zero(upper) : 32 + std::countl_zero(static_cast<std::uint32_t>(v))) & ~1;
  const auto h = static_cast<std::uint32_t>(v << z >> 32);
  const std::uint32_t guess = quick_roots[(h >> 24) - 64] * 256U + 128;
  const std::uint32_t r = (guess + h / guess) >> 1;
  const auto rest = static_cast<std::int32_t>(h - r * r);
  const std::int32_t s = static_cast<std::int32_t>(r << 14) + rest * (1 << 13) / static_cast<std::int32_t>(r);
  return s >> (z / 2 - 2);
}

}  // namespace halfspace
