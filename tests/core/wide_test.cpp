// Wide<Bits> against GMP, modulo 2^Bits: random values of every length and the values at the edges of limbs.
#include "firmware/core/wide.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/numbers.hpp"

namespace halfspace {
namespace {

using namespace testing;

template <class Integer>
class WideTest : public ::testing::Test {};
using Widths = ::testing::Types<Wide<64>, Wide<128>, Wide<192>, Wide<256>, Wide<512>, Wide<768>>;
TYPED_TEST_SUITE(WideTest, Widths);

template <int Bits>
constexpr int width_of(const Wide<Bits>&) {
  return Bits;
}

std::vector<mpz_class> interesting(int bits, int random, std::uint64_t seed) {
  std::vector<mpz_class> values;
  for (const int edge : {0, 31, 32, 33, 63, 64, 65, 127, 128, bits - 2, bits - 1}) {
    for (int d = -1; d <= 1; ++d) {
      values.push_back(wrapped((mpz_class(1) << edge) + d, bits));
      values.push_back(wrapped(-(mpz_class(1) << edge) + d, bits));
    }
  }
  Dice dice(seed);
  for (int i = 0; i < random; ++i) values.push_back(wrapped(random_bits(dice, bits), bits));
  return values;
}

TYPED_TEST(WideTest, PairsOfValuesAgreeWithGmp) {
  constexpr int bits = width_of(TypeParam{});
  const auto values = interesting(bits, 60, 1);
  for (const mpz_class& a : values) {
    const auto wa = to_wide<bits>(a);
    ASSERT_EQ(to_mpz(wa), a);
    for (const mpz_class& b : values) {
      const auto wb = to_wide<bits>(b);
      ASSERT_EQ(to_mpz(wa + wb), wrapped(a + b, bits)) << a << " + " << b;
      ASSERT_EQ(to_mpz(wa - wb), wrapped(a - b, bits)) << a << " - " << b;
      ASSERT_EQ(to_mpz(wa * wb), wrapped(a * b, bits)) << a << " * " << b;
      ASSERT_EQ(wa < wb, a < b) << a << " < " << b;
      ASSERT_EQ(wa == wb, a == b);
    }
  }
}

TYPED_TEST(WideTest, SingleValuesAgreeWithGmp) {
  constexpr int bits = width_of(TypeParam{});
  for (const mpz_class& a : interesting(bits, 300, 2)) {
    const auto w = to_wide<bits>(a);
    ASSERT_EQ(to_mpz(-w), wrapped(-a, bits)) << a;
    ASSERT_EQ(w.sign(), sgn(a)) << a;
    ASSERT_EQ(w.is_zero(), a == 0);
    ASSERT_EQ(w.bit_length(), a == 0 ? 0 : static_cast<int>(mpz_sizeinbase(a.get_mpz_t(), 2))) << a;
    ASSERT_EQ(mpz_class(to_mpz(w.low64())), wrapped(a, 64)) << a;
    ASSERT_EQ(to_mpz(Wide<1024>(w)), a) << "sign extension";
    ASSERT_EQ(to_mpz(Wide<64>(w)), wrapped(a, 64)) << "truncation";
    for (const std::int32_t n : {0, 1, -1, 7, -32768, 65535, INT32_MAX, INT32_MIN}) {
      ASSERT_EQ(to_mpz(w.times(n)), wrapped(a * n, bits)) << a << " times " << n;
    }
  }
}

TYPED_TEST(WideTest, ShiftsByEveryCount) {
  constexpr int bits = width_of(TypeParam{});
  for (const mpz_class& a : interesting(bits, 10, 3)) {
    const auto w = to_wide<bits>(a);
    for (int count = 0; count < bits; ++count) {
      ASSERT_EQ(to_mpz(w << count), wrapped(a << count, bits)) << a << " << " << count;
      ASSERT_EQ(to_mpz(w >> count), mpz_class(a >> count)) << a << " >> " << count;
    }
    ASSERT_EQ(to_mpz(w >> (bits + 70)), a < 0 ? -1 : 0) << a;
  }
}

TEST(Wide, ScaledRoundsTowardsMinusInfinity) {
  Dice dice(4);
  for (int i = 0; i < 20000; ++i) {
    const mpz_class a = random_bits(dice, 190);
    const int length = a == 0 ? 0 : static_cast<int>(mpz_sizeinbase(a.get_mpz_t(), 2));
    const int shift = length - static_cast<int>(between(dice, 1, 63));
    const mpz_class expected = shift >= 0 ? mpz_class(a >> shift) : mpz_class(a << -shift);
    ASSERT_EQ(to_mpz(scaled(to_wide<192>(a), shift)), expected) << a << " by 2^-" << shift;
  }
}

TEST(Wide, HoldsEvery64BitInteger) {
  for (const std::int64_t v : {INT64_MIN, INT64_MIN + 1, std::int64_t{-1}, std::int64_t{0}, INT64_MAX}) {
    EXPECT_EQ(to_mpz(Wide<192>(v)), to_mpz(v));
    EXPECT_EQ(Wide<192>(v).low64(), v);
    EXPECT_EQ(sign_of(v), sgn(to_mpz(v)));
  }
}

}  // namespace
}  // namespace halfspace
