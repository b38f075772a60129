// isqrt.hpp - floor of the square root of an integer, by multiplications: neither a controller nor a workstation divides 64 bits
// gladly.
//
//   y = 1 / sqrt(f), f = n scaled to [1/4, 1)    8 bits from a table, then a Newton step y (3 - f y^2) / 2
//   s = f y                                      then twice s += (n - s^2) y / 2
//
// Proof   Parts by which y and s are off: the table 1/200 (half its step of f, 1/258 at 1/4, and half a unit of y); after the step
//         3/2 of its square and two last bits, < 2^-14. So s, n scaled to [2^62, 2^64), is off by less than 2^18 units. A correction
//         leaves less than 2^-14 (of y) + 2^-15 (of 2 sqrt(n) for sqrt(n) + s) of that, and takes its last bit: 25 units, then
//         -1.01 .. 0.01. One comparison is left.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace halfspace {

// 256 (1 / sqrt(f) - 1) to the nearest, for f in the middle of i / 256 .. (i + 1) / 256, i = 64 .. 255.
inline constexpr std::array<std::uint8_t, 192> inverse_root_table = [] {
  std::array<std::uint8_t, 192> table{};
  for (std::int32_t i = 64; i < 256; ++i) {
    std::int32_t y = 256;
    while ((2 * y + 1) * (2 * y + 1) < (1 << 27) / (2 * i + 1)) ++y;
    table[static_cast<std::size_t>(i - 64)] = static_cast<std::uint8_t>(y - 256);
  }
  return table;
}();

// floor(sqrt(n)) for any 64-bit n. Cost: nine products.
constexpr std::uint32_t isqrt(std::uint64_t n) {
  if (n == 0) return 0;
  const int half = std::countl_zero(n) / 2;
  n <<= 2 * half;
  const std::uint64_t f = n >> 32;
  const std::uint64_t coarse = 256U + inverse_root_table[(f >> 24) - 64];
  const auto y = static_cast<std::int64_t>(coarse * ((3U << 16) - (f * coarse * coarse >> 32)) >> 9);  // 2^16 / sqrt(f)
  std::uint64_t s = f * static_cast<std::uint64_t>(y) >> 16;
  // A rest is a difference of numbers near each other: right as a signed number though its terms wrap.
  const auto rest = [&] { return static_cast<std::int64_t>(n - s * s); };
  s += static_cast<std::uint64_t>((rest() >> 8) * y >> 41);
  s += static_cast<std::uint64_t>(rest() * y >> 49);
  const std::int64_t left = rest();  // 0 .. 2 s: s is the floor
  if (left < 0) --s;
  if (left > static_cast<std::int64_t>(2 * s)) ++s;
  return static_cast<std::uint32_t>(s >> half);
}

static_assert(isqrt(0) == 0 && isqrt(1) == 1 && isqrt(3) == 1 && isqrt(4) == 2);
static_assert(isqrt(0xffffffffffffffffULL) == 0xffffffffU && isqrt(0xfffffffe00000000ULL) == 0xfffffffeU);

}  // namespace halfspace
