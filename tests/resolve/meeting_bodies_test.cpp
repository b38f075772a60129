// Bodies in which two or more quadrics meet, in every way that has a name: each face decided at every dot by brute force.
#include <gtest/gtest.h>

#include "host/resolve/resolve.hpp"
#include "tests/resolve/body_maker.hpp"
#include "tests/resolve/brute_force.hpp"

namespace halfspace::test {
namespace {

using Bodies = std::vector<IntegerHalfSpace>;

struct MeetingBody {
  const char* name;
  Bodies half_spaces;
  int size = 48;  // dots
};

void PrintTo(const MeetingBody& body, std::ostream* out) { *out << body.name; }

// The cylinder round the line through (x, y, z) in direction (a, b, c): |v|^2 |w|^2 - (v w)^2 = radius^2 |w|^2.
IntegerHalfSpace cylinder(std::array<long, 3> w, long radius_squared, std::array<long, 3> at = {0, 0, 0}) {
  const long square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  const long along = w[0] * at[0] + w[1] * at[1] + w[2] * at[2];
  std::array<long, 10> c{square - w[0] * w[0], square - w[1] * w[1], square - w[2] * w[2],
                         -w[0] * w[1],         -w[1] * w[2],         -w[0] * w[2]};
  for (std::size_t i = 0; i < 3; ++i) c[6 + i] = along * w[i] - square * at[i];
  c[9] = square * (at[0] * at[0] + at[1] * at[1] + at[2] * at[2] - radius_squared) - along * along;
  return quadric(c);
}

// The cone with its apex at a point and slope m / n round the line in direction w.
IntegerHalfSpace cone(std::array<long, 3> w, long m, long n, std::array<long, 3> at) {
  IntegerHalfSpace result = cylinder(w, 0, at);
  const IntegerHalfSpace axis = sum_of_squares({{w[0], w[1], w[2], -(w[0] * at[0] + w[1] * at[1] + w[2] * at[2])}}, 0);
  for (std::size_t i = 0; i < 10; ++i) result.c[i] = n * result.c[i] - m * axis.c[i];
  return result;
}

IntegerHalfSpace scaled(IntegerHalfSpace h, long factor, long more) {
  for (mpz_class& c : h.c) c *= factor;
  h.c[9] += more;
  return h;
}

std::vector<MeetingBody> cylinders() {
  const IntegerHalfSpace x = cylinder({1, 0, 0}, 225);
  const IntegerHalfSpace y = cylinder({0, 1, 0}, 225);
  const IntegerHalfSpace z = cylinder({0, 0, 1}, 225);
  return {
      {"two equal cylinders", {x, y}},
      {"three equal cylinders", {x, y, z}},
      {"two equal cylinders askew", {cylinder({1, 2, 3}, 150), cylinder({-2, 1, 1}, 150)}},
      {"three equal cylinders askew", {cylinder({1, 2, 2}, 150), cylinder({2, 1, -2}, 150), cylinder({2, -2, 1}, 150)}},
      {"six equal cylinders",
       {cylinder({1, 1, 0}, 200), cylinder({1, -1, 0}, 200), cylinder({1, 0, 1}, 200), cylinder({1, 0, -1}, 200),
        cylinder({0, 1, 1}, 200), cylinder({0, 1, -1}, 200)}},
      {"a thinner cylinder across", {cylinder({1, 2, 3}, 200), complement_of(cylinder({-2, 1, 1}, 60))}},
      {"cylinders whose axes pass each other", {cylinder({1, 2, 3}, 200), cylinder({-2, 1, 1}, 200, {3, 4, -2})}},
      {"cylinders a hair from equal", {scaled(x, 1000, -1), scaled(y, 1000, 0)}},
      {"cylinders a hair from equal askew",
       {scaled(cylinder({1, 2, 3}, 150), 1000, 1), scaled(cylinder({-2, 1, 1}, 150), 1000, 0)}},
      {"parallel cylinders, which share a line at infinity", {y, cylinder({0, 1, 0}, 225, {8, 0, 3})}},
      {"parallel cylinders that touch", {y, complement_of(cylinder({0, 1, 0}, 49, {8, 0, 0}))}},
      {"crossed pipes",
       {x, complement_of(cylinder({1, 0, 0}, 100)), complement_of(cylinder({0, 0, 1}, 64)),
        complement_of(cylinder({1, 1, 0}, 50))}},
      {"a groove along a line", {y, complement_of(cylinder({1, 8, 0}, 40, {0, 0, -15}))}},
  };
}

std::vector<MeetingBody> spheres() {
  const IntegerHalfSpace ball = sphere(0, 0, 0, 225);
  return {
      {"a lens", {ball, sphere(10, 0, 0, 225)}},
      {"a ball with a bite", {ball, complement_of(sphere(10, 4, -9, 100))}},
      {"spheres that touch inside", {ball, complement_of(sphere(5, 0, 0, 100))}},
      {"spheres that touch inside, seen through", {transparent(ball), sphere(3, 4, 0, 100)}},
      {"spheres that touch outside", {ball, sphere(25, 0, 0, 100)}},
      {"spheres that touch towards the eye", {ball, complement_of(sphere(0, 0, -5, 100))}},
      {"equal spheres a hair apart", {scaled(ball, 4096, 0), scaled(sphere(0, 0, 0, 225), 4096, 1)}},
      {"equal spheres a hair askew",
       {quadric({1 << 20, 1 << 20, 1 << 20, 0, 0, 0, 0, 0, 0, -225L << 20}),
        quadric({1 << 20, 1 << 20, 1 << 20, 0, 0, 0, 1, 1, 0, -225L << 20})}},
      {"a sphere tangent to a plane and to a cylinder",
       {ball, plane(0, 0, -1, -15), cylinder({0, 1, 0}, 225), plane(0, 1, 0, -14)}},
      {"a ball in a tube", {complement_of(ball), cylinder({0, 1, 0}, 225), plane(0, 1, 0, -20), plane(0, -1, 0, -20)}},
      {"a ball in a tube askew", {complement_of(ball), cylinder({1, 3, 1}, 225), plane(1, 3, 1, -60)}},
      {"Viviani's window", {sphere(0, 0, 0, 400), cylinder({0, 0, 1}, 100, {10, 0, 0})}},
      {"Viviani's window askew", {sphere(0, 0, 0, 324), cylinder({1, 2, 2}, 81, {6, 3, -6})}},
      {"four balls round a tetrahedron",
       {sphere(5, 5, 5, 250), sphere(-5, -5, 5, 250), sphere(-5, 5, -5, 250), sphere(5, -5, -5, 250)}},
  };
}

std::vector<MeetingBody> others() {
  const IntegerHalfSpace ball = sphere(0, 0, 0, 225);
  const IntegerHalfSpace ellipsoid = quadric({4, 9, 6, 0, 0, 0, 0, 0, 0, -1800});
  return {
      {"concentric ellipsoids", {ellipsoid, quadric({9, 4, 6, 0, 0, 0, 0, 0, 0, -1800})}},
      {"confocal quadrics",
       {quadric({3, 6, 2, 0, 0, 0, 0, 0, 0, -600}), complement_of(quadric({6, -12, 3, 0, 0, 0, 0, 0, 0, -300}))}},
      {"coaxial quadrics", {quadric({1, 2, 1, 0, 0, 0, 0, 0, 0, -300}), cone({0, 1, 0}, 1, 4, {0, -20, 0})}},
      {"a cone with its apex on a sphere", {ball, cone({1, 3, 1}, 1, 2, {0, 15, 0})}},
      {"a cone with its apex on a cylinder", {cylinder({1, 0, 1}, 200), cone({1, 2, 2}, 1, 3, {0, 10, 10})}},
      {"two cones with one apex", {cone({1, 0, 0}, 1, 1, {0, 0, 0}), cone({1, 2, 1}, 1, 1, {0, 0, 0}), ball}},
      {"two cones with a line in common", {cone({1, 0, 0}, 1, 1, {0, 0, 0}), cone({0, 1, 0}, 1, 1, {0, 0, 0}), ball}},
      {"a cylinder and a cone with a line in common",
       {cylinder({0, 1, 0}, 25, {5, 0, 0}), cone({1, 1, 0}, 1, 1, {0, -12, 0}), ball}},
      {"saddles with a line in common",
       {quadric({0, 0, 0, 1, 0, 0, 0, 0, -5, 0}), quadric({0, 0, 0, 0, 1, 0, 4, 0, 0, 0}), ball}},
      {"hyperboloids of one sheet with a line in common",
       {quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, -100}), quadric({1, 2, -1, 0, 0, 0, 0, -10, 0, -100}),
        sphere(0, 0, 0, 400)}},
      {"a hyperboloid of two sheets", {ball, complement_of(quadric({1, 1, -2, 0, 0, 1, 0, 0, 0, 60}))}},
      {"hyperboloids of two sheets",
       {quadric({2, -1, 1, 0, 1, 0, 0, 0, 0, 30}), quadric({1, -2, 1, 1, 0, 0, 0, 0, 3, 40})}},
      {"a paraboloid and a sphere", {quadric({1, 1, 0, 0, 0, 0, 0, 0, -8, -40}), ball}},
      {"paraboloids", {quadric({1, 1, 0, 0, 0, 0, 0, 0, -8, -80}), quadric({1, 2, 0, 1, 0, 0, 3, 0, 9, -90})}},
      {"saddles", {quadric({1, -1, 0, 0, 0, 0, 0, 0, -8, 10}), quadric({0, 0, 0, 1, 0, 0, 3, 0, 9, -90}), ball}},
      {"a parabolic cylinder with rays in it", {quadric({1, 0, 0, 0, 0, 1, 3, 2, 0, -90}), ellipsoid}},
      {"poles through a sphere", {quadric({0, 0, 0, 2, 1, 2, 0, 3, 0, -40}), ball}},
      {"a pair of planes", {ball, sum_of_squares({{1, 2, 2, -3}, {2, 0, -1, 4, -1}}, 0)}},
      {"pairs of planes with a plane in common",
       {quadric({2, 0, 0, 1, 0, -1, 0, 0, 0, 0}), quadric({0, 2, 0, 1, -1, 0, 0, 0, 0, 0}), ball}},
      {"an irrational pair of planes",
       {ball, quadric({1, 0, -2, 0, 0, 0, 0, 1, 0, 0}), quadric({2, 0, -1, 0, 0, 0, 0, 0, 0, 0})}},
      {"a double plane", {ball, complement_of(sum_of_squares({{1, 2, 2, -3}}, 0)), cylinder({1, 0, 0}, 100)}},
      {"one quadric three times", {ellipsoid, scaled(ellipsoid, 3, 0), complement_of(scaled(ellipsoid, -2, 0))}},
      {"only the surface is left", {ellipsoid, complement_of(ellipsoid), cylinder({1, 1, 0}, 100)}},
      {"three quadrics of one pencil",
       {ellipsoid, quadric({9, 4, 6, 2, 0, 0, 4, 0, 0, -1800}), quadric({13, 13, 12, 2, 0, 0, 4, 0, 0, -3600})}},
      {"a quadric and its mirror image",
       {ball, quadric({2, 1, 3, 0, 0, 1, 0, 0, 6, -300}), quadric({2, 1, 3, 0, 0, -1, 0, 0, -6, -300})}},
      {"eight ellipsoids",
       {quadric({4, 9, 6, 1, 0, 2, 9, 0, 0, -1800}), quadric({7, 5, 6, 1, 2, 0, 0, 9, 0, -1800}),
        quadric({6, 4, 9, 0, 1, 2, 0, 0, 9, -1800}), quadric({9, 5, 4, 2, 1, 1, -9, 0, 0, -1800}),
        quadric({5, 8, 7, 1, -2, 0, 0, -9, 0, -1800}), quadric({6, 6, 5, -2, 1, 1, 0, 0, -9, -1800}),
        quadric({8, 6, 5, 1, 1, -2, 5, 5, 0, -1800}), quadric({5, 7, 8, -1, 1, 2, 0, 5, 5, -1800})}},
      {"a box bored by cones",
       {plane(1, 0, 0, -16), plane(-1, 0, 0, -16), plane(0, 1, 2, -30), plane(0, -1, 1, -25), plane(0, 0, -1, -9),
        complement_of(cone({1, 2, 2}, 1, 6, {0, -20, -6})), complement_of(cone({3, -1, 1}, 1, 9, {-9, 0, 4}))}},
      {"a large page",
       {quadric({4, 9, 6, 1, 2, -1, 30, 0, 0, -64000}), cylinder({3, 1, 2}, 4900),
        complement_of(cylinder({1, -3, 1}, 900, {10, 5, 0}))},
       220},
  };
}

class MeetingBodies : public testing::TestWithParam<MeetingBody> {};

TEST_P(MeetingBodies, AreRightOnEveryDot) {
  const IntegerScene scene = page_with(GetParam().half_spaces, GetParam().size, GetParam().size);
  const ResolvedScene resolved = resolve(scene, true);
  EXPECT_EQ(broken_structure(scene, resolved).value_or(""), "");
  EXPECT_EQ(broken_structure(scene, resolve(scene)).value_or(""), "");
  EXPECT_EQ(wrong_dot(scene, resolved).value_or(""), "");
}

// Seen inside out: every complement.
TEST_P(MeetingBodies, AreRightInsideOut) {
  Bodies half_spaces = GetParam().half_spaces;
  for (std::size_t i = 0; i < half_spaces.size(); i += 2) half_spaces[i] = complement_of(half_spaces[i]);
  const IntegerScene scene = page_with(half_spaces, GetParam().size, GetParam().size);
  EXPECT_EQ(wrong_dot(scene, resolve(scene, true)).value_or(""), "");
}

INSTANTIATE_TEST_SUITE_P(Cylinders, MeetingBodies, testing::ValuesIn(cylinders()));
INSTANTIATE_TEST_SUITE_P(Spheres, MeetingBodies, testing::ValuesIn(spheres()));
INSTANTIATE_TEST_SUITE_P(Others, MeetingBodies, testing::ValuesIn(others()));

// An arc's name is its curve's: both cylinders of equal size show plain sections, of equal balls one conic.
TEST(Meeting, CurvesOfSecondOrderStaySo) {
  for (const Bodies& body : {Bodies{cylinder({1, 2, 2}, 150), cylinder({2, 1, -2}, 150)},
                             Bodies{sphere(0, 0, 0, 200), sphere(9, 0, 2, 150)}}) {
    for (const Arc& arc : resolve(page_with(body), true).arcs) EXPECT_TRUE(std::holds_alternative<Curve>(arc.form));
  }
}

TEST(Meeting, AWideArcNeedsFewWindows) {
  const Bodies body{sphere(0, 0, 0, 22500), complement_of(cylinder({0, 0, 1}, 900, {40, 0, 0}))};
  const Bodies curved{quadric({4, 9, 6, 0, 0, 0, 0, 0, 0, -120000}), complement_of(cylinder({1, 0, 3}, 900))};
  std::size_t windows = 0;
  for (const Arc& arc : resolve(page_with(curved, 400, 400)).arcs) windows += arc.guide.windows.size();
  EXPECT_GT(windows, 0U);
  EXPECT_LT(windows, 40U);
  for (const Arc& arc : resolve(page_with(body, 400, 400)).arcs) EXPECT_TRUE(arc.guide.windows.empty());
}

}  // namespace
}  // namespace halfspace::test
