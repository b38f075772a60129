// The window fitted into the device: scale, centre, letterbox, pixel aspect and auto-scaling.
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

struct Dots {
  int x0, y0, x1, y1;
  bool operator==(const Dots&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Dots& d) {
  return out << d.x0 << ' ' << d.y0 << ' ' << d.x1 << ' ' << d.y1;
}

Dots scissor_of(const IntegerScene& scene) {
  return {scene.scissor.x0, scene.scissor.y0, scene.scissor.x1, scene.scissor.y1};
}

TEST(Window, IsFittedWholeAndCentred) {
  // 4 x 2 into 200 x 200: 50 dots to a unit, 100 dots of height.
  const IntegerScene scene = flat(small_ball + "view v dop 0 0 -1 whw 2 whh 1;", page(200, 200));
  EXPECT_EQ(scissor_of(scene), (Dots{0, 50, 199, 149}));
  EXPECT_NEAR(radius_of(scene.bodies.at(0)), 50, 1e-4);
}

TEST(Window, TakesDotsWhoseCentreIsOnItsBorder) {
  // 201 x 201: the border of the narrow axis runs through the centres of dots 100 - 25 and 100 + 25.
  const IntegerScene scene = flat(small_ball + "view v dop 0 0 -1 whw 201 whh 50;", page(201, 201));
  EXPECT_EQ(scissor_of(scene), (Dots{0, 75, 200, 125}));
}

TEST(Window, BodiesAreClippedToIt) {
  const IntegerBody body = flat(small_ball + "view v dop 0 0 -1 whw .5 whh .25;", page(100, 100)).bodies.at(0);
  EXPECT_EQ((Dots{body.x0, body.y0, body.x1, body.y1}), (Dots{0, 25, 99, 74}));
}

TEST(Window, PixelAspectStretchesOneAxis) {
  FlattenOptions options = page(100, 200);
  options.aspect_numerator = 2;  // dots twice as wide as high
  const IntegerBody body = flat(small_ball + "view v dop 0 0 -1 whw 2 whh 2;", options).bodies.at(0);
  EXPECT_EQ((Dots{body.x0, body.y0, body.x1, body.y1}), (Dots{24, 49, 75, 150}));
}

TEST(Window, MissingHeightFollowsFromTheDeviceAndThePicturesMiddle) {
  const std::string ball = "quadric s <1 1 1 0 0 0 0 -5 0 24>; body b <s>;";  // about (0, 5, 0)
  const IntegerScene scene = flat(ball + "view v vrp 1 0 0 dop 0 0 -1 whw 4;", page(80, 200));
  EXPECT_EQ(scissor_of(scene), (Dots{0, 0, 79, 199}));
  expect_near(centre_of(scene.bodies.at(0)), {30, 100, 0});
}

TEST(Window, MissingWidthFollowsFromTheDeviceAndThePicturesMiddle) {
  const std::string ball = "quadric s <1 1 1 0 0 0 -5 0 0 24>; body b <s>;";  // about (5, 0, 0)
  const IntegerScene scene = flat(ball + "view v vrp 0 1 0 dop 0 0 -1 whh 4;", page(200, 80));
  expect_near(centre_of(scene.bodies.at(0)), {100, 50, 0});
}

// Auto-scaling: the half-size of the picture, in units, along the axis that fills a 1000 x 1000 page.
struct Fit {
  const char* name;
  std::string text;
  double half_size;
};
void PrintTo(const Fit& fit, std::ostream* out) { *out << fit.name; }

class AutoScale : public ::testing::TestWithParam<Fit> {};

TEST_P(AutoScale, FindsTheSilhouette) {
  // A ball of radius 1/8 at the middle of every picture shows the scale.
  const std::string probe = "quadric probe_s <1 1 1 0 0 0 0 0 0 -.015625>; body probe <probe_s>;";
  const std::string front = "view v dop 0 0 -1;";
  const IntegerScene scene = flat(probe + GetParam().text + front, page(1000, 1000));
  EXPECT_NEAR(radius_of(scene.bodies.at(0)), 62.5 / GetParam().half_size, 1e-3);
}

const std::string cube =
    "plane x <1 0 0 -1>; plane xx <1 0 0 1>; plane y <0 1 0 -1>; plane yy <0 1 0 1>; plane z <0 0 1 -1>;"
    "plane zz <0 0 1 1>; body cube <x !xx y !yy z !zz>;";

INSTANTIATE_TEST_SUITE_P(
    Window, AutoScale,
    ::testing::Values(
        Fit{"Ball", "quadric s <1 1 1 0 0 0 0 0 0 -9>; body b <s>;", 3}, Fit{"Cube", cube, 1},
        Fit{"TurnedCube", "definition d;" + cube + "enddef; instance i (d =rz 45);", 1.4142135623730951},
        Fit{"CubeOnItsCorner", "definition d;" + cube + "enddef; instance i (d =rz 45 =rx 35.264389682754654);",
            1.7320508075688772},
        Fit{"Ellipsoid",
            "definition d; quadric s <1 1 1 0 0 0 0 0 0 -1>; body b <s>; enddef;"
            "instance i (d =sx 5 =rz 45);",
            3.6055512754639896},
        // Half a cylinder of radius 1 and half-length 3, lying along the diagonal.
        Fit{"TurnedCylinder",
            "definition d; quadric c <0 1 1 0 0 0 0 0 0 -1>; plane p <1 0 0 -3>;"
            "plane q <1 0 0 3>; body b <c p !q>; enddef; instance i (d =rz 45);",
            2.8284271247461901},
        // A cone with its apex at the top, cut at the bottom; balanced by its mirror image.
        Fit{"DoubleCone", "quadric c <4 -1 4 0 0 0 0 0 0 0>; plane p <0 1 0 -2>; plane q <0 1 0 2>; body b <c p !q>;",
            2},
        Fit{"Paraboloids",
            "quadric c <1 0 1 0 0 0 0 .5 0 -1>; quadric d <1 0 1 0 0 0 0 -.5 0 -1>;"
            "plane p <0 1 0 0>; body b <c !p>; body e <d p>;",
            1},
        Fit{"BallCutBeforeItsWidest",
            "quadric s <1 1 1 0 0 0 0 0 0 -25>; plane p <1 0 0 -3>; plane q <1 0 0 3>;"
            "plane r <0 1 0 -4>; plane s4 <0 1 0 4>; body b <s p !q r !s4>;",
            4},
        Fit{"Hole", "quadric s <1 1 1 0 0 0 0 0 0 -25>; quadric h <1 1 0 0 0 0 0 0 0 -1>; body b <s !h>;", 5},
        Fit{"SlabsAsQuadrics",
            "quadric a <1 0 0 0 0 0 0 0 0 -4>; quadric b <0 1 0 0 0 0 0 0 0 -4>;"
            "quadric c <0 0 1 0 0 0 0 0 0 -4>; body box <a b c>;",
            2}),
    [](const auto& suite) { return suite.param.name; });

TEST(Window, ABodyWithoutEndNeedsAWindow) {
  for (const char* body : {"quadric c <1 0 1 0 0 0 0 0 0 -1>; body b <c>;", "plane p <1 0 0 0>; body b <p>;",
                           "quadric s <1 1 1 0 0 0 0 0 0 -1>; body b <!s>;",
                           "quadric h <1 1 -1 0 0 0 0 0 0 -1>; plane p <0 0 1 -1>; body b <h p>;",
                           "quadric h <1 0 1 0 0 0 0 -.5 0 0>; plane p <1 0 0 0>; body b <h p>;",
                           "quadric h <1 -1 1 0 0 0 0 0 0 1>; body b <h>;"}) {
    EXPECT_NE(complaints(body, page(100, 100)).find("body 'b' has no end"), std::string::npos) << body;
    EXPECT_EQ(complaints(std::string(body) + "view v whw 3 whh 3;", page(100, 100)), "") << body;
  }
}

TEST(Window, EndlessBodiesInPerspectiveMayHaveAFiniteSilhouette) {
  // A cylinder that starts before the eye and goes on forever: its far end is a point of the page.
  const std::string text = "quadric c <1 1 0 0 0 0 0 0 0 -1>; plane p <0 0 1 0>; body b <c !p>; view v cop 0 0 -9;";
  const IntegerBody body = flat(text, page(100, 100)).bodies.at(0);
  EXPECT_EQ((Dots{body.x0, body.y0, body.x1, body.y1}), (Dots{0, 0, 99, 99}));
}

TEST(Window, AnEmptySceneIsAnEmptyPage) {
  const FlattenResult result = flatten(scene_of("view v dop 0 0 -1;"), page(100, 100));
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::warning);
  EXPECT_TRUE(result.scene.bodies.empty());
}

TEST(Window, EmptyBodiesAreIgnored) {
  const std::string nothing =
      "quadric n <1 1 1 0 0 0 0 0 0 1>; plane a <1 0 0 0>; plane b <1 0 0 -1>; plane y <0 1 0 0>;"
      "plane z <0 0 1 0>; quadric s <1 1 1 0 0 0 0 0 0 -1>; body e <n>; body f <s !b a>;";
  const IntegerScene scene = flat(small_ball + "view v dop 0 0 -1;", page(100, 100));
  EXPECT_NEAR(radius_of(scene.bodies.at(0)), 50, 1e-4);
}

}  // namespace
}  // namespace halfspace
