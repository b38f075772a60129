// The sign of p + r sqrt(d) against GMP: random values, ties, and values as near to one as integers come.
#include "firmware/core/radical_sign.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/numbers.hpp"

namespace halfspace {
namespace {

using namespace testing;

template <class Integer>
class RadicalSignTest : public ::testing::Test {
 protected:
  static constexpr int bits = Integer::limbs * limb_bits;

  static void expect_sign(const mpz_class& p, const mpz_class& r, const mpz_class& d) {
    ASSERT_EQ(sign_of_radical<3 * bits>(to_wide<bits>(p), to_wide<bits>(r), to_wide<bits>(d)), sign_of_sum(p, r, d))
        << p << " + " << r << " sqrt(" << d << ")";
  }
  // With both signs of p and of r.
  static void expect_signs(const mpz_class& p, const mpz_class& r, const mpz_class& d) {
    for (const int sign : {-1, 1}) {
      expect_sign(sign * p, r, d);
      expect_sign(sign * p, -r, d);
    }
  }
};
using Widths = ::testing::Types<Wide<64>, Wide<128>, Wide<256>, Wide<384>>;
TYPED_TEST_SUITE(RadicalSignTest, Widths);

TYPED_TEST(RadicalSignTest, RandomValuesAndZeros) {
  Dice dice(60);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto value = [&] { return dice() % 8 == 0 ? mpz_class(0) : random_bits(dice, this->bits - 1); };
    this->expect_signs(value(), value(), abs(value()));
    if (this->HasFatalFailure()) return;
  }
}

// p is r sqrt(d) rounded, and its neighbours; where d is a square, one of them is a tie.
TYPED_TEST(RadicalSignTest, TiesAndTheirNeighbours) {
  Dice dice(61);
  for (int trial = 0; trial < 1000; ++trial) {
    const mpz_class s = abs(random_bits(dice, this->bits / 2 - 2));
    const mpz_class r = random_bits(dice, this->bits / 2 - 1);
    mpz_class d = s * s;
    if (trial % 2 == 0) d += abs(random_bits(dice, trial % 3 == 0 ? 2 : this->bits / 2));
    const mpz_class p = sqrt(mpz_class(r * r * d));
    for (int off = -2; off <= 2; ++off) this->expect_signs(p + off, r, d);
    if (this->HasFatalFailure()) return;
  }
}

// Just inside and outside of what leading bits can tell: p off by one part in 2^20 .. 2^40.
TYPED_TEST(RadicalSignTest, WhereLeadingBitsBeginToTell) {
  Dice dice(62);
  for (int trial = 0; trial < 2000; ++trial) {
    const int most = this->bits / 2 - 2;
    const mpz_class r = random_bits(dice, most);
    const mpz_class d = abs(random_bits(dice, this->bits - 2));
    const mpz_class p = sqrt(mpz_class(r * r * d));
    const mpz_class off = p >> static_cast<unsigned>(between(dice, 20, 40));
    this->expect_signs(p + off, r, d);
    this->expect_signs(p - off, r, d);
    if (this->HasFatalFailure()) return;
  }
}

// The margin is neither too small (never a wrong sign) nor needlessly large (told from one part in 2^26 on).
TEST(CompareLeading, IsRightWhereItTellsAndTellsOftenEnough) {
  Dice dice(63);
  const auto value = [](const Mantissa& v, std::uint64_t last) { return mpz_class((mpz_class(v.m) << 40) + last); };
  for (int trial = 0; trial < 200000; ++trial) {
    const auto any = [&dice] {
      const auto edge = dice() % 4;
      const auto m = static_cast<std::uint32_t>(dice() | 0x80000000U);
      return edge == 0 ? 0x80000000U : edge == 1 ? 0xffffffffU : m;
    };
    const Mantissa r{any(), 0}, d{any(), 0};
    // p near r sqrt(d), its exponent such that the squares meet.
    const mpz_class root = sqrt(mpz_class((mpz_class(r.m) * r.m * d.m) << 64));  // in 2^-32
    const int e = static_cast<int>(mpz_sizeinbase(root.get_mpz_t(), 2)) - 32;
    const auto exact = static_cast<std::int64_t>(mpz_class(root >> static_cast<unsigned>(e)).get_ui());
    const std::int64_t m = std::clamp<std::int64_t>(exact + between(dice, -300, 300), 0x80000000, 0xffffffff);
    const Mantissa p{static_cast<std::uint32_t>(m), e - 32};
    const int told = compare_leading(p, r, d);
    // The numbers at either end of the intervals, in 2^-40 of their units, p in the unit of its exponent.
    const auto difference = [&](std::uint64_t last_p, std::uint64_t last_rd) {
      mpz_class left = value(p, last_p);
      mpz_class right = value(r, last_rd);
      left = left * left << 40;
      right = right * right * value(d, last_rd);
      return p.e >= 0 ? mpz_class((left << static_cast<unsigned>(2 * p.e)) - right)
                      : mpz_class(left - (right << static_cast<unsigned>(-2 * p.e)));
    };
    constexpr std::uint64_t end = (std::uint64_t{1} << 40) - 1;
    const bool right = told > 0 ? difference(0, end) > 0 : told < 0 ? difference(end, 0) < 0 : std::abs(m - exact) < 40;
    ASSERT_TRUE(right) << told << ": " << p.m << " " << r.m << " " << d.m;
  }
}

}  // namespace
}  // namespace halfspace
