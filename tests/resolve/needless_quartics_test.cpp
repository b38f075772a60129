// Which quadrics are left out of a face because their curve on it cannot be seen, and which are not.
#include "host/resolve/needless_quartics.hpp"

#include <gtest/gtest.h>

#include "tests/resolve/body_maker.hpp"

namespace halfspace::test {
namespace {

constexpr DotExtent page{-20, -20, 19, 19};

// How many of the others are left on the sheets of the first half-space.
std::size_t left_on_first(std::vector<IntegerHalfSpace> half_spaces) {
  const IntegerScene scene = page_with(std::move(half_spaces));
  Sheets sheets(scene.bodies[0], 0);
  drop_needless_quartics(sheets, page);
  return sheets.constraints.size();
}

// Along x and tilted in z: no two of these have parallel second-order parts.
IntegerHalfSpace cylinder(long radius_squared) {
  return sum_of_squares({{0, 1, 0, 0}, {1, 0, 2, 0}}, -5 * radius_squared);
}

TEST(NeedlessQuartics, OneAroundTheBodyIsLeftOut) {
  const IntegerHalfSpace near = plane(0, 0, -1, -12);
  const IntegerHalfSpace far = plane(0, 0, 1, -12);
  EXPECT_EQ(left_on_first({cylinder(64), near, far, sphere(0, 0, 0, 10000)}), 2U);
  EXPECT_EQ(left_on_first({cylinder(64), near, far, complement_of(sphere(200, 0, 0, 10000))}), 2U);
}

TEST(NeedlessQuartics, OneThatCutsOrTouchesTheFaceStays) {
  EXPECT_EQ(left_on_first({cylinder(64), sphere(0, 0, 0, 100)}), 1U);
  EXPECT_EQ(left_on_first({cylinder(64), sphere(0, 0, 0, 64)}), 1U);                    // from within
  EXPECT_EQ(left_on_first({cylinder(64), complement_of(sphere(0, 16, 0, 64))}), 1U);    // from outside
  EXPECT_EQ(left_on_first({cylinder(64), complement_of(sphere(0, 0, 0, 10000))}), 1U);  // it hides all that is seen
}

TEST(NeedlessQuartics, OneThatAnotherExcludesIsLeftOutAndTheOtherStays) {
  EXPECT_EQ(left_on_first({cylinder(64), sphere(0, 0, 0, 100), sphere(0, 0, 0, 225)}), 1U);
  EXPECT_EQ(left_on_first({cylinder(64), sphere(0, 0, 0, 225), sphere(0, 0, 0, 100)}), 1U);
  EXPECT_EQ(left_on_first({cylinder(64), sphere(0, 0, 0, 100), sphere(0, 0, 0, 100)}), 2U);
}

}  // namespace
}  // namespace halfspace::test
