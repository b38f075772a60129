// wide.hpp - signed integers of a fixed width, for the few values that outgrow 64 bits.
// Format  Two's complement, least significant limb first; 64-bit limbs where the compiler multiplies them,
// else 32. Ranges  Arithmetic is modulo 2^Bits. Who uses a width proves it: the job writer checks the
// magnitudes (host/job/limits). Cost    Additions touch every limb; a product touches only the limbs that its
// factors fill. No heap; cannot fail.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace halfspace {

#ifdef __SIZEOF_INT128__
using Limb = std::uint64_t;
__extension__ using DoubleLimb = unsigned __int128;
__extension__ using SignedDoubleLimb = __int128;
#else
using Limb = std::uint32_t;
using DoubleLimb = std::uint64_t;
using SignedDoubleLimb = std::int64_t;
#endif
inline constexpr int limb_bits = static_cast<int>(sizeof(Limb) * 8);

template <int Bits>
class Wide {
 public:
  static_assert(Bits % 64 == 0, "a whole number of limbs on every target");
  static constexpr int limbs = Bits / limb_bits;

  constexpr Wide() = default;
  constexpr Wide(std::int64_t value) {  // NOLINT(google-explicit-constructor): a wider integer holds it exactly
    const auto bits = static_cast<std::uint64_t>(value);
    for (int i = 0; i < limbs; ++i) {
      const int shift = i * limb_bits;
      limb_[i] = shift < 64 ? static_cast<Limb>(bits >> shift) : fill(value < 0);
    }
  }
  // Sign-extends a narrower value; keeps the low bits of a wider one.
  template <int Other>
  constexpr explicit Wide(const Wide<Other>& value) {
    for (int i = 0; i < limbs; ++i) {
      limb_[i] = i < Wide<Other>::limbs ? value.limb(i) : fill(value.negative());
    }
  }

  constexpr Limb limb(int i) const { return limb_[i]; }
  constexpr void set_limb(int i, Limb value) { limb_[i] = value; }
  constexpr bool negative() const { return (limb_[limbs - 1] >> (limb_bits - 1)) != 0; }
  constexpr bool is_zero() const {
    Limb any = 0;
    for (const Limb l : limb_) any |= l;
    return any == 0;
  }
  constexpr int sign() const { return negative() ? -1 : (is_zero() ? 0 : 1); }

  // Two limbs at a time: what carries shows as a sum that is less than a term.
  constexpr Wide& operator+=(const Wide& o) {
    DoubleLimb carry = 0;
    for (int i = 0; i < limbs - 1; i += 2) {
      const DoubleLimb sum = pair(i) + o.pair(i);
      const DoubleLimb all = sum + carry;
      carry = static_cast<DoubleLimb>(sum < o.pair(i)) | static_cast<DoubleLimb>(all < sum);
      set_pair(i, all);
    }
    if constexpr (limbs % 2 != 0) limb_[limbs - 1] += o.limb_[limbs - 1] + static_cast<Limb>(carry);
    return *this;
  }
  constexpr Wide& operator-=(const Wide& o) {
    DoubleLimb borrow = 0;
    for (int i = 0; i < limbs - 1; i += 2) {
      const DoubleLimb difference = pair(i) - o.pair(i);
      const DoubleLimb all = difference - borrow;
      borrow = static_cast<DoubleLimb>(pair(i) < o.pair(i)) | static_cast<DoubleLimb>(difference < borrow);
      set_pair(i, all);
    }
    if constexpr (limbs % 2 != 0) limb_[limbs - 1] -= o.limb_[limbs - 1] + static_cast<Limb>(borrow);
    return *this;
  }
  friend constexpr Wide operator+(Wide a, const Wide& b) { return a += b; }
  friend constexpr Wide operator-(Wide a, const Wide& b) { return a -= b; }
  constexpr Wide operator-() const { return Wide() - *this; }
  friend constexpr Wide operator*(const Wide& a, const Wide& b) {
    if constexpr (is_pair) return of_pair(a.pair() * b.pair());
    return product<Bits>(a, b);
  }
  // In full.
  constexpr Wide<2 * Bits> full_product(const Wide& b) const { return product<2 * Bits>(*this, b); }

  // The product with a small number: one pass over the limbs, no sign handling (modulo 2^Bits it comes out right).
  constexpr Wide times(std::int32_t n) const {
    if constexpr (is_pair) return of_pair(pair() * static_cast<DoubleLimb>(n));
    Wide r;
    const auto magnitude = static_cast<Limb>(n < 0 ? -static_cast<std::int64_t>(n) : n);
    Limb carry = 0;
    for (int i = 0; i < limbs; ++i) {
      const DoubleLimb t = static_cast<DoubleLimb>(limb_[i]) * magnitude + carry;
      r.limb_[i] = static_cast<Limb>(t);
      carry = static_cast<Limb>(t >> limb_bits);
    }
    return n < 0 ? -r : r;
  }

  // Left shift by 0 .. Bits - 1; arithmetic right shift (towards minus infinity) by any amount.
  constexpr Wide operator<<(int count) const {
    if constexpr (is_pair) return of_pair(pair() << count);
    Wide r;
    const int whole = count / limb_bits;
    const int part = count % limb_bits;
    for (int i = limbs - 1; i >= whole; --i) {
      r.limb_[i] = limb_[i - whole] << part;
      if (part != 0 && i > whole) r.limb_[i] |= limb_[i - whole - 1] >> (limb_bits - part);
    }
    return r;
  }
  constexpr Wide operator>>(int count) const {
    if constexpr (is_pair) return of_pair(static_cast<DoubleLimb>(signed_pair() >> std::min(count, Bits - 1)));
    Wide r;
    const Limb extension = fill(negative());
    const int whole = count / limb_bits;
    const int part = count % limb_bits;
    for (int i = 0; i < limbs; ++i) {
      const Limb low = i + whole < limbs ? limb_[i + whole] : extension;
      const Limb high = i + whole + 1 < limbs ? limb_[i + whole + 1] : extension;
      r.limb_[i] = part == 0 ? low : (low >> part) | (high << (limb_bits - part));
    }
    return r;
  }

  friend constexpr bool operator==(const Wide&, const Wide&) = default;
  friend constexpr std::strong_ordering operator<=>(const Wide& a, const Wide& b) {
    if (a.negative() != b.negative()) {
      return a.negative() ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    for (int i = limbs - 1; i >= 0; --i) {
      if (a.limb_[i] != b.limb_[i]) {
        return a.limb_[i] < b.limb_[i] ? std::strong_ordering::less : std::strong_ordering::greater;
      }
    }
    return std::strong_ordering::equal;
  }

  constexpr Wide magnitude() const { return negative() ? -*this : *this; }
  // Bits of the magnitude: 0 for 0, else floor(log2 |value|) + 1.
  constexpr int bit_length() const {
    const Wide m = magnitude();
    for (int i = limbs - 1; i >= 0; --i) {
      if (m.limb_[i] != 0) return i * limb_bits + static_cast<int>(std::bit_width(m.limb_[i]));
    }
    return 0;
  }
  // The low 64 bits; the value itself when bit_length() <= 63.
  constexpr std::int64_t low64() const {
    std::uint64_t low = 0;
    for (int i = 0; i * limb_bits < 64; ++i) low |= static_cast<std::uint64_t>(limb_[i]) << (i * limb_bits);
    return static_cast<std::int64_t>(low);
  }

 private:
  // Two limbs are one integer that the compiler knows.
  static constexpr bool is_pair = limbs == 2;
  constexpr DoubleLimb pair(int i) const { return static_cast<DoubleLimb>(limb_[i + 1]) << limb_bits | limb_[i]; }
  constexpr void set_pair(int i, DoubleLimb value) {
    limb_[i] = static_cast<Limb>(value);
    limb_[i + 1] = static_cast<Limb>(value >> limb_bits);
  }
  constexpr DoubleLimb pair() const { return pair(0); }
  constexpr SignedDoubleLimb signed_pair() const { return static_cast<SignedDoubleLimb>(pair()); }
  static constexpr Wide of_pair(DoubleLimb value) {
    Wide r;
    r.set_pair(0, value);
    return r;
  }

  static constexpr Limb fill(bool negative) { return negative ? ~static_cast<Limb>(0) : 0; }
  constexpr int used() const {
    int n = limbs;
    while (n > 0 && limb_[n - 1] == 0) --n;
    return n;
  }
  // Not inlined: a face's forms take a hundred.
  template <int To>
  [[gnu::noinline]] static constexpr Wide<To> product(const Wide& a, const Wide& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const bool negate = a.negative() != b.negative();
    const Wide<To> product = multiply_magnitudes<To>(a.magnitude(), b.magnitude());
    return negate ? -product : product;
  }
  template <int To>
  static constexpr Wide<To> multiply_magnitudes(const Wide& a, const Wide& b) {
    constexpr int to_limbs = Wide<To>::limbs;
    Wide<To> r;
    const int na = a.used();
    const int nb = b.used();
    for (int i = 0; i < na; ++i) {
      Limb carry = 0;
      for (int j = 0; j < nb && i + j < to_limbs; ++j) {
        const DoubleLimb t = static_cast<DoubleLimb>(a.limb_[i]) * b.limb_[j] + r.limb(i + j) + carry;
        r.set_limb(i + j, static_cast<Limb>(t));
        carry = static_cast<Limb>(t >> limb_bits);
      }
      if (i + nb < to_limbs) r.set_limb(i + nb, carry);
    }
    return r;
  }

  std::array<Limb, static_cast<std::size_t>(limbs)> limb_{};
};

// sign of a fixed-width or built-in integer: -1, 0, 1.
constexpr int sign_of(std::int64_t v) { return (v > 0) - (v < 0); }
template <int Bits>
constexpr int sign_of(const Wide<Bits>& v) {
  return v.sign();
}

// value * 2^-shift rounded towards minus infinity; a negative shift scales up. The result must fit 64 bits.
template <int Bits>
constexpr std::int64_t scaled(const Wide<Bits>& value, int shift) {
  return shift >= 0 ? (value >> shift).low64() : (value << -shift).low64();
}

static_assert((Wide<128>(-3) * Wide<128>(5)).low64() == -15);
static_assert(((Wide<128>(1) << 100) - Wide<128>(1)).bit_length() == 100);
static_assert(Wide<128>(-3).times(-5) == Wide<128>(15) && Wide<128>(-3).times(7) == Wide<128>(-21));
static_assert((Wide<128>(-1) >> 90).low64() == -1);
static_assert(Wide<192>(-7) < Wide<192>(3) && Wide<192>(Wide<64>(-7)).low64() == -7);

}  // namespace halfspace
