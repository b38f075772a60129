// The flattener's number against integers: roots are cut to 113 bits, wholes are the nearest, ties away from zero.
#include "host/flatten/real.hpp"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

using Dice = std::mt19937_64;

mpz_class random_below(Dice& dice, int bits) {
  mpz_class v;
  for (int i = 0; i < bits; i += 32) v = (v << 32) + static_cast<unsigned long>(dice() >> 32);
  return v >> static_cast<unsigned long>((bits + 31) / 32 * 32 - bits);
}

TEST(Real, RootsAreCutTo113Bits) {
  Dice dice(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const mpz_class v = random_below(dice, static_cast<int>(dice() % 113) + 1) + 1;
    const Real root = square_root(to_real(v));
    mpz_class whole = sqrt(v);
    const auto spare = static_cast<unsigned long>(113 - static_cast<int>(mpz_sizeinbase(whole.get_mpz_t(), 2)));
    const mpz_class mantissa = round_to_integer(root * power_of_two(static_cast<int>(spare)));
    const mpz_class square = v << (2 * spare);
    ASSERT_EQ(to_real(mantissa) * power_of_two(-static_cast<int>(spare)), root) << v;
    ASSERT_TRUE(mantissa * mantissa <= square && square < (mantissa + 1) * (mantissa + 1)) << v;
  }
  EXPECT_EQ(square_root(0), Real(0));
  EXPECT_EQ(square_root(power_of_two(-16382)), power_of_two(-8191));
}

TEST(Real, WholesAreTheNearest) {
  Dice dice(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const int fraction = static_cast<int>(dice() % 120);
    mpz_class v = random_below(dice, static_cast<int>(dice() % 113) + 1);
    if (dice() % 4 == 0) v |= 1;
    if (dice() % 2 == 0) v = -v;
    const mpz_class one = mpz_class(1) << static_cast<unsigned long>(fraction);
    const mpz_class nearest = (2 * abs(v) + one) / (2 * one) * sgn(v);
    const Real real = to_real(v) * power_of_two(-fraction);
    ASSERT_EQ(round_to_integer(real), nearest) << v << " / 2^" << fraction;
    ASSERT_EQ(nearest_whole(real), to_real(nearest)) << v << " / 2^" << fraction;
  }
}

TEST(Real, IntegersKeepTheirLeadingBits) {
  Dice dice(3);
  for (int trial = 0; trial < 5000; ++trial) {
    const mpz_class leading = random_below(dice, 112) + (mpz_class(1) << 112);
    const auto more = static_cast<unsigned long>(dice() % 300);
    const mpz_class v = (leading << more) + random_below(dice, static_cast<int>(more));
    ASSERT_EQ(to_real(v), to_real(leading) * power_of_two(static_cast<int>(more)));
    ASSERT_EQ(to_real(-v), -to_real(v));
  }
}

}  // namespace
}  // namespace halfspace
