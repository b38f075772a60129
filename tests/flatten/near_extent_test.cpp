// Boxes found in doubles against those found in Real: bodies of one quadric and planes, in random positions, most with small numbers, so that
// planes through apexes and centres, sections that are tangent and directions along asymptotes abound.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flatten/extent.hpp"
#include "host/flatten/far_directions.hpp"
#include "tests/oracle/dice.hpp"

namespace halfspace {
namespace {

Side random_side(oracle::Dice& dice, HalfSpaceKind kind, int most) {
  Side side{{kind, {}}, dice.between(0, 3) == 0};
  for (std::size_t i = 0; i < coefficient_count(kind); ++i) side.shape.c[i] = dice.between(-most, most);
  return side;
}

std::vector<Side> random_body(std::uint64_t seed) {
  oracle::Dice dice(seed);
  const int most = dice.between(0, 1) == 0 ? 2 : 1000;
  std::vector<Side> sides{random_side(dice, HalfSpaceKind::quadric, most)};
  for (auto more = dice.between(1, 6); more > 0; --more) sides.push_back(random_side(dice, HalfSpaceKind::plane, most));
  const SineCosine t = sine_cosine_of_degrees(std::to_string(dice.between(0, 2) * 37));
  const Matrix4 turn{{{t.cosine, t.sine, 0, 0}, {-t.sine, t.cosine, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  for (Side& side : sides) side.shape = normalised(transformed(side.shape, turn));
  return sides;
}

TEST(NearExtent, IsTheExactOneWithinTheSlack) {
  constexpr double slack = .25;
  int bounded = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    const std::vector<Side> sides = random_body(seed);
    const Extent exact = extent_of(sides, 0, false);
    const Extent near = extent_of(sides, slack, false);
    ASSERT_EQ(near.unbounded, exact.unbounded) << seed;
    ASSERT_EQ(near.empty, exact.empty) << seed;
    if (near.empty || near.unbounded) continue;
    ++bounded;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(near.box.high[i] >= exact.box.high[i] && near.box.high[i] <= exact.box.high[i] + slack) << seed;
      EXPECT_TRUE(near.box.low[i] <= exact.box.low[i] && near.box.low[i] >= exact.box.low[i] - slack) << seed;
    }
  }
  EXPECT_GT(bounded, 200);
}

Side plane(double a, double b, double c, double d) { return {{HalfSpaceKind::plane, {a, b, c, d}}}; }

TEST(FarDirections, OneOpenDirectionIsEnough) {
  const Side cylinder{{HalfSpaceKind::quadric, {1, 1, 0, 0, 0, 0, 0, 0, 0, -1}}};
  const Side upper = plane(.3, .2, 1, -1);
  const Side lower = plane(.3, .2, -1, -1);
  EXPECT_TRUE(certainly_ends(std::vector{cylinder, upper, lower}));
  EXPECT_FALSE(certainly_ends(std::vector{cylinder, upper}));
  EXPECT_FALSE(certainly_ends(std::vector{cylinder, upper, plane(1, 0, 0, 0)}));
  EXPECT_FALSE(certainly_ends(std::vector{upper, lower}));
  EXPECT_FALSE(certainly_ends(std::vector{cylinder, plane(1, 0, 0, -1), plane(-1, 0, 0, -1)}));
  const Side outside{cylinder.shape, true};
  EXPECT_FALSE(certainly_ends(std::vector{outside, upper, lower}));
  // A cone's asymptotic planes and a paraboloid's axis are open ends.
  const Side cone{{HalfSpaceKind::quadric, {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}}};
  EXPECT_FALSE(certainly_ends(std::vector{cone, plane(1, 0, 1, -1), plane(-1, 0, -1, -1)}));
  EXPECT_TRUE(certainly_ends(std::vector{cone, plane(.5, 0, 1, -1), plane(-.5, 0, -1, -1)}));
  EXPECT_FALSE(certainly_ends(std::vector{Side{{HalfSpaceKind::quadric, {1, 1, 0, 0, 0, 0, 0, 0, 1, 0}}}}));
}

}  // namespace
}  // namespace halfspace
