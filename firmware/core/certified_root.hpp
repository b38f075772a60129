// certified_root.hpp - sqrt(d) and its reciprocal by a table and Newton's steps: products only, no division.
// Exact   The remainder d - s^2 is formed and held against root_bound s, which proves |s - sqrt(d)| <= root_bound for each root
//         given; what fails (never seen but for s near 0) is taken by isqrt.
// Cost    Some forty instructions of a Cortex-M3, five long products among them; the table takes 384 bytes.
// Source  Newton's iteration for y = 1 / sqrt(d), y += y (1 - d y^2) / 2, without a division.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "firmware/core/isqrt.hpp"

namespace halfspace {

inline constexpr std::int64_t root_bound = 4;

// 1 / s is about inverse 2^(shift - 62).
struct Root {
  std::uint32_t s = 0;
  std::uint32_t inverse = 0;
  int shift = 31;
};

constexpr std::uint32_t high_product(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32);
}
constexpr std::int32_t high_product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(std::int64_t{a} * b >> 32);
}

// 2^19 / sqrt(i + 64.5), the reciprocal root in the middle of each interval of the leading byte 64 + i.
constexpr std::array<std::uint16_t, 192> make_reciprocal_roots() {
  std::array<std::uint16_t, 192> table{};
  for (std::uint64_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<std::uint16_t>(isqrt((std::uint64_t{1} << 39) / (2 * i + 129)));
  }
  return table;
}
inline constexpr std::array<std::uint16_t, 192> reciprocal_roots = make_reciprocal_roots();

// Of 0 <= d < 2^62.
inline Root certified_root(std::uint64_t d) {
  if (d == 0) return {};
  const int shift = std::countl_zero(d) / 2;
  const std::uint64_t v = d << (2 * shift);  // 2^62 <= v
  const auto top = static_cast<std::uint32_t>(v >> 32);
  const std::uint32_t y0 = reciprocal_roots[(top >> 24) - 64];  // 2^-47 of 1 / sqrt(v), to 2^-8
  const auto rest = static_cast<std::int32_t>((1U << 30) - high_product(top, y0 * y0));
  const std::uint32_t y1 = (y0 << 15) + static_cast<std::uint32_t>(static_cast<std::int32_t>(y0) * (rest >> 9) >> 7);
  const std::uint32_t s1 = high_product(top, y1) << 2;  // both to 2^-15
  const auto gap = static_cast<std::int64_t>(v - std::uint64_t{s1} * s1);
  const std::int32_t correction =
      high_product(static_cast<std::int32_t>(gap >> 20), static_cast<std::int32_t>(y1)) >> 11;
  const auto signed_y = static_cast<std::int32_t>(y1);
  const std::uint32_t y =
      y1 + static_cast<std::uint32_t>(high_product(high_product(correction << 10, signed_y), signed_y) >> 8);
  Root root{(s1 + static_cast<std::uint32_t>(correction)) >> shift, y, shift};
  const auto remainder = static_cast<std::int64_t>(d - std::uint64_t{root.s} * root.s);
  const std::int64_t bound = root_bound * root.s;
  if (remainder > bound || remainder < -bound) root.s = isqrt(d);
  return root;
}

}  // namespace halfspace
