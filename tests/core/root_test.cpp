// Square roots: the integer one, and the two that follow a quadratic from dot to dot.
#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/isqrt.hpp"
#include "firmware/core/quick_root.hpp"
#include "firmware/core/root_walk.hpp"
#include "tests/core/numbers.hpp"

namespace halfspace {
namespace {

using namespace testing;

std::uint64_t exact_root(std::uint64_t n) { return mpz_class(sqrt(mpz_class(static_cast<unsigned long>(n)))).get_ui(); }

TEST(Isqrt, EveryNumberBelowTwoMillion) {
  std::uint32_t root = 0;
  for (std::uint64_t n = 0; n < 2000000; ++n) {
    if ((root + std::uint64_t{1}) * (root + std::uint64_t{1}) <= n) ++root;
    ASSERT_EQ(isqrt(n), root) << n;
  }
}

TEST(Isqrt, AroundSquaresUpToTheLargest) {
  Dice dice(7);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t s = dice() >> between(dice, 32, 63);
    for (const std::uint64_t n : {s * s - 1, s * s, s * s + 1, s * s + 2 * s, s * s + 2 * s + 1}) {
      ASSERT_EQ(isqrt(n), exact_root(n)) << n;
    }
  }
  EXPECT_EQ(isqrt(UINT64_MAX), 0xffffffffU);
  EXPECT_EQ(isqrt(0xfffffffe00000001ULL), 0xffffffffU);
  EXPECT_EQ(isqrt(0xfffffffe00000000ULL), 0xfffffffeU);
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    for (const std::uint64_t n : {power - 1, power, power + 1}) ASSERT_EQ(isqrt(n), exact_root(n)) << n;
  }
}

// D(x) = d0 + x d1 + x (x - 1) / 2 d2 with |D| < 2^60 on `count` dots.
struct Quadratic {
  std::int64_t d, d1, d2;
  int count;

  [[nodiscard]] bool step() {
    --count;
    d += d1;
    d1 += d2;
    return count > 0 && d < std::int64_t{1} << 60 && d > -(std::int64_t{1} << 60);
  }
};

Quadratic random_quadratic(Dice& dice) {
  const int bits = static_cast<int>(between(dice, 4, 59));
  const int n_bits = static_cast<int>(between(dice, 2, 10));
  const auto pick = [&dice](int b) { return b <= 0 ? between(dice, -1, 1) : random_bits(dice, b).get_si(); };
  Quadratic q{std::abs(pick(bits)), pick(bits - n_bits), pick(bits - 2 * n_bits), 1 << n_bits};
  // One in three touches or crosses zero close to a dot: a limb, or a double root.
  if (dice() % 3 == 0) {
    const std::int64_t a = between(dice, 1, 1 << 15);
    const std::int64_t middle = between(dice, 0, 300);
    const std::int64_t lift = between(dice, -2, 2);
    q = {a * a * middle * middle + lift, a * a * (1 - 2 * middle), 2 * a * a, 600};
  }
  return q;
}

// |s - sqrt(d)| <= units, by squares.
void expect_within(std::int64_t units, std::int64_t s, std::int64_t d) {
  const mpz_class exact = to_mpz(std::max<std::int64_t>(d, 0));
  const mpz_class low = to_mpz(s - units);
  const mpz_class high = to_mpz(s + units);
  ASSERT_GE(s, 0);
  ASSERT_LE(low * abs(low), exact) << "s " << s << " D " << d;
  ASSERT_GE(high * high, exact) << "s " << s << " D " << d;
}

TEST(QuickRoot, IsWithinThree) {
  Dice dice(10);
  for (int i = 0; i < 500000; ++i) {
    const auto v = static_cast<std::int64_t>(std::max<std::uint64_t>(dice() >> between(dice, 4, 63), 1));
    expect_within(3, quick_root(static_cast<std::uint64_t>(v)), v);
    if (HasFatalFailure()) return;
  }
}

// Each entry of the table, at both ends of what it serves.
TEST(QuickRoot, IsWithinItsErrorAroundEveryTableEntry) {
  for (std::int64_t i = 16; i < 256; ++i) {
    for (const std::int64_t edge : {i << 52, ((i + 1) << 52) - 1, (i << 52) + (std::int64_t{1} << 51)}) {
      expect_within(3, quick_root(static_cast<std::uint64_t>(edge)), edge);
      expect_within(4, quick_large_root(static_cast<std::uint64_t>(edge)), edge);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(QuickRoot, OfLargeNumbersIsWithinFour) {
  Dice dice(11);
  for (int i = 0; i < 500000; ++i) {
    const std::int64_t v = between(dice, std::int64_t{1} << 56, (std::int64_t{1} << 60) - 1);
    expect_within(4, quick_large_root(static_cast<std::uint64_t>(v)), v);
    if (HasFatalFailure()) return;
  }
}

TEST(RootWalk, StaysWithinItsTolerance) {
  Dice dice(8);
  for (int trial = 0; trial < 3000; ++trial) {
    Quadratic q = random_quadratic(dice);
    RootWalk walk;
    do {
      expect_within(root_tolerance, walk.next(q.d), q.d);
      if (HasFatalFailure()) return;
    } while (q.step());
  }
}

TEST(JordanWalk, StaysWithinHalfAStep) {
  Dice dice(9);
  for (int trial = 0; trial < 2000; ++trial) {
    Quadratic q = random_quadratic(dice);
    const int shift = static_cast<int>(between(dice, 8, 24));
    JordanWalk walk(q.d, shift);
    do {
      const mpz_class exact = to_mpz(std::max<std::int64_t>(q.d, 0));
      const mpz_class s = to_mpz(walk.next(q.d));
      const mpz_class half = mpz_class(1) << (shift - 1);
      ASSERT_GE(s, half);
      ASSERT_LE((s - half) * (s - half), exact) << "shift " << shift << " D " << q.d;
      ASSERT_GT((s + half) * (s + half), exact) << "shift " << shift << " D " << q.d;
    } while (q.step());
  }
}

}  // namespace
}  // namespace halfspace
