// root32.hpp - the square root of 64 bits by a table and two products of 32 bits: what a Cortex-M3 multiplies in one instruction.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace halfspace::mps2 {

constexpr std::uint32_t high_product(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
}

// floor(2^15 / sqrt(a)) in the middle of each 256th of [1/4, 1), a = (2 i + 129) / 512: the largest y with y^2 (2 i + 129) <= 2^39.
constexpr std::array<std::uint16_t, 192> make_root_table() {
  std::array<std::uint16_t, 192> table{};
  std::uint64_t y = 65535;
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    while (y * y * (2 * i + 129) > std::uint64_t{1} << 39) --y;
    table[i] = static_cast<std::uint16_t>(y);
  }
  return table;
}
inline constexpr auto root_table = make_root_table();

inline constexpr std::int64_t root32_error = 3;

// Within root32_error of sqrt(v), v > 0. With d = v 4^z in [2^62, 2^64): y0 is 1/sqrt(d) to 2^-7.9, Newton's step y1 to 2^-15.3
// and never above it, so s1 = d y1 never exceeds sqrt(d); the rest d - s1^2 corrects s1 to 2 units of 2^-32 of it.
constexpr std::uint32_t root32(std::uint64_t v) {
  const int z = std::countl_zero(v) / 2;
  const std::uint64_t d = v << (2 * z);
  const auto top = static_cast<std::uint32_t>(d >> 32);
  const std::uint32_t y0 = root_table[(top >> 24) - 64];
  const auto e = static_cast<std::int32_t>((1U << 30) - high_product(top, y0 * y0));
  const std::uint32_t y1 = (y0 << 15) + static_cast<std::uint32_t>((static_cast<std::int32_t>(y0) * (e >> 9)) >> 7);
  const std::uint32_t s1 = high_product(top, y1) << 2;
  const auto rest = static_cast<std::int64_t>(d - static_cast<std::uint64_t>(s1) * s1);  // below 2^49
  const std::int64_t step = (rest >> 20) * static_cast<std::int32_t>(y1) >> 43;
  return (s1 + static_cast<std::uint32_t>(step)) >> z;
}

constexpr bool is_near_root(std::uint64_t v) {
  const auto s = static_cast<std::int64_t>(root32(v));
  const auto low = s > root32_error ? static_cast<std::uint64_t>(s - root32_error) : 0;
  const auto high = static_cast<std::uint64_t>(s + root32_error);
  return low * low <= v && (high > 0xffffffffU || v <= high * high);
}
static_assert([] {
  std::uint64_t v = 1;
  for (int i = 0; i < 4000; ++i) {
    if (!is_near_root(v) || !is_near_root(v >> (i % 60) | 1) || !is_near_root(~(v >> (i % 60)))) return false;
    v = v * 6364136223846793005U + 1442695040888963407U;
  }
  return is_near_root(~std::uint64_t{0}) && is_near_root(1) && is_near_root(std::uint64_t{1} << 62);
}());

}  // namespace halfspace::mps2
