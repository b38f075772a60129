// isqrt.hpp - floor of the square root of an integer, by integers.
#pragma once

#include <bit>
#include <cstdint>

namespace halfspace {

// floor(sqrt(n)) for any 64-bit n. Cost: a bit length and at most six Newton steps (one division each).
// Proof: started above the root, Newton's iterates fall strictly until the floor is reached.
constexpr std::uint32_t isqrt(std::uint64_t n) {
  if (n == 0) return 0;
  if (n >= 0xfffffffe00000001ULL) return 0xffffffffU;  // (2^32 - 1)^2 and above: the start below would be 2^32
  std::uint64_t s = std::uint64_t{1} << ((std::bit_width(n) + 1) / 2);
  for (;;) {
    const std::uint64_t t = (s + n / s) / 2;
    if (t >= s) return static_cast<std::uint32_t>(s);
    s = t;
  }
}

static_assert(isqrt(0) == 0 && isqrt(1) == 1 && isqrt(3) == 1 && isqrt(4) == 2);
static_assert(isqrt(0xffffffffffffffffULL) == 0xffffffffU && isqrt(0xfffffffe00000000ULL) == 0xfffffffeU);

}  // namespace halfspace
