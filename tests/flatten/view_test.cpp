// Views: inferences and defaults, oblique and perspective projection, clipping planes.
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

const std::string far_ball = "quadric s <1 1 1 0 0 0 0 0 -5 24>; body ball <s>;\n";  // centre (0, 0, 5), radius 1

std::array<double, 3> centre_in(const std::string& view) {
  return centre_of(flat(small_ball + view, page(200, 200)).bodies.at(0));
}

TEST(View, VrpIsTheMiddleOfTheWindow) {
  expect_near(centre_in("view v vrp 1 2 3 dop 0 0 -1 whw 10 whh 10;"), {90, 120, -30});
}

TEST(View, VpnFollowsDopAndVupIsUp) {
  // The eye is on the x axis: y is up, and z, on the left hand of who looks along -x, points right.
  const std::string ball = "quadric s <1 1 1 0 0 0 0 0 -5 24>; body ball <s>;\n";
  const IntegerScene scene = flat(ball + "view v dop 1 0 0 whw 10 whh 10;", page(200, 200));
  expect_near(centre_of(scene.bodies.at(0)), {150, 100, 0});
  const IntegerScene turned = flat(ball + "view v dop 1 0 0 vup 0 0 1 whw 10 whh 10;", page(200, 200));
  expect_near(centre_of(turned.bodies.at(0)), {100, 50, 0});
}

TEST(View, OptionPMeansThePointAtTheTip) {
  const std::string relative = "view v vrp 1 1 1 dop 0 0 -1 vup 0 1 0 whw 10 whh 10;";
  const std::string points = "view v vrp 1 1 1 dop 1 1 0 =p vup 1 2 1 =p whw 10 whh 10;";
  expect_near(centre_in(relative), centre_in(points));
}

TEST(View, LastParameterHolds) {
  expect_near(centre_in("view v vrp 9 9 9 vrp 0 0 0 cop 0 0 -5 dop 0 0 -1 whw 1 whw 10 whh 10;"), {100, 100, 0});
}

TEST(View, LastViewUnlessNamed) {
  const std::string text = small_ball + "view a dop 0 0 -1 whw 10 whh 10; view b vrp 1 0 0 dop 0 0 -1 whw 10 whh 10;";
  FlattenOptions options = page(200, 200);
  expect_near(centre_of(flat(text, options).bodies.at(0)), {90, 100, 0});
  options.view_id = "a";
  expect_near(centre_of(flat(text, options).bodies.at(0)), {100, 100, 0});
  options.view_id = "default";
  EXPECT_EQ(complaints(text, options), "");
  options.view_id = "c";
  EXPECT_EQ(complaints(text, options), "error: no view is named 'c'; there is 'default', 'a', 'b'\n");
}

TEST(View, AutomaticViewIsTheStatedOne) {
  const IntegerBody a = flat(small_ball, page(200, 200)).bodies.at(0);
  const IntegerBody b = flat(small_ball + "view v dop .3 .3 -1;", page(200, 200)).bodies.at(0);
  EXPECT_EQ(a.half_spaces[0].c, b.half_spaces[0].c);
}

// Rays run along -dop = (-1, 0, 1): a point at depth 5 shows 5 units to the right of where it is.
TEST(View, ObliqueRaysShearAlongTheViewPlane) {
  const IntegerBody body = flat(far_ball + "view v vpn 0 0 1 dop 1 0 -1 whw 10 whh 10;", page(200, 200)).bodies.at(0);
  const IntegerHalfSpace& h = body.half_spaces.at(0);
  EXPECT_LT(value_at(body, h, {150, 100, 50}), 0);
  EXPECT_EQ(value_at(body, h, {153, 104, 50}), value_at(body, h, {147, 96, 50}));
  EXPECT_NEAR(value_at(body, h, {160, 100, 50}).get_d(), 0, 1e-4 * mpz_class(abs(h.c[9])).get_d());
}

class Perspective : public ::testing::Test {
 protected:
  // The eye is 10 before the origin, the window lies in the plane z = 0 at 10 dots to a unit.
  const std::string view_ = "view v cop 0 0 -10 whw 10 whh 10;";
  // A world point as the planes x = a, y = b, z = c; where they are 0 on the page.
  static void expect_plane_through(const std::string& plane, const std::array<mpq_class, 3>& point) {
    const std::string text = "plane p <" + plane + ">; quadric s <1 1 1 0 0 0 0 0 0 -25>; body b <s p>;";
    const IntegerBody body = flat(text + "view v cop 0 0 -10 whw 10 whh 10;", page(200, 200)).bodies.at(0);
    const IntegerHalfSpace& h = body.half_spaces.at(1);
    mpz_class size = abs(h.c[0]) + abs(h.c[1]) + abs(h.c[2]);
    EXPECT_LT(abs(value_at(body, h, point).get_d()) / size.get_d(), 1e-3) << plane;
  }
};

// World (2, 1, 5) is at depth w = 15: page x = 100 + 10 * 10 * 2 / 15, y = 100 - 100 / 15, z = -10 * 100 / 15.
TEST_F(Perspective, PointsMapByTheirDepth) {
  const std::array<mpq_class, 3> point{100 + mpq_class(200, 15), 100 - mpq_class(100, 15), mpq_class(-1000, 15)};
  expect_plane_through("1 0 0 -2", point);
  expect_plane_through("0 1 0 -1", point);
  expect_plane_through("0 0 1 -5", point);
  expect_plane_through("1 1 1 -8", point);
}

TEST_F(Perspective, EyePlaneBoundsEveryBodyAndHasNoFace) {
  const IntegerScene scene = flat(far_ball + view_, page(200, 200));
  const IntegerBody& body = scene.bodies.at(0);
  ASSERT_EQ(body.half_spaces.size(), 2U);
  const IntegerHalfSpace& eye = body.half_spaces[1];
  EXPECT_TRUE(eye.transparent);
  EXPECT_LT(value_at(body, eye, {100, 100, -1}), 0);
  EXPECT_EQ(value_at(body, eye, {100, 100, 0}), 0);
}

TEST_F(Perspective, NearerIsSmallerAndInsideStaysInside) {
  const IntegerBody body = flat(far_ball + view_, page(200, 200)).bodies.at(0);
  const IntegerHalfSpace& h = body.half_spaces.at(0);
  const auto depth = [](int w) { return mpq_class(-1000, w); };
  EXPECT_GT(value_at(body, h, {100, 100, depth(13)}), 0);
  EXPECT_LT(value_at(body, h, {100, 100, depth(15)}), 0);
  EXPECT_GT(value_at(body, h, {100, 100, depth(17)}), 0);
  EXPECT_LT(depth(13), depth(17));
}

TEST_F(Perspective, CopIsAbsoluteOrRelativeToVrp) {
  const std::string relative = "view v vrp 1 2 3 cop 0 0 -10 =r whw 10 whh 10;";
  const std::string absolute = "view v vrp 1 2 3 cop 1 2 -7 =a whw 10 whh 10;";
  const auto integers = [](const std::string& view) {
    return flat(far_ball + view, page(200, 200)).bodies.at(0).half_spaces.at(0).c;
  };
  EXPECT_EQ(integers(relative), integers(absolute));
}

TEST_F(Perspective, WindowLiesInThePlaneThroughVrpWhereverTheEyeIs) {
  // Off-axis: vpn along z, the eye to the side. Points of the plane z = 0 keep their place.
  const std::string text =
      "quadric s <1 1 1 0 0 0 0 0 0 -1>; plane p <1 0 0 -.5>; plane q <0 0 1 0>;"
      "body b <s p q>; view v cop 7 3 -10 vpn 0 0 1 whw 10 whh 10;";
  const IntegerBody body = flat(text, page(200, 200)).bodies.at(0);
  EXPECT_EQ(value_at(body, body.half_spaces.at(1), {105, 90, -100}), 0);
  EXPECT_EQ(value_at(body, body.half_spaces.at(2), {103, 80, -100}), 0);
}

TEST(Clipping, PlanesAreOpaqueAndComeLastButTheEye) {
  const std::string text = small_ball + "view v dop 0 0 -1 fbp -.5 .25 whw 10 whh 10;";
  const IntegerBody body = flat(text, page(200, 200)).bodies.at(0);
  ASSERT_EQ(body.half_spaces.size(), 3U);
  const IntegerHalfSpace& front = body.half_spaces[1];
  const IntegerHalfSpace& back = body.half_spaces[2];
  EXPECT_FALSE(front.transparent || back.transparent);
  EXPECT_TRUE(front.complement);
  EXPECT_FALSE(back.complement);
  EXPECT_EQ(value_at(body, front, {3, 4, -5}), 0);
  EXPECT_GT(value_at(body, front, {3, 4, 0}), 0);
  EXPECT_EQ(value_at(body, back, {3, 4, mpq_class(5, 2)}), 0);
  EXPECT_LT(value_at(body, back, {3, 4, 0}), 0);
}

TEST(Clipping, DistancesAreMeasuredFromVrpInPerspective) {
  const std::string text = far_ball + "view v cop 0 0 -10 fbp 4.5 5.25 whw 10 whh 10;";
  const IntegerBody body = flat(text, page(200, 200)).bodies.at(0);
  ASSERT_EQ(body.half_spaces.size(), 4U);
  const mpq_class front = value_at(body, body.half_spaces[1], {3, 4, mpq_class(-2000, 29)});
  EXPECT_NEAR(front.get_d() / body.half_spaces[1].c[2].get_d(), 0, 1e-3);
  EXPECT_TRUE(body.half_spaces[3].transparent);
}

TEST(Clipping, HasNoEffectOnAutoScaling) {
  const auto box = [](const std::string& view) {
    const IntegerScene scene = flat(small_ball + view, page(200, 200));
    return centre_of(scene.bodies.at(0));
  };
  expect_near(box("view v dop 0 0 -1;"), box("view v dop 0 0 -1 fbp -.9 -.8;"));
}

}  // namespace
}  // namespace halfspace
