// Where sections can change: what a projection hides.
#include "host/flatten/turning_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

bool vanishes_at(const std::vector<Polynomial>& marks, int u) {
  return std::any_of(marks.begin(), marks.end(), [u](const Polynomial& f) {
    mpz_class value = 0;
    for (std::size_t i = f.size(); i-- > 0;) value = value * u + f[i];
    return value == 0 && degree(f) > 0;
  });
}

// uu vv ww uv vw uw u v w 1

// A circle in the plane v = 1, whose shadow is a part of a line.
TEST(TurningPoints, ACurveBeforeItself) {
  const std::vector<SliceForm> balls{{{1, 1, 1, 0, 0, 0, 0, 0, 0, -26}}, {{1, 1, 1, 0, 0, 0, 0, -4, 0, -22}}};
  TurningPoints turning(balls);
  for (const int u : {-5, 5}) EXPECT_TRUE(vanishes_at(turning.of({0, 1}), u)) << u;
}

// A plane along w, and a ball.
TEST(TurningPoints, ASurfaceAlongTheProjection) {
  const std::vector<SliceForm> both{{{1, 1, 1, 0, 0, 0, 0, 0, 0, -25}}, {{0, 0, 0, 0, 0, 0, 0, 1, 0, -3}}};
  TurningPoints turning(both);
  for (const int u : {-4, 4}) EXPECT_TRUE(vanishes_at(turning.of({0, 1}), u)) << u;
}

// In the plane v = 0 each of three is a pair of the lines w = u - 3, w = 3 - u and w = 1, and shares one with either other. The first two cross
// in a point of all three.
TEST(TurningPoints, ThreeCurvesBeforeEachOther) {
  const std::vector<SliceForm> pairs{
      {{-1, 0, 1, 0, 0, 0, 6, 1, 0, -9}}, {{0, 0, 1, 0, 0, -1, 1, 2, 2, -3}}, {{0, 0, 1, 0, 0, 1, -1, 5, -4, 3}}};
  TurningPoints turning(pairs);
  EXPECT_TRUE(vanishes_at(turning.of({0, 1, 2}), 3));
}

}  // namespace
}  // namespace halfspace
