// real.hpp - the flattener's number: 113-bit binary floating point whose results are the same on every host.
// Rounding  +, -, *, / are those of IEEE binary128, in software, sqrt is correctly rounded towards zero, decimals and
//           sines come from MPFR. No libm, no contraction, no vector width: the same text gives the same bits.
// Range     10^-4900 .. 10^4900. What leaves it becomes infinite or nan, which `finite` finds.
// Cost      Sums, products, quotients, roots and comparisons of normal numbers are done here, in integers, in less than half the compiler's or GMP's
//           time; what is 0, infinite, nan or beyond the normal range is left to the compiler.
#pragma once

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace halfspace {

#if defined(__SIZEOF_FLOAT128__)
using NativeReal = __float128;
#else
using NativeReal = long double;
static_assert(std::numeric_limits<long double>::digits == 113, "the host has no IEEE binary128");
#endif

__extension__ using Bits128 = unsigned __int128;

// Of 128 bits. Operators work on these, as compilers keep them in registers.
struct Words {
  std::uint64_t low = 0, high = 0;
};

class Real {
 public:
  constexpr Real() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr Real(Number v)  // NOLINT(google-explicit-constructor): numbers are Reals
      : words_(std::bit_cast<Words>(static_cast<NativeReal>(v))) {}
  static constexpr Real of(NativeReal v) { return of_words(std::bit_cast<Words>(v)); }
  static constexpr Real of_words(Words words) {
    Real result;
    result.words_ = words;
    return result;
  }
  static constexpr Real of_bits(Bits128 bits) {
    return of_words({static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64)});
  }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr explicit operator Number() const {
    if constexpr (std::is_same_v<Number, double>) {
      return nearest_double();
    } else {
      return static_cast<Number>(native());
    }
  }
  [[nodiscard]] constexpr NativeReal native() const { return std::bit_cast<NativeReal>(words_); }

  // 112 bits of fraction below 15 of exponent and the sign.
  [[nodiscard]] constexpr Words words() const { return words_; }
  [[nodiscard]] constexpr Bits128 bits() const { return Bits128{words_.high} << 64 | words_.low; }
  [[nodiscard]] constexpr Bits128 size_bits() const { return Bits128{words_.high & ~sign_bit} << 64 | words_.low; }
  [[nodiscard]] constexpr bool has_sign() const { return words_.high >> 63 != 0; }
  [[nodiscard]] constexpr bool is_zero() const { return (words_.high << 1 | words_.low) == 0; }
  [[nodiscard]] constexpr bool is_one() const { return words_.low == 0 && words_.high == std::uint64_t{0x3fff} << 48; }
  [[nodiscard]] constexpr int exponent_bits() const { return static_cast<int>(words_.high >> 48) & 0x7fff; }
  [[nodiscard]] constexpr bool is_nan() const {
    return exponent_bits() == 0x7fff && (words_.high << 16 | words_.low) != 0;
  }

  Real operator-() const { return of_words({words_.low, words_.high ^ sign_bit}); }
  friend Real operator+(Real a, Real b);
  friend Real operator-(Real a, Real b) { return a + -b; }
  friend Real operator*(Real a, Real b);
  friend Real operator/(Real a, Real b);
  Real& operator+=(Real b) { return *this = *this + b; }
  Real& operator-=(Real b) { return *this = *this - b; }
  Real& operator*=(Real b) { return *this = *this * b; }

  friend bool operator==(Real a, Real b) {
    const bool same = a.words_.low == b.words_.low && a.words_.high == b.words_.high;
    return (same && !a.is_nan()) || (a.is_zero() && b.is_zero());
  }
  friend bool operator<(Real a, Real b) { return a.rank() < b.rank() && !a.is_nan() && !b.is_nan(); }
  friend bool operator<=(Real a, Real b) { return a.rank() <= b.rank() && !a.is_nan() && !b.is_nan(); }
  friend bool operator>(Real a, Real b) { return b < a; }
  friend bool operator>=(Real a, Real b) { return b <= a; }

 private:
  // Ties to even.
  [[nodiscard]] constexpr double nearest_double() const {
    constexpr int bias_apart = 16383 - 1023;
    constexpr std::uint64_t half = std::uint64_t{1} << 63;
    const int exponent = exponent_bits() - bias_apart;
    if (exponent < 1 || exponent > 2046) return is_zero() ? 0 : static_cast<double>(native());
    const std::uint64_t fraction = (words_.high << 16 >> 12) | words_.low >> 60;
    const std::uint64_t up = words_.low << 4 > half - (fraction & 1U) ? 1 : 0;
    return std::bit_cast<double>((static_cast<std::uint64_t>(exponent) << 52 | fraction) + up + (words_.high & half));
  }

  __extension__ using Signed128 = __int128;
  // In the order of the values; 0 for both zeros.
  [[nodiscard]] Signed128 rank() const {
    const auto size = static_cast<Signed128>(size_bits());
    return has_sign() ? -size : size;
  }

  static constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

  Words words_;
};
static_assert(std::endian::native == std::endian::little && sizeof(Real) == 16);

inline bool has_sign(Real v) { return v.has_sign(); }
inline bool is_zero(Real v) { return v.is_zero(); }
inline Real magnitude(Real v) { return Real::of_bits(v.size_bits()); }
inline Real larger(Real a, Real b) { return a < b ? b : a; }
inline Real smaller(Real a, Real b) { return b < a ? b : a; }
inline bool finite(Real v) { return v.exponent_bits() != 0x7fff; }

[[nodiscard]] Real power_of_two(int exponent);                      // -16382 <= exponent <= 16383
[[nodiscard]] constexpr double double_power_of_two(int exponent) {  // -1022 <= exponent <= 1023
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}
// v 2^exponent, for which the same holds.
[[nodiscard]] inline Real times_power_of_two(Real v, int exponent) {
  const int biased = v.exponent_bits();
  const int moved = biased + exponent;
  if (biased < 1 || biased > 0x7ffe || moved < 1 || moved > 0x7ffe) return v * power_of_two(exponent);
  const auto [low, high] = v.words();
  return Real::of_words({low, high + (static_cast<std::uint64_t>(exponent) << 48)});
}
[[nodiscard]] Real square_root(Real v);  // v >= 0 and finite
[[nodiscard]] Real decimal_to_real(const std::string& text);
[[nodiscard]] Real to_real(const mpz_class& v);
[[nodiscard]] mpz_class round_to_integer(Real v);    // finite; ties away from zero
[[nodiscard]] Real nearest_whole(Real v);            // the same as a Real
[[nodiscard]] std::int64_t nearest_word(Real v);     // the same as a word; no less than -2^62, no more than 2^62
[[nodiscard]] double rounding_of(Real v, int bits);  // nearest_whole(w) - w for w = v 2^bits, to within 2^-53
[[nodiscard]] inline Real floor_of(Real v) {
  const Real near = nearest_whole(v);
  return near > v ? near - 1 : near;
}
[[nodiscard]] Bits128 whole_bits(Real v);                 // 0 <= v < 2^128, cut
[[nodiscard]] std::int64_t floor_within_62_bits(Real v);  // no less than -2^62, no more than 2^62
[[nodiscard]] double double_above(Real v);                // 0 <= v: a double that is not below v

struct SineCosine {
  Real sine, cosine;
};
// Of an angle in degrees, reduced as a decimal: multiples of 90 are exact.
[[nodiscard]] SineCosine sine_cosine_of_degrees(const std::string& text);

}  // namespace halfspace
