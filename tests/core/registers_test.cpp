// Step, step back, jump and load agree: the whole state is compared, and printed when it differs.
#include "firmware/core/registers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <ostream>

#include "tests/core/numbers.hpp"

namespace halfspace {

template <int Bits>
void PrintTo(const Wide<Bits>& value, std::ostream* out) {
  *out << testing::to_mpz(value);
}
template <class Int>
void PrintTo(const FirstOrder<Int>& s, std::ostream* out) {
  *out << "r " << ::testing::PrintToString(s.r) << " x " << ::testing::PrintToString(s.x) << " y "
       << ::testing::PrintToString(s.y);
}
template <class Int>
void PrintTo(const SecondOrder<Int>& s, std::ostream* out) {
  *out << "r " << ::testing::PrintToString(s.r) << " x " << ::testing::PrintToString(s.x) << " y "
       << ::testing::PrintToString(s.y) << " xx " << ::testing::PrintToString(s.xx) << " xy "
       << ::testing::PrintToString(s.xy) << " yy " << ::testing::PrintToString(s.yy);
}
template <class Int>
void PrintTo(const FourthOrder<Int>& s, std::ostream* out) {
  *out << ::testing::PrintToString(s.at);
}

namespace {

using namespace testing;

// Bits of coefficients whose values stay inside Int for |x|, |y| < 2^13.
template <class Int>
constexpr int coefficient_bits = 30;
template <int Bits>
constexpr int coefficient_bits<Wide<Bits>> = Bits - 34;

template <class Int>
Int number(const mpz_class& value) {
  if constexpr (std::is_same_v<Int, std::int64_t>) {
    return value.get_si();
  } else {
    Int wide;
    for (int i = 0; i < Int::limbs; ++i) {
      mpz_class limb;
      mpz_fdiv_q_2exp(limb.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(i * limb_bits));
      mpz_fdiv_r_2exp(limb.get_mpz_t(), limb.get_mpz_t(), limb_bits);
      wide.set_limb(i, static_cast<Limb>(limb.get_ui()));
    }
    return wide;
  }
}

using Coefficients = std::array<mpz_class, 6>;

mpz_class value_at(const Coefficients& q, long x, long y) {
  return q[0] * x * x + q[1] * x * y + q[2] * y * y + q[3] * x + q[4] * y + q[5];
}

template <class Int>
class RegistersTest : public ::testing::Test {
 protected:
  static SecondOrder<Int> load(const Coefficients& q, std::int64_t x, std::int64_t y) {
    return SecondOrder<Int>::load(number<Int>(q[0]), number<Int>(q[1]), number<Int>(q[2]), number<Int>(q[3]),
                                  number<Int>(q[4]), number<Int>(q[5]), x, y);
  }
};
using Integers = ::testing::Types<std::int64_t, Wide<64>, Wide<128>, Wide<256>>;
TYPED_TEST_SUITE(RegistersTest, Integers);

TYPED_TEST(RegistersTest, SecondOrderWalksEndWhereALoadBegins) {
  Dice dice(5);
  for (int trial = 0; trial < 40; ++trial) {
    Coefficients q;
    for (mpz_class& c : q) c = random_bits(dice, std::min(coefficient_bits<TypeParam>, 200));
    std::int64_t x = between(dice, -900, 900);
    std::int64_t y = between(dice, -900, 900);
    auto walk = this->load(q, x, y);
    for (int i = 0; i < 2000; ++i) {
      const std::int64_t n = between(dice, -50, 50);
      switch (between(dice, 0, 4)) {
        case 0:
          walk.step_x(), ++x;
          break;
        case 1:
          walk.back_x(), --x;
          break;
        case 2:
          walk.step_y(), ++y;
          break;
        case 3:
          if (x + n > -4000 && x + n < 4000) walk.jump_x(n), x += n;
          break;
        default:
          if (y + n > -4000 && y + n < 4000) walk.jump_y(n), y += n;
      }
    }
    ASSERT_EQ(walk, this->load(q, x, y)) << "at " << x << ", " << y;
    ASSERT_EQ(walk.r, number<TypeParam>(value_at(q, x, y)));
    ASSERT_EQ(walk.x, number<TypeParam>(value_at(q, x + 1, y) - value_at(q, x, y)));
    ASSERT_EQ(walk.y, number<TypeParam>(value_at(q, x, y + 1) - value_at(q, x, y)));
  }
}

TYPED_TEST(RegistersTest, FirstOrderWalksEndWhereJumpsEnd) {
  Dice dice(6);
  for (int trial = 0; trial < 40; ++trial) {
    std::array<mpz_class, 3> c;
    for (mpz_class& k : c) k = random_bits(dice, std::min(coefficient_bits<TypeParam>, 200));
    const FirstOrder<TypeParam> start{number<TypeParam>(c[2]), number<TypeParam>(c[0]), number<TypeParam>(c[1])};
    auto walk = start;
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (int i = 0; i < 5000; ++i) {
      switch (between(dice, 0, 2)) {
        case 0:
          walk.step_x(), ++x;
          break;
        case 1:
          walk.back_x(), --x;
          break;
        default:
          walk.step_y(), ++y;
      }
    }
    auto jump = start;
    jump.jump_y(y);
    jump.jump_x(x);
    ASSERT_EQ(walk, jump) << "at " << x << ", " << y;
    ASSERT_EQ(walk.r, number<TypeParam>(c[0] * static_cast<long>(x) + c[1] * static_cast<long>(y) + c[2]));
  }
}

// Coefficients of x^(n-j) y^j, lowest n first. Every register is a difference of the one below it.
mpz_class quartic_at(const std::array<mpz_class, 15>& q, const mpz_class& x, const mpz_class& y) {
  mpz_class sum;
  for (int n = 0, k = 0; n <= 4; ++n) {
    for (int j = 0; j <= n; ++j, ++k) {
      mpz_class term = q[static_cast<std::size_t>(k)];
      for (int i = 0; i < n; ++i) term *= i < j ? y : x;
      sum += term;
    }
  }
  return sum;
}

template <class Integer>
class FourthOrderTest : public ::testing::Test {};
using WideIntegers = ::testing::Types<Wide<64>, Wide<128>, Wide<256>, Wide<384>>;
TYPED_TEST_SUITE(FourthOrderTest, WideIntegers);

// The registers wrap, and so may the coefficients be of any size: all is compared modulo their width.
TYPED_TEST(FourthOrderTest, WalksEndWhereALoadBegins) {
  constexpr int bits = TypeParam::limbs * limb_bits;
  Dice dice(7);
  for (int trial = 0; trial < 40; ++trial) {
    std::array<mpz_class, 15> coefficients;
    std::array<TypeParam, 15> q;
    for (std::size_t i = 0; i < 15; ++i) {
      coefficients[i] = random_bits(dice, bits - 1);
      q[i] = to_wide<bits>(coefficients[i]);
    }
    auto x = static_cast<std::int32_t>(between(dice, -131072, 131072));
    auto y = static_cast<std::int32_t>(between(dice, -131072, 131072));
    const auto begin = [&q](std::int32_t px, std::int32_t py) {
      FourthOrder<TypeParam> s{q};
      s.begin(px, py);
      return s;
    };
    auto walk = begin(x, y);
    for (int i = 0; i < 500; ++i) {
      const auto n = static_cast<std::int32_t>(between(dice, -65536, 65536));
      switch (between(dice, 0, 4)) {
        case 0:
          walk.step_x(), ++x;
          break;
        case 1:
          walk.back_x(), --x;
          break;
        case 2:
          walk.step_y(), ++y;
          break;
        case 3:
          if (std::abs(x + n) <= 131072) walk.jump_x(n), x += n;
          break;
        default:
          if (std::abs(y + n) <= 131072) walk.jump_y(n), y += n;
      }
    }
    if (std::abs(x) > 131072 || std::abs(y) > 131072) continue;
    ASSERT_EQ(walk, begin(x, y)) << "at " << x << ", " << y;
    ASSERT_EQ(to_mpz(walk.r()), wrapped(quartic_at(coefficients, x, y), bits));
  }
}

// The whole width of a page, one step at a time, there and back.
TYPED_TEST(RegistersTest, ALongWalkAndBackIsWhereItBegan) {
  const Coefficients q{1234577, -987653, 444443, -7777777, 31337, -99999999};
  const auto start = this->load(q, -3, 5);
  auto walk = start;
  for (int i = 0; i < 32767; ++i) walk.step_x();
  ASSERT_EQ(walk, this->load(q, 32764, 5));
  for (int i = 0; i < 32767; ++i) walk.back_x();
  ASSERT_EQ(walk, start);
}

}  // namespace
}  // namespace halfspace
