// The lighting integers give the cosine that the world's normal has with the light.
#include <cmath>

#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

using Normal = std::array<double, 3>;

// cos at a point of the page, as integer_scene.hpp says.
double cosine(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& h, const Normal& page) {
  const double x = page[0] - 0.5 - static_cast<double>(body.origin[0]);
  const double y = page[1] - 0.5 - static_cast<double>(body.origin[1]);
  const double z = page[2] - static_cast<double>(body.origin[2]);
  std::array<double, 10> c{};
  for (std::size_t i = 0; i < 10; ++i) c[i] = h.c[i].get_d();
  std::array<double, 4> g{c[0], c[1], c[2], c[3]};
  if (h.kind == HalfSpaceKind::quadric) {
    g = {c[0] * x + c[3] * y + c[5] * z + c[6], c[3] * x + c[1] * y + c[4] * z + c[7],
         c[5] * x + c[4] * y + c[2] * z + c[8], c[6] * x + c[7] * y + c[8] * z + c[9]};
  }
  for (std::size_t i = 0; i < 3; ++i) g[3] -= static_cast<double>(body.origin[i]) * g[i];
  const IntegerLighting& lighting = scene.lighting;
  double product = 0;
  double normal_square = 0;
  double light_square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double n = 0;
    for (std::size_t j = 0; j < 4; ++j) n += static_cast<double>(lighting.normal_matrix[i][j]) * g[j];
    const auto l = static_cast<double>(lighting.light[i]);
    product += n * l;
    normal_square += n * n;
    light_square += l * l;
  }
  return (h.complement ? -1 : 1) * product / std::sqrt(normal_square * light_square);
}

double world_cosine(const Normal& n, const Normal& l) {
  const auto dot = [](const Normal& a, const Normal& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return dot(n, l) / std::sqrt(dot(n, n) * dot(l, l));
}

const std::string facet =
    "quadric s <1 1 1 0 0 0 0 0 0 -1>; plane p <.3 -.5 .7 -.1>; body b <s p>; light l 1 .2 .7 -.4;";

void expect_facet_lit(const std::string& view, const FlattenOptions& options, double tolerance = 1e-4) {
  const IntegerScene scene = flat(facet + view, options);
  const IntegerBody& body = scene.bodies.at(0);
  const double expected = world_cosine({.3, -.5, .7}, {.2, .7, -.4});
  EXPECT_NEAR(cosine(scene, body, body.half_spaces.at(1), {0, 0, 0}), expected, tolerance) << view;
}

TEST(Lighting, PlanesAreLitByTheirWorldNormalInEveryView) {
  expect_facet_lit("view v dop 0 0 -1;", page(200, 200));
  expect_facet_lit("view v vrp 0 0 0;", page(200, 200));
  expect_facet_lit("view v dop 1 2 -3 vup 1 0 1;", page(200, 300));
  expect_facet_lit("view v vpn .1 .2 1 dop 1 .3 -1;", page(200, 200));
  expect_facet_lit("view v cop 1 2 -3;", page(200, 200));
  expect_facet_lit("view v cop 1 2 -3 vpn .1 .2 1;", page(2112, 1700));
  expect_facet_lit("view v cop 1 2 -30;", page(2112, 1700));
  expect_facet_lit("view v cop 1 2 -3000;", page(2112, 1700));
  expect_facet_lit("view v cop 1 2 -30;", page(32767, 32767));
  expect_facet_lit("view v cop 1 2 -300000000;", page(2112, 1700));
  expect_facet_lit("view v cop 1 2 -300000000 vpn .2 .1 1;", page(2112, 1700));
  FlattenOptions wide = page(200, 300);
  wide.aspect_numerator = 3;
  wide.aspect_denominator = 2;
  expect_facet_lit("view v dop 1 2 -3;", wide);
  expect_facet_lit("view v cop 1 2 -3;", wide);
}

// Depth is foreshortened: on the page, walls far off differ from each other by less than rounding moves what is near.
TEST(Lighting, FarPlanesKeepTheirNormals) {
  const std::string view = "light l 1 .2 .7 -.4; view v cop 0 0 -1 whw .912345678 whh .912345678;";
  for (const char* distance : {"10", "1e3", "1e5", "1e7", "1e9"}) {
    const std::string end = std::string(distance) + ">; plane ";
    const std::string walls = "plane p <.312345678912 .23456789123 -1.1 " + end +
                              "q <.312345678912 -.1234567891 -1.1 " + end +
                              "r <0 0 1 -1e10>; body b <p r>; body c <q r>;";
    const IntegerScene scene = flat(walls + view, page(64, 64));
    const std::array<double, 2> heights{.23456789123, -.1234567891};
    for (std::size_t i = 0; i < 2; ++i) {
      const double expected = world_cosine({.312345678912, heights[i], -1.1}, {.2, .7, -.4});
      EXPECT_NEAR(cosine(scene, scene.bodies.at(i), scene.bodies[i].half_spaces.at(0), {0, 0, 0}), expected, 2e-4)
          << distance;
    }
  }
}

TEST(Lighting, PlanesOnAPageFarWiderThanTheEyeIsFarKeepTheirNormals) {
  const IntegerScene scene = flat(
      "plane p <.78 -.37 -.61 -.56>; body b <p>; light l 1 .2 .7 -.4; view v cop 0 0 4.483144 whw 29897 whh 63532;",
      page(8, 17));
  const IntegerBody& body = scene.bodies.at(0);
  EXPECT_NEAR(cosine(scene, body, body.half_spaces.at(0), {0, 0, 0}), world_cosine({.78, -.37, -.61}, {.2, .7, -.4}),
              5e-4);
}

TEST(Lighting, SquareDotsSeenStraightHaveTheIdentity) {
  const IntegerScene scene = flat(facet + "view v dop 1 2 -3;", page(200, 200));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) EXPECT_EQ(scene.lighting.normal_matrix[i][j], i == j ? 1 : 0);
  }
}

TEST(Lighting, SmallIntegerLightsStayExact) {
  const IntegerScene scene = flat(small_ball + "light l 1 3 4 -12; view v dop 0 0 -1;", page(200, 200));
  EXPECT_EQ(scene.lighting.light, (std::array<std::int64_t, 3>{3, -4, -12}));
}

TEST(Lighting, ABallIsBrightestTowardsTheLight) {
  // The point of the unit ball towards (2, 1, -2) / 3, seen at 10 dots to a unit.
  const IntegerScene scene = flat(small_ball + straight_view + "light l 1 2 1 -2;", page(200, 200));
  const IntegerBody& body = scene.bodies.at(0);
  EXPECT_NEAR(cosine(scene, body, body.half_spaces.at(0), {100 + 20 / 3., 100 - 10 / 3., -20 / 3.}), 1, 1e-6);
}

TEST(Lighting, AComplementIsLitFromInside) {
  const std::string text = "quadric s <1 1 1 0 0 0 0 0 0 -4>; plane p <1 0 0 0>; body b <s !p>; light l 1 1 0 0;";
  const IntegerScene scene = flat(text + straight_view, page(200, 200));
  const IntegerBody& body = scene.bodies.at(0);
  EXPECT_NEAR(cosine(scene, body, body.half_spaces.at(1), {100, 100, 0}), -1, 1e-9);
}

IntegerLighting lit_by(const std::string& lights) {
  return flat(small_ball + lights + straight_view, page(50, 50)).lighting;
}

TEST(Lighting, DecimalIntensitiesAreExact) {
  const IntegerLighting lighting = lit_by("light a .3; light b .05; light l .65 0 0 -1;");
  EXPECT_EQ(lighting.ambient, 7);
  EXPECT_EQ(lighting.parallel, 13);
  EXPECT_EQ(lighting.unit, 20);
}

TEST(Lighting, OthersAreRoundedTo16Bits) {
  const IntegerLighting lighting = lit_by("light a .33333; light l .5 0 0 -1;");
  EXPECT_EQ(lighting.unit, 65536);
  EXPECT_EQ(lighting.ambient, 21845);
  EXPECT_EQ(lighting.parallel, 32768);
}

TEST(Lighting, TheLastParallelLightIsUsedAndOneIsAlwaysThere) {
  EXPECT_EQ(lit_by("light l 1 1 0 0; light m .5 0 1 0;").light, (std::array<std::int64_t, 3>{0, -1, 0}));
  EXPECT_EQ(lit_by("light a .5;").light, (std::array<std::int64_t, 3>{0, 0, -1}));
  EXPECT_EQ(lit_by("light a .5;").parallel, 2);
}

TEST(Lighting, IntensitiesAreClampedOneByOneAndTheSumWithAWarning) {
  Scene scene = scene_of(small_ball + "light a .5; light b .25; light c .5; light l 1 0 0 -1;" + straight_view);
  scene.lights[0].intensity = {"-.5", -.5};
  scene.lights[3].intensity = {"1e300", 1e300};
  const FlattenResult dim = flatten(scene, page(50, 50));
  EXPECT_TRUE(dim.diagnostics.empty());
  EXPECT_EQ(dim.scene.lighting.ambient * 4, dim.scene.lighting.unit * 3);
  EXPECT_EQ(dim.scene.lighting.parallel, dim.scene.lighting.unit);
  scene.lights[1].intensity = {"7", 7};
  const FlattenResult bright = flatten(scene, page(50, 50));
  ASSERT_EQ(bright.diagnostics.size(), 1U);
  EXPECT_EQ(bright.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(bright.scene.lighting.ambient, bright.scene.lighting.unit);
}

}  // namespace
}  // namespace halfspace
