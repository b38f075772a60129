// radical_sign.hpp - the sign of p + r sqrt(d): the one predicate of edges, depths and levels.
// Exact   Where p and r sqrt(d) differ in sign, p^2 is held against r^2 d: by their leading bits, and where these do not tell, as
//         whole products.
// Ranges  d >= 0; Product bits hold p^2 and r^2 d, sign included: three times the width of p, r and d always does.
// Cost    As a rule three 32-bit products; a tie, or what comes within 2^-25 of one, takes the whole ones.
// Stack   A number of 1152 bits takes 144 bytes, so each stage is a frame of its own: never inlined.
#pragma once

#include <cstdint>

#include "firmware/core/wide.hpp"

namespace halfspace {

// The leading bits of a number that is not 0: its magnitude lies in [m, m + 1) 2^e, and m >= 2^31.
struct Mantissa {
  std::uint32_t m;
  int e;
};

template <int Bits>
[[gnu::noinline]] constexpr Mantissa mantissa_of(const Wide<Bits>& value) {
  const Wide<Bits> magnitude = value.magnitude();
  const int e = magnitude.bit_length() - 32;
  return {static_cast<std::uint32_t>(scaled(magnitude, e)), e};
}

// The sign of p^2 - r^2 d where leading bits tell it, else 0.
constexpr int compare_leading(const Mantissa& p, const Mantissa& r, const Mantissa& d) {
  // In units of 2^(2 e_p):               a <= p^2   < a + 2^33    as (m + 1)^2 - m^2 < 2^33
  // in units of 2^(2 e_r + 32):         r2 <= r^2   < r2 + 3      by the same and the bits cut off
  // in units of 2^(2 e_r + 32 + e_d):    b <= r^2 d < b + 2^34    as (r2 + 3)(m + 1) - r2 m = r2 + 3 m + 3
  const std::uint64_t a = std::uint64_t{p.m} * p.m;         // 2^62 <= a < 2^64
  const std::uint64_t r2 = std::uint64_t{r.m} * r.m >> 32;  // 2^30 <= r2 < 2^32
  const std::uint64_t b = r2 * d.m;                         // 2^61 <= b < 2^64
  const int shift = 2 * p.e - (2 * r.e + 32 + d.e);         // a 2^shift against b
  if (shift >= 3) return 1;                                 // over 2^65, which b and its error do not reach
  if (shift <= -4) return -1;
  const std::uint64_t left = shift < 0 ? a >> -shift : a;
  const std::uint64_t right = shift > 0 ? b >> shift : b;
  constexpr std::uint64_t margin = std::uint64_t{1} << 35;  // over 2^34 and the bit that a shift may lose
  if (left > right) return left - right > margin ? 1 : 0;
  return right - left > margin ? -1 : 0;
}

// The sign of p^2 - r^2 d.
template <int Product, int Bits>
[[gnu::noinline]] constexpr int compare_products(const Wide<Bits>& p, const Wide<Bits>& r, const Wide<Bits>& d) {
  Wide<Product> square = Wide<Product>(r) * Wide<Product>(r);
  square = square * Wide<Product>(d);
  Wide<Product> difference = Wide<Product>(p) * Wide<Product>(p);
  difference -= square;
  return difference.sign();
}

template <int Product, int Bits>
constexpr int sign_of_radical(const Wide<Bits>& p, const Wide<Bits>& r, const Wide<Bits>& d) {
  const int sp = p.sign();
  const int sr = d.is_zero() ? 0 : r.sign();
  if (sp == 0 || sr == 0 || sp == sr) return sp != 0 ? sp : sr;
  const int leading = compare_leading(mantissa_of(p), mantissa_of(r), mantissa_of(d));
  return sp * (leading != 0 ? leading : compare_products<Product>(p, r, d));
}

static_assert(sign_of_radical<384>(Wide<128>(-7), Wide<128>(5), Wide<128>(2)) > 0);  // 49 < 50
static_assert(sign_of_radical<384>(Wide<128>(-6), Wide<128>(3), Wide<128>(4)) == 0);
static_assert(sign_of_radical<384>(Wide<128>(8), Wide<128>(-9), Wide<128>(1)) < 0);

}  // namespace halfspace
