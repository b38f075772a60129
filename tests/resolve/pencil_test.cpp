// Do two quadrics keep apart? By one quadric of their pencil: against bodies whose answer is known.
#include "host/resolve/pencil.hpp"

#include <gtest/gtest.h>

#include "host/resolve/resolve.hpp"
#include "tests/resolve/body_maker.hpp"
#include "tests/resolve/brute_force.hpp"

namespace halfspace::test {
namespace {

bool are_apart(const IntegerHalfSpace& p, const IntegerHalfSpace& q) {
  const auto sign = constant_sign(p, q);
  EXPECT_EQ(sign.has_value(), constant_sign(q, p).has_value());
  return sign && !sign->touching;
}

TEST(Pencil, ShellsOfEveryKindAreApart) {
  for (const std::array<long, 10>& c : {std::array<long, 10>{1, 2, 3, 0, 0, 0, 0, 0, 0, -9},
                                        {1, 1, -1, 0, 0, 0, 1, 2, 3, 0},
                                        {1, -1, 0, 0, 0, 0, 0, 0, 3, 1},
                                        {1, 0, 0, 0, 0, 0, 0, 4, 0, 0},
                                        {0, 0, 0, 1, 0, 0, 0, 0, 0, -4}}) {
    std::array<long, 10> next = c;
    for (long& v : next) v *= -3;
    next[9] += 1;
    EXPECT_TRUE(are_apart(quadric(c), quadric(next)));
  }
}

TEST(Pencil, SpheresAreApartUntilTheyTouch) {
  for (const long far : {21, 22, 50, 1000000}) EXPECT_TRUE(are_apart(sphere(0, 0, 0, 100), sphere(far, 0, 0, 100)));
  for (const long near : {1, 5, 19, 20}) EXPECT_FALSE(are_apart(sphere(0, 0, 0, 100), sphere(near, 0, 0, 100)));
  EXPECT_TRUE(are_apart(sphere(0, 0, 0, 100), sphere(3, 3, 3, 9)));
  EXPECT_FALSE(are_apart(sphere(0, 0, 0, 100), sphere(6, 6, 6, 9)));
}

TEST(Pencil, ParallelCylindersMeetAtInfinityOnly) {
  const auto cylinder = [](long x) { return sum_of_squares({{1, 0, 0, -x}, {0, 1, 1, 0}}, -25); };
  EXPECT_TRUE(are_apart(cylinder(0), cylinder(11)));
  EXPECT_FALSE(are_apart(cylinder(0), cylinder(9)));
}

// z is a depth in perspective: shells meet on the horizon, and touch there.
TEST(Pencil, PerspectiveShellsTouchInTheHorizonsPlane) {
  const IntegerHalfSpace p = sum_of_squares({{3, 0, 1, 2}, {0, 2, 1, 1, -1}}, 0);
  const IntegerHalfSpace q = sum_of_squares({{3, 0, 1, 2}, {0, 2, 1, 1, -1}, {0, 0, 1, 5}}, 0);
  const auto sign = constant_sign(p, q);
  ASSERT_TRUE(sign && sign->touching);
  EXPECT_EQ(sign->touching->c[3], 5 * sign->touching->c[2]);
}

// The ball touches the tube in a circle of dots: there alone the outside of one lies on the other.
TEST(Pencil, TouchingQuadricsAreDrawnToTheDot) {
  const IntegerHalfSpace tube = sum_of_squares({{1, 0, 0, 0}, {0, 0, 1, 0}}, -100);
  for (const bool inside : {false, true}) {
    const IntegerHalfSpace ball = sphere(0, 0, 0, 100);
    const IntegerScene scene =
        page_with({inside ? ball : complement_of(ball), tube, plane(0, 1, 0, -12), plane(0, -1, 0, -12)});
    const ResolveResult result = resolve(scene, true);
    ASSERT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(wrong_dot(scene, result.scene).value_or(""), "");
  }
}

}  // namespace
}  // namespace halfspace::test
