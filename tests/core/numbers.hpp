// numbers.hpp - the core's integers as GMP's and back, random ones, and exact signs of sums of roots by GMP alone.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <random>

#include "firmware/core/wide.hpp"

namespace halfspace::testing {

using Dice = std::mt19937_64;

inline std::int64_t between(Dice& dice, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(dice);
}

// A value of at most `bits` bits, every length equally likely.
inline mpz_class random_bits(Dice& dice, int bits) {
  const auto length = static_cast<unsigned>(between(dice, 0, bits));
  mpz_class value;
  for (unsigned i = 0; i < length; i += 32) value = value << 32 | mpz_class(static_cast<unsigned long>(dice() >> 32));
  value &= (mpz_class(1) << length) - 1;
  return dice() % 2 == 0 ? value : mpz_class(-value);
}

// value modulo 2^bits, as two's complement reads it.
inline mpz_class wrapped(const mpz_class& value, int bits) {
  mpz_class r;
  mpz_fdiv_r_2exp(r.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return mpz_tstbit(r.get_mpz_t(), static_cast<mp_bitcnt_t>(bits - 1)) != 0 ? mpz_class(r - (mpz_class(1) << bits)) : r;
}

template <int Bits>
Wide<Bits> to_wide(const mpz_class& value) {
  mpz_class rest = value;
  Wide<Bits> r;
  for (int i = 0; i < Wide<Bits>::limbs; ++i) {
    mpz_class limb;
    mpz_fdiv_r_2exp(limb.get_mpz_t(), rest.get_mpz_t(), limb_bits);
    r.set_limb(i, static_cast<Limb>(limb.get_ui()));
    mpz_fdiv_q_2exp(rest.get_mpz_t(), rest.get_mpz_t(), limb_bits);
  }
  return r;
}

template <int Bits>
mpz_class to_mpz(const Wide<Bits>& value) {
  mpz_class r;
  for (int i = Wide<Bits>::limbs - 1; i >= 0; --i)
    r = r << limb_bits | mpz_class(static_cast<unsigned long>(value.limb(i)));
  return wrapped(r, Bits);
}

inline mpz_class to_mpz(std::int64_t value) { return static_cast<long>(value); }

// sign(a + b sqrt(q1) + c sqrt(q2)) for terms below 2^600. A non-zero sum exceeds 2^-1900: its product with its three
// conjugates is a non-zero integer. So 2000 bits of fraction tell zero from the rest.
inline int sign_of_sum(const mpz_class& a, const mpz_class& b, const mpz_class& q1, const mpz_class& c = 0,
                       const mpz_class& q2 = 0) {
  constexpr unsigned fraction = 2000;
  const auto root = [](const mpz_class& k, const mpz_class& q) {
    const mpz_class r = sqrt(mpz_class((k * k * q) << (2 * fraction)));
    return sgn(k) < 0 ? mpz_class(-r) : r;
  };
  const mpz_class sum = (a << fraction) + root(b, q1) + root(c, q2);
  return abs(sum) <= 4 ? 0 : sgn(sum);
}

}  // namespace halfspace::testing
