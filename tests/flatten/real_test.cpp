// The flattener's number against integers: roots are cut to 113 bits, wholes are the nearest, ties away from zero.
#include "host/flatten/real.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
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
    const int bits = static_cast<int>(dice() % 120);
    const Real moved = real * power_of_two(bits);
    ASSERT_NEAR(rounding_of(real, bits), static_cast<double>(nearest_whole(moved) - moved), 0x1p-53) << v;
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

// Bits of any kind, and such as meet: equal or neighbouring exponents, few bits, opposite numbers.
Bits128 random_bits(Dice& dice, Bits128 other) {
  const auto near_one = static_cast<Bits128>(16383 - 70 + dice() % 140) << 112;
  Bits128 bits = Bits128{dice()} << 64 | dice();
  const auto kind = dice() % 6;
  if (kind > 0) bits = (bits & ~(Bits128{0x7fff} << 112)) | near_one;
  if (kind > 2) bits = bits >> (dice() % 112) << (dice() % 112);
  if (kind > 3) bits = (bits & ~(Bits128{0x7fff} << 112)) | near_one;
  if (kind == 5) bits = (other + dice() % 5 - 2) ^ Bits128 { dice() % 2 } << 127;
  return dice() % 50 == 0 ? Bits128{dice() % 2} << 127 : bits;
}

bool is_same(Real own, NativeReal native) {
  const Real expected = Real::of(native);
  return own.bits() == expected.bits() || (own.is_nan() && expected.is_nan());
}

TEST(Real, ArithmeticIsTheCompilers) {
  Dice dice(4);
  for (int trial = 0; trial < 400000; ++trial) {
    const Real a = Real::of_bits(random_bits(dice, 0));
    const Real b = Real::of_bits(random_bits(dice, a.bits()));
    ASSERT_TRUE(is_same(a + b, a.native() + b.native())) << trial;
    ASSERT_TRUE(is_same(a - b, a.native() - b.native())) << trial;
    ASSERT_TRUE(is_same(a * b, a.native() * b.native())) << trial;
    ASSERT_TRUE(is_same(a / b, a.native() / b.native())) << trial;
    const Real power = power_of_two(static_cast<int>(dice() % 32764) - 16382);
    ASSERT_TRUE(is_same(a / power, a.native() / power.native())) << trial;
    const int shift = static_cast<int>(dice() % 32764) - 16382;
    ASSERT_TRUE(is_same(times_power_of_two(a, shift), a.native() * power_of_two(shift).native())) << trial;
    const auto near = static_cast<double>(a);
    ASSERT_EQ(std::isnan(near), a.is_nan()) << trial;
    ASSERT_TRUE(a.is_nan() || near == static_cast<double>(a.native())) << trial;
    ASSERT_EQ(a < b, a.native() < b.native()) << trial;
    ASSERT_EQ(a <= b, a.native() <= b.native()) << trial;
    ASSERT_EQ(a == b, a.native() == b.native()) << trial;
    ASSERT_EQ(finite(a), a.native() - a.native() == 0) << trial;
  }
}

Real by_mpfr(const std::string& text) {
  mpfr_t value;
  mpfr_init2(value, 113);
  mpfr_set_str(value, text.c_str(), 10, MPFR_RNDN);
  mpz_class mantissa;
  const mpfr_exp_t exponent = mpfr_zero_p(value) != 0 ? 0 : mpfr_get_z_2exp(mantissa.get_mpz_t(), value);
  mpfr_clear(value);
  return to_real(mantissa) * power_of_two(static_cast<int>(exponent));
}

TEST(Real, DecimalsAreRoundedOnce) {
  Dice dice(5);
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text(dice() % 8, '0');
    text.append(random_below(dice, static_cast<int>(dice() % 150)).get_str());
    if (dice() % 4 != 0) text.insert(text.begin() + static_cast<std::ptrdiff_t>(dice() % (text.size() + 1)), '.');
    if (dice() % 2 != 0) text.insert(text.begin(), '-');
    if (dice() % 8 == 0) text.append("e").append(std::to_string(static_cast<int>(dice() % 60) - 30));
    ASSERT_EQ(decimal_to_real(text), by_mpfr(text)) << text;
  }
  EXPECT_FALSE(has_sign(decimal_to_real("-0.0")));
}

}  // namespace
}  // namespace halfspace
