// real.hpp - the flattener's number: 113-bit binary floating point whose results are the same on every host.
// Rounding  +, -, *, / are IEEE binary128 in software, sqrt is correctly rounded towards zero, decimals and
//           sines come from MPFR. No libm, no contraction, no vector width: the same text gives the same bits.
// Range     10^-4900 .. 10^4900. What leaves it becomes infinite or nan, which `finite` finds.
#pragma once

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

namespace halfspace {

#if defined(__SIZEOF_FLOAT128__)
using Real = __float128;
#else
using Real = long double;
static_assert(std::numeric_limits<long double>::digits == 113, "the host has no IEEE binary128");
#endif

// IEEE binary128 as two words: comparisons with 0 need no software.
using RealWords = std::array<std::uint64_t, 2>;
static_assert(std::endian::native == std::endian::little && sizeof(Real) == sizeof(RealWords));
inline bool has_sign(Real v) { return std::bit_cast<RealWords>(v)[1] >> 63 != 0; }
inline bool is_zero(Real v) {
  const auto words = std::bit_cast<RealWords>(v);
  return (words[1] << 1 | words[0]) == 0;
}
inline Real magnitude(Real v) { return has_sign(v) ? -v : v; }
inline Real larger(Real a, Real b) { return a < b ? b : a; }
inline Real smaller(Real a, Real b) { return b < a ? b : a; }
inline bool finite(Real v) { return v - v == 0; }

[[nodiscard]] Real power_of_two(int exponent);  // -16382 <= exponent <= 16383
[[nodiscard]] Real square_root(Real v);         // v >= 0 and finite
[[nodiscard]] Real decimal_to_real(const std::string& text);
[[nodiscard]] Real to_real(const mpz_class& v);
[[nodiscard]] mpz_class round_to_integer(Real v);  // finite; ties away from zero
[[nodiscard]] Real nearest_whole(Real v);          // the same as a Real
[[nodiscard]] inline Real floor_of(Real v) {
  const Real near = nearest_whole(v);
  return near > v ? near - 1 : near;
}
[[nodiscard]] double double_above(Real v);  // 0 <= v: a double that is not below v

struct SineCosine {
  Real sine, cosine;
};
// Of an angle in degrees, reduced as a decimal: multiples of 90 are exact.
[[nodiscard]] SineCosine sine_cosine_of_degrees(const std::string& text);

}  // namespace halfspace
