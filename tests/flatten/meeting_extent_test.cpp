// How far bodies reach whose quadrics meet: solids with known boxes, and random ones against sampling.
#include "host/flatten/meeting_extent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host/flatten/extent.hpp"
#include "tests/flatten/flatten_fixture.hpp"
#include "tests/oracle/dice.hpp"
#include "tests/oracle/parabolas.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using Coefficients = std::array<double, 10>;

Side quadric(const Coefficients& c, std::size_t family, bool complement = false) {
  Side side{{HalfSpaceKind::quadric, {}}, complement, family};
  for (std::size_t i = 0; i < 10; ++i) side.shape.c[i] = c[i];
  return side;
}

Side plane(double a, double b, double c, double d) {
  return {{HalfSpaceKind::plane, {a, b, c, d}}, false, std::nullopt};
}

std::vector<Side> body(std::initializer_list<Coefficients> inside, std::initializer_list<Coefficients> outside = {}) {
  std::vector<Side> sides;
  for (const Coefficients& c : inside) sides.push_back(quadric(c, sides.size()));
  for (const Coefficients& c : outside) sides.push_back(quadric(c, sides.size(), true));
  return sides;
}

std::vector<Side> with(std::vector<Side> sides, std::initializer_list<Side> more) {
  sides.insert(sides.end(), more.begin(), more.end());
  return sides;
}

// Through three axes: every point x becomes x m.
std::vector<Side> turned(std::vector<Side> sides, const char* degrees) {
  const SineCosine t = sine_cosine_of_degrees(degrees);
  const Matrix4 about_z{{{t.cosine, t.sine, 0, 0}, {-t.sine, t.cosine, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  const Matrix4 about_x{{{1, 0, 0, 0}, {0, t.cosine, t.sine, 0}, {0, -t.sine, t.cosine, 0}, {0, 0, 0, 1}}};
  for (Side& side : sides) side.shape = normalised(transformed(side.shape, product(about_z, about_x)));
  return sides;
}

void expect_box(const std::vector<Side>& sides, const std::array<double, 6>& box, double tolerance = 1e-15) {
  const Extent extent = extent_of(sides);
  EXPECT_FALSE(extent.empty);
  EXPECT_FALSE(extent.unbounded);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(static_cast<double>(extent.box.low[i]), box[2 * i], tolerance) << "low " << i;
    EXPECT_NEAR(static_cast<double>(extent.box.high[i]), box[2 * i + 1], tolerance) << "high " << i;
  }
}

constexpr Coefficients ball{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
constexpr Coefficients along_x{0, 1, 1, 0, 0, 0, 0, 0, 0, -1};
constexpr Coefficients along_y{1, 0, 1, 0, 0, 0, 0, 0, 0, -1};
constexpr Coefficients along_z{1, 1, 0, 0, 0, 0, 0, 0, 0, -1};

Coefficients ball_at(double x, double y, double z, double r) {
  return {1, 1, 1, 0, 0, 0, -x, -y, -z, x * x + y * y + z * z - r * r};
}

TEST(MeetingExtent, SteinmetzOfTwo) { expect_box(body({along_x, along_y}), {-1, 1, -1, 1, -1, 1}); }

TEST(MeetingExtent, SteinmetzOfThree) { expect_box(body({along_x, along_y, along_z}), {-1, 1, -1, 1, -1, 1}); }

TEST(MeetingExtent, SimpleNumbersStaySimple) {
  const Extent extent = extent_of(body({along_x, along_y}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(extent.box.high[i] == 1 && extent.box.low[i] == -1) << i;
}

// About the six axes through opposite edges of a cube. It touches the unit sphere on the three axes of fourth order.
TEST(MeetingExtent, SteinmetzOfSix) {
  // |x|^2 - (x . d)^2 <= 1 for d = (1, 1, 0) / sqrt 2 and so on
  expect_box(body({{.5, .5, 1, -.5, 0, 0, 0, 0, 0, -1},
                   {.5, .5, 1, .5, 0, 0, 0, 0, 0, -1},
                   {1, .5, .5, 0, -.5, 0, 0, 0, 0, -1},
                   {1, .5, .5, 0, .5, 0, 0, 0, 0, -1},
                   {.5, 1, .5, 0, 0, -.5, 0, 0, 0, -1},
                   {.5, 1, .5, 0, 0, .5, 0, 0, 0, -1}}),
             {-1, 1, -1, 1, -1, 1}, 1e-9);
}

TEST(MeetingExtent, Lens) {
  const double r = std::sqrt(0.75);
  expect_box(body({ball_at(.5, 0, 0, 1), ball_at(-.5, 0, 0, 1)}), {-.5, .5, -r, r, -r, r});
}

TEST(MeetingExtent, SmallLensFarAway) {
  const double r = std::sqrt(0.75);
  expect_box(body({ball_at(1000.5, 4000, 0, 1), ball_at(999.5, 4000, 0, 1)}),
             {999.5, 1000.5, 4000 - r, 4000 + r, -r, r}, 1e-9);
}

// Along one of the axes a plane's lines run along the circle's plane, in which both balls are their own mirror images.
TEST(MeetingExtent, LensWithARationalCircle) {
  const double r = std::sqrt(1 - 3.25 / 4);
  for (const double y : {-1.5, -1., 1., 1.5}) {
    for (const double z : {y < 0 ? -2.5 - y : 2.5 - y, y < 0 ? 2.5 + y : y - 2.5}) {
      const double past_y = r * std::abs(z) / std::sqrt(3.25), past_z = r * std::abs(y) / std::sqrt(3.25);
      expect_box(body({ball, ball_at(0, y, z, 1)}),
                 {-r, r, y / 2 - past_y, y / 2 + past_y, z / 2 - past_z, z / 2 + past_z}, 1e-12);
      expect_box(body({ball, ball_at(z, 0, y, 1)}),
                 {z / 2 - past_z, z / 2 + past_z, -r, r, y / 2 - past_y, y / 2 + past_y}, 1e-12);
      expect_box(body({ball, ball_at(y, z, 0, 1)}),
                 {y / 2 - past_y, y / 2 + past_y, z / 2 - past_z, z / 2 + past_z, -r, r}, 1e-12);
    }
  }
}

// Three balls through the origin: their lens ends there, and where two of the spheres turn.
TEST(MeetingExtent, ThreeSpheresMeetInAPoint) {
  const double r = std::sqrt(0.5);
  expect_box(body({ball_at(1, 0, 0, 1), ball_at(0, 1, 0, 1), ball_at(0, 0, 1, 1)}), {0, r, 0, r, 0, r});
}

// A tip in which three cylinders of radius 1 meet: (t, t, t) with 2 t^2 = 1, of which a plane through it cuts off the rest.
TEST(MeetingExtent, TipOfThreeCylinders) {
  const double t = std::sqrt(0.5);
  const Extent extent = extent_of(with(body({along_x, along_y, along_z}), {plane(-1, -1, -1, 2)}));
  EXPECT_NEAR(static_cast<double>(extent.box.low[0]), 2 - 2 * t, 1e-12);
}

TEST(MeetingExtent, BallWithAHoleThroughIt) {
  const double h = std::sqrt(0.75);
  expect_box(body({ball}, {{1, 1, 0, 0, 0, 0, 0, 0, 0, -.25}}), {-1, 1, -1, 1, -h, h});
}

TEST(MeetingExtent, BetweenTheSheetsOfAHyperboloid) {
  // z^2 <= x^2 / 4 + y^2 + 1 in the cylinder x^2 + y^2 <= 4
  const double h = std::sqrt(5.0);
  expect_box(body({{-.25, -1, 1, 0, 0, 0, 0, 0, 0, -1}, {1, 1, 0, 0, 0, 0, 0, 0, 0, -4}}), {-2, 2, -2, 2, -h, h});
}

TEST(MeetingExtent, ConeCutByABall) {
  const double r = std::sqrt(0.5);
  const std::vector<Side> both = body({ball, {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}});
  expect_box(both, {-r, r, -r, r, -1, 1});
  expect_box(with(both, {plane(0, 0, -1, 0)}), {-r, r, -r, r, 0, 1});
}

// They meet in circles of constant z.
TEST(MeetingExtent, ConeInACylinder) {
  expect_box(body({{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, {-1, -1, 1, 0, 0, 0, 0, 0, 0, 0}}), {-1, 1, -1, 1, -1, 1});
}

TEST(MeetingExtent, ParaboloidUnderACone) {
  // z >= x^2 + y^2 and z <= 1 - |(x, y)| / 2 as (z - 1)^2 >= ..., z <= 1: they meet at r^2 = 1 - r / 2
  const double r = (std::sqrt(4.25) - .5) / 2;
  expect_box(with(body({{1, 1, 0, 0, 0, 0, 0, 0, -.5, 0}, {.25, .25, -1, 0, 0, 0, 0, 0, 1, -1}}), {plane(0, 0, 1, -1)}),
             {-r, r, -r, r, 0, 1});
}

TEST(MeetingExtent, TouchingSpheresLeaveAPoint) {
  expect_box(body({ball, ball_at(2, 0, 0, 1)}), {1, 1, 0, 0, 0, 0}, 1e-5);
}

// A cone and a quadric that meet in a solid below z = 0, and touch in (1/2, -1/2, 1): gradients (-2, -2, -2) and (8, 8, 8) there.
TEST(MeetingExtent, PointOfTouchBesideASolid) {
  const Extent extent = extent_of(body({{28, 12, 4, -12, -4, 4, -20, 20, -4, 20},
                                        {2, 2, -1, 0, 0, 0, -2, 0, 0, 2},
                                        {-4, -16, -16, -8, -16, -8, -14, -46, -37, -112}}));
  ASSERT_FALSE(extent.empty || extent.unbounded);
  EXPECT_NEAR(static_cast<double>(extent.box.high[2]), 1, 1e-9);
  EXPECT_LT(extent.box.low[2], -3);
}

TEST(MeetingExtent, OneBallInsideTheOther) { expect_box(body({ball, ball_at(.25, 0, 0, 3)}), {-1, 1, -1, 1, -1, 1}); }

TEST(MeetingExtent, ApartIsEmpty) { EXPECT_TRUE(extent_of(body({ball, ball_at(2.001, 0, 0, 1)})).empty); }

TEST(MeetingExtent, SharedPlaneOfTwoPairs) {
  // x y <= 0, x z <= 0 in a ball
  expect_box(body({ball, {0, 0, 0, .5, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, .5, 0, 0, 0, 0}}), {-1, 1, -1, 1, -1, 1});
}

TEST(MeetingExtent, EqualQuadrics) { expect_box(body({ball, ball, along_x}), {-1, 1, -1, 1, -1, 1}); }

TEST(MeetingExtent, TurnedWithItsSurfaces) {
  for (const char* degrees : {"0", "30", "45", "33", "90"}) {
    const Extent lens = extent_of(turned(body({ball_at(.5, 0, 0, 1), ball_at(-.5, 0, 0, 1)}), degrees));
    ASSERT_FALSE(lens.empty || lens.unbounded);
    const double t = std::stod(degrees) * 3.14159265358979323846 / 180;
    const double along = std::abs(std::cos(t));
    const double cap = 1 - .5 * along;  // where the ball that ends there turns, if that lies in the other
    const double rim = std::sqrt(.75) * std::abs(std::sin(t));
    EXPECT_NEAR(static_cast<double>(lens.box.high[0]), along >= .5 ? cap : rim, 1e-12) << degrees;
  }
}

TEST(MeetingExtent, WithoutEnd) {
  const Coefficients cone{1, 1, -1, 0, 0, 0, 0, 0, 0, 0};
  const Coefficients narrow{4, 4, -1, 0, 0, 0, 0, 0, 0, 0};
  const Coefficients beside{1, 1, 0, 0, 0, 0, -.5, 0, 0, -1};
  for (const auto& sides : {body({cone}, {narrow}), body({along_z, beside}), body({along_z}, {beside}),
                            body({{1, 0, 0, 0, 0, 0, 0, 0, -.5, 0}, ball}, {}), body({}, {ball, along_z})}) {
    const bool has_ball = sides.size() == 2 && sides[1].shape.c[2] == 1 && !sides[1].complement;
    EXPECT_EQ(extent_of(sides).unbounded, !has_ball);
    EXPECT_EQ(extent_of(turned(sides, "33")).unbounded, !has_ball);
  }
}

TEST(MeetingExtent, TheMeetingIsTheOnlyEnd) {
  // Cylinders of different radius, turned, and a cone closed by another one upside down.
  expect_box(body({along_x, {1, 0, 1, 0, 0, 0, 0, 0, 0, -.25}}), {-.5, .5, -1, 1, -.5, .5});
  const std::vector<Side> cones = with(body({{1, 1, -1, 0, 0, 0, 0, 0, -1, -1}, {1, 1, -1, 0, 0, 0, 0, 0, 1, -1}}),
                                       {plane(0, 0, 1, -1), plane(0, 0, -1, -1)});
  expect_box(cones, {-1, 1, -1, 1, -1, 1});
}

TEST(MeetingExtent, SlackIsKept) {
  const std::vector<Side> sides = turned(body({along_x, along_y, along_z}), "33");
  const Extent exact = extent_of(sides);
  for (const double slack : {.25, .01, .0001}) {
    const Extent near = extent_of(sides, slack);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(near.box.high[i] >= exact.box.high[i] && near.box.high[i] <= exact.box.high[i] + slack);
      EXPECT_TRUE(near.box.low[i] <= exact.box.low[i] && near.box.low[i] >= exact.box.low[i] - slack);
    }
  }
}

// --- Random bodies against sampling.

struct RandomMeeting {
  std::vector<Side> sides;

  explicit RandomMeeting(std::uint64_t seed) {
    oracle::Dice dice(seed);
    sides.push_back(quadric(ball_at(0, 0, 0, 2), 0));
    for (std::int64_t n = dice.between(1, 3); n > 0; --n) {
      Coefficients c{};
      for (double& v : c) v = static_cast<double>(dice.between(-2, 2));
      sides.push_back(quadric(c, sides.size(), dice.chance(50)));
    }
    if (dice.chance(40)) sides.push_back(plane(1, static_cast<double>(dice.between(-2, 2)), .5, -.25));
    if (dice.chance(30)) sides = turned(std::move(sides), "33");
  }

  // Negative inside.
  static double value(const Side& side, const std::array<double, 3>& p) {
    const auto& c = side.shape.c;
    const bool is_plane = side.shape.kind == HalfSpaceKind::plane;
    auto sum = static_cast<double>(c[is_plane ? 3 : 9]);
    for (std::size_t i = 0; i < 3; ++i) {
      sum += static_cast<double>(is_plane ? c[i] : 2 * c[6 + i]) * p[i];
      for (std::size_t j = 0; j < 3 && !is_plane; ++j) sum += static_cast<double>(c[quadric_index[i][j]]) * p[i] * p[j];
    }
    return side.complement ? -sum : sum;
  }

  [[nodiscard]] bool holds(const std::array<double, 3>& p) const {
    return std::none_of(sides.begin(), sides.end(), [&](const Side& side) { return value(side, p) > 0; });
  }
};

// How deep inside the half-spaces the body's section with a plane lies, negative if there is one: line by line, all of the plane.
double depth_of_section(const RandomMeeting& body, std::size_t axis, double at) {
  const auto depth_at = [&](double v) {
    std::vector<oracle::Parabola> parabolas;
    for (const Side& side : body.sides) {
      std::array<double, 3> value{};
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<double, 3> p{};
        p[axis] = at;
        p[(axis + 1) % 3] = v;
        p[(axis + 2) % 3] = static_cast<double>(i) - 1;
        value[i] = RandomMeeting::value(side, p);
      }
      parabolas.push_back({(value[0] + value[2]) / 2 - value[1], (value[2] - value[0]) / 2, value[1]});
    }
    return oracle::least_of_largest(parabolas);
  };
  std::vector<std::pair<double, double>> found;  // depth and place
  constexpr int lines = 200;
  for (int i = -lines; i <= lines; ++i) found.emplace_back(depth_at(2.0 * i / lines), 2.0 * i / lines);
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < 10; ++i) {
    auto& [depth, place] = found[i];
    for (double step = 2.0 / lines; step > 1e-12; step /= 2) {
      for (const double v : {place - step, place + step}) {
        const double other = depth_at(v);
        if (other >= depth) continue;
        depth = other;
        place = v;
      }
    }
  }
  return std::min_element(found.begin(), found.end())->first;
}

constexpr double rounding = 1e-13;

TEST(MeetingExtent, HoldsAndTouchesRandomBodies) {
  for (std::uint64_t seed = 1; seed <= testing::trials(50U); ++seed) {
    const RandomMeeting random(seed);
    const Extent extent = extent_of(random.sides);
    EXPECT_FALSE(extent.unbounded) << seed;
    oracle::Dice dice(seed);
    for (int n = 0; n < 5000; ++n) {
      std::array<double, 3> p{};
      for (double& v : p) v = static_cast<double>(dice.between(-20000, 20000)) / 10000;
      if (!random.holds(p)) continue;
      ASSERT_FALSE(extent.empty) << seed;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(p[axis] >= extent.box.low[axis] && p[axis] <= extent.box.high[axis]) << "seed " << seed;
      }
    }
    for (std::size_t axis = 0; axis < 3 && !extent.empty; ++axis) {
      for (const int sign : {-1, 1}) {
        const auto end = static_cast<double>(sign > 0 ? extent.box.high[axis] : extent.box.low[axis]);
        double inside = 1;
        for (const double step : {.002, .0005, .0001, 1e-5, 1e-6}) {
          inside = std::min(inside, depth_of_section(random, axis, end - sign * step));
        }
        EXPECT_LE(inside, rounding) << "seed " << seed << " axis " << axis << " sign " << sign;
        for (const double step : {.0001, .001, .01, .1, .5}) {
          EXPECT_GT(depth_of_section(random, axis, end + sign * step), -rounding)
              << "seed " << seed << " axis " << axis << " sign " << sign << " step " << step;
        }
      }
    }
  }
}

// Endless but for the linear terms of a parabolic cylinder, seen askew.
TEST(MeetingExtent, EndOfSixSides) {
  const std::vector<Side> sides = with(body({{-4, -2, -8, 2, -4, 4, 18, -10, -14, -77.9999},
                                             {2, 8, 8, 4, 8, 4, -6, -6, -9, 16},
                                             {1, 0, 0, 0, 2, 0, -2, 0, 2, 4.000001}},
                                            {{-4, 2, 0, 0, 0, 0, 4, 2, 0, 6.00000001}}),
                                       {plane(-1, -1.0001, 2, 1), plane(-1, 0, 0, 2)});
  const std::vector<const char*> turns =
      testing::sanitized ? std::vector{"33"} : std::vector{"0", "10", "33", "50", "70"};
  for (const char* degrees : turns) {
    EXPECT_FALSE(extent_of(turned(sides, degrees)).unbounded) << degrees;
  }
}

}  // namespace
}  // namespace halfspace
