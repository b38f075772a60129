// Thousands of seeded bodies, every face decided at every dot of a small page by brute force.
#include <gtest/gtest.h>

#include <cstdlib>

#include "host/resolve/resolve.hpp"
#include "tests/resolve/body_maker.hpp"
#include "tests/resolve/brute_force.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::test {
namespace {

// A hundredth of HALFSPACE_RANDOM_BODIES, or a thousand: each takes some milliseconds, and under the sanitizers fifteen times as long.
const std::uint64_t count = [] {
  constexpr std::uint64_t standard = testing::sanitized ? 60 : 1000;
  const char* text = std::getenv("HALFSPACE_RANDOM_BODIES");
  return text == nullptr ? standard : std::strtoull(text, nullptr, 10) / 100;
}();

void expect_exact(const IntegerScene& scene, const ResolvedScene& resolved, std::uint64_t seed) {
  const auto broken = broken_structure(scene, resolved);
  ASSERT_FALSE(broken) << "seed " << seed << ": " << *broken;
  const auto wrong = wrong_dot(scene, resolved);
  ASSERT_FALSE(wrong) << "seed " << seed << ": " << *wrong;
}

TEST(RandomBodies, WithOneQuadricAreRightOnEveryDot) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Dice dice(seed);
    const IntegerScene scene = page_with(random_body(dice, 1), 24, 24);
    expect_exact(scene, resolve(scene, true), seed);
    if (HasFatalFailure()) return;
  }
}

TEST(RandomBodies, WithManyQuadricsAreRightOnEveryDot) {
  for (std::uint64_t seed = 100001; seed <= 100000 + count; ++seed) {
    Dice dice(seed);
    const IntegerScene scene = page_with(random_body(dice, 4), 24, 24);
    expect_exact(scene, resolve(scene, true), seed);
    if (HasFatalFailure()) return;
  }
}

// Nothing but quadrics, on pages large enough for windows of many lines.
TEST(RandomBodies, OfQuadricsAreRightOnLargerPages) {
  for (std::uint64_t seed = 200001; seed <= 200000 + count / 10; ++seed) {
    Dice dice(seed);
    const IntegerScene scene = page_with(magnified(random_quadrics(dice, 4), 5), 120, 120);
    expect_exact(scene, resolve(scene, true), seed);
    if (HasFatalFailure()) return;
  }
}

// The same surfaces with coefficients far beyond any machine word.
TEST(RandomBodies, OfHugeCoefficientsAreTheSame) {
  for (std::uint64_t seed = 1; seed <= count / 10; ++seed) {
    Dice dice(seed);
    IntegerScene scene = page_with(random_body(dice, 4), 24, 24);
    mpz_class factor = (mpz_class(1) << static_cast<unsigned>(dice.between(0, 400))) + dice.between(0, 9);
    for (IntegerHalfSpace& h : scene.bodies[0].half_spaces) {
      for (mpz_class& c : h.c) c *= factor;
      factor = factor * 3 + 1;
    }
    expect_exact(scene, resolve(scene, true), seed);
    if (HasFatalFailure()) return;
  }
}

// Coincidences become near misses of 2^-80, far below what the interval filter can tell: nothing cancels, and roots of different curves hardly differ.
TEST(RandomBodies, NearlyDegenerateOnesAreRightToo) {
  for (std::uint64_t seed = 1; seed <= count / 10; ++seed) {
    Dice dice(seed);
    IntegerScene scene = page_with(random_body(dice, 4), 24, 24);
    for (IntegerHalfSpace& h : scene.bodies[0].half_spaces) {
      for (mpz_class& c : h.c) c = (c << 80) + dice.between(-2, 2);
    }
    expect_exact(scene, resolve(scene, true), seed);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace halfspace::test
