// What hidden_bodies tells is held against exact arithmetic: its bounds dot by dot, its verdicts by the oracle's pictures.
#include "host/resolve/hidden_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "host/resolve/depth_bounds.hpp"
#include "tests/oracle/describe.hpp"
#include "tests/oracle/exact_oracle.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/resolve/body_maker.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::test {
namespace {

constexpr int rounds = testing::sanitized ? 20 : 300;

// --- bounds ---

// Of the value, negative inside, on a ray and at a depth.
int sign_at(const IntegerHalfSpace& h, std::int64_t x_dot, std::int64_t y_dot, double depth) {
  const mpq_class x(static_cast<long>(x_dot)), y(static_cast<long>(y_dot)), z(depth);
  mpq_class value;
  if (h.kind == HalfSpaceKind::plane) {
    value = h.c[0] * x + h.c[1] * y + h.c[2] * z + h.c[3];
  } else {
    value = (h.c[0] * x + 2 * (h.c[3] * y + h.c[5] * z + h.c[6])) * x + (h.c[1] * y + 2 * (h.c[4] * z + h.c[7])) * y +
            (h.c[2] * z + 2 * h.c[8]) * z + h.c[9];
  }
  return h.complement ? -sgn(value) : sgn(value);
}

struct Rectangle {
  std::int64_t x0, y0, x1, y1;

  [[nodiscard]] DotRectangle dots() const {
    const auto half = [](std::int64_t twice) { return static_cast<double>(twice) / 2; };
    return {half(x0 + x1), half(y0 + y1), half(x1 - x0), half(y1 - y0)};
  }
};

Rectangle random_rectangle(Dice& dice, long reach) {
  const long x = dice.between(-reach, reach), y = dice.between(-reach, reach);
  return {x, y, std::min(reach, x + dice.between(0, 6)), std::min(reach, y + dice.between(0, 6))};
}

// Depths in and just within an interval, and just beyond both its ends.
std::vector<double> depths_in(const DepthInterval& i) {
  if (i.empty()) return {};
  const double low = std::max(i.low, -1e6), high = std::min(i.high, 1e6);
  if (low > high) return {};
  return {low, high, low / 2 + high / 2, low * 0.9 + high * 0.1};
}
std::vector<double> depths_outside(const DepthInterval& i) {
  if (i.empty()) return {-1e6, -3, 0, 2.5, 1e6};
  std::vector<double> depths;
  if (std::isfinite(i.low)) depths = {std::nextafter(i.low, -1e300), i.low - 1, i.low - 1e5};
  if (std::isfinite(i.high)) depths.insert(depths.end(), {std::nextafter(i.high, 1e300), i.high + 1, i.high + 1e5});
  return depths;
}

void expect_bounds(const IntegerHalfSpace& h, const Rectangle& r, const HoldingDepths& bounds,
                   const std::string& name) {
  for (std::int64_t y = r.y0; y <= r.y1; ++y) {
    for (std::int64_t x = r.x0; x <= r.x1; ++x) {
      for (const double z : depths_outside(bounds.may)) ASSERT_GT(sign_at(h, x, y, z), 0) << name << " at " << z;
      for (const double z : depths_in(bounds.must)) {
        if (z >= bounds.hole.low && z <= bounds.hole.high) continue;
        ASSERT_LE(sign_at(h, x, y, z), 0) << name << " at " << z;
      }
      if (bounds.hole.empty()) continue;
      for (const double z : depths_outside(bounds.hole)) ASSERT_LE(sign_at(h, x, y, z), 0) << name << " at " << z;
    }
  }
}

// Every kind of half-space, its coefficients as they are, or so large that nothing is a whole double any more.
TEST(DepthForm, BoundsHoldOnEveryDot) {
  constexpr long reach = 20;
  int told = 0;
  for (int seed = 1; seed <= 3 * rounds; ++seed) {
    Dice dice(static_cast<std::uint64_t>(seed));
    for (IntegerHalfSpace h : random_body(dice, 3)) {
      if (dice.one_in(3)) {
        for (mpz_class& c : h.c) c = (c << 90) + dice.between(-2, 2);
      }
      const DepthForm form(h, reach, reach);
      const Rectangle r = random_rectangle(dice, reach);
      const HoldingDepths bounds = form.over(r.dots());
      expect_bounds(h, r, bounds, "seed " + std::to_string(seed));
      if (HasFatalFailure()) return;
      told += bounds.may.empty() || std::isfinite(bounds.may.low) || std::isfinite(bounds.may.high) ? 1 : 0;
      const DotRectangle outline = form.silhouette();
      const DotRectangle dots = r.dots();
      if (std::abs(dots.x - outline.x) > outline.half_x + dots.half_x ||
          std::abs(dots.y - outline.y) > outline.half_y + dots.half_y) {
        for (const double z : {-1e4, -7.0, -0.5, 0.0, 1.0, 12.0, 1e4}) {
          ASSERT_GT(sign_at(h, r.x0, r.y0, z), 0) << "seed " << seed << ": outside the silhouette";
        }
      }
    }
  }
  EXPECT_GT(told, 3 * rounds);
}

TEST(DepthForm, TellsNothingOfCoefficientsTooFarApart) {
  IntegerHalfSpace h = sphere(0, 0, 0, 100);
  h.c[9] <<= 500;
  const HoldingDepths bounds = DepthForm(h, 20, 20).over({0, 0, 1, 1});
  EXPECT_EQ(bounds.may.low, -no_bound);
  EXPECT_EQ(bounds.may.high, no_bound);
  EXPECT_TRUE(bounds.must.empty());
}

TEST(DepthForm, OfZeroHoldsEverywhere) {
  const HoldingDepths bounds = DepthForm(plane(0, 0, 0, 0), 20, 20).over({0, 0, 1, 1});
  EXPECT_EQ(bounds.must.low, -no_bound);
  EXPECT_EQ(bounds.must.high, no_bound);
}

TEST(DepthForm, SilhouetteOfASphereIsNearlyTight) {
  const DotRectangle s = DepthForm(sphere(3, -4, 5, 100), 20, 20).silhouette();
  EXPECT_NEAR(s.x, 3, 1e-6);
  EXPECT_NEAR(s.y, -4, 1e-6);
  EXPECT_NEAR(s.half_x, 10, 1e-6);
  EXPECT_NEAR(s.half_y, 10, 1e-6);
}

// --- verdicts ---

IntegerScene page(int width, int height) {
  IntegerScene scene = page_with({}, width, height);
  scene.bodies.clear();
  return scene;
}

void add(IntegerScene& scene, std::array<std::int64_t, 3> origin, std::vector<IntegerHalfSpace> half_spaces) {
  IntegerBody& body = scene.bodies.emplace_back();
  body.origin = origin;
  body.half_spaces = std::move(half_spaces);
}

std::size_t count_of(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

TEST(HiddenBodies, BehindOneAnother) {
  IntegerScene scene = page(64, 64);
  add(scene, {32, 32, 900}, {sphere(0, 0, 0, 400)});  // behind both
  add(scene, {32, 32, 0}, {sphere(0, 0, 0, 900)});
  add(scene, {32, 32, 500}, {plane(0, 0, -1, 0)});  // all that is deeper
  EXPECT_EQ(hidden_bodies(scene), (std::vector<bool>{true, false, false}));
}

// By two together, neither of which does alone.
TEST(HiddenBodies, BehindSeveral) {
  IntegerScene scene = page(64, 64);
  add(scene, {32, 32, 0}, {plane(1, 0, 0, 0), plane(0, 0, -1, 0)});
  add(scene, {32, 32, 0}, {plane(-2, 0, 0, -1), plane(0, 0, -1, 0)});
  add(scene, {32, 32, 90}, {sphere(0, 0, 0, 400)});
  EXPECT_EQ(hidden_bodies(scene), (std::vector<bool>{false, false, true}));
}

TEST(HiddenBodies, NotBehindWhatShowsNoFace) {
  const std::vector<IntegerHalfSpace> ball{sphere(0, 0, 0, 400)};
  for (const std::vector<IntegerHalfSpace>& front : {
           std::vector{plane(0, 0, 1, 0)},                                           // the eye is inside
           std::vector{transparent(plane(0, 0, -1, 0))},                             // no face at all
           std::vector{transparent(plane(0, 0, -1, 0)), sphere(0, 0, 0, 40000)},     // entered unseen
           std::vector{complement_of(sphere(0, 0, 0, 100))},                         // the eye is inside
           std::vector{sphere(0, 0, 0, 900), complement_of(sphere(0, 0, 0, 1000))},  // nothing is left
       }) {
    IntegerScene scene = page(64, 64);
    add(scene, {32, 32, 0}, front);
    add(scene, {32, 32, 300}, ball);
    EXPECT_FALSE(hidden_bodies(scene)[1]);
  }
  // A shell hides what is behind its far side, and what is inside.
  IntegerScene scene = page(64, 64);
  add(scene, {32, 32, 0}, {sphere(0, 0, 0, 10000), complement_of(sphere(0, 0, 0, 8100))});
  add(scene, {32, 32, 0}, ball);
  EXPECT_TRUE(hidden_bodies(scene)[1]);
}

TEST(HiddenBodies, OffTheWindow) {
  IntegerScene scene = page(64, 64);
  add(scene, {320, 32, 0}, {sphere(0, 0, 0, 400)});
  add(scene, {32, 32, 0}, {sphere(0, 0, 0, 400)});
  EXPECT_EQ(hidden_bodies(scene), (std::vector<bool>{true, false}));
}

// Bodies of random scenes, all kinds, thrown on one page at random depths: none that the oracle shows is hidden.
IntegerScene crowd(std::uint64_t seed) {
  Dice dice(seed);
  IntegerScene scene = oracle::random_integer_scene(seed);
  scene.width = static_cast<std::int32_t>(dice.between(1, 80));
  scene.height = static_cast<std::int32_t>(dice.between(1, 80));
  scene.scissor = {0, 0, scene.width - 1, scene.height - 1};
  scene.bodies.clear();
  const long depth = dice.between(1, 300);
  const long count = dice.between(2, 40);
  for (long i = 0; i < count; ++i) {
    for (IntegerBody& body : oracle::random_integer_scene(seed * 1000 + static_cast<std::uint64_t>(i)).bodies) {
      body.origin = {dice.between(-20, scene.width + 20), dice.between(-20, scene.height + 20),
                     dice.between(-depth, depth)};
      body.x0 = body.y0 = 0;
      body.x1 = scene.width - 1;
      body.y1 = scene.height - 1;
      scene.bodies.push_back(std::move(body));
    }
  }
  return scene;
}

TEST(HiddenBodies, OfRandomCrowdsAreSeenNowhere) {
  std::size_t hidden = 0, unseen = 0;
  for (int seed = 1; seed <= rounds; ++seed) {
    const IntegerScene scene = crowd(static_cast<std::uint64_t>(seed));
    const std::vector<bool> verdict = hidden_bodies(scene);
    std::vector<bool> seen(scene.bodies.size());
    for (const oracle::Dot& dot : oracle::explain(scene, 0, scene.height)) {
      if (dot.body < 0) continue;
      ASSERT_FALSE(verdict[static_cast<std::size_t>(dot.body)]) << "seed " << seed << ", body " << dot.body << "\n"
                                                                << oracle::describe(scene);
      seen[static_cast<std::size_t>(dot.body)] = true;
    }
    hidden += count_of(verdict);
    unseen += scene.bodies.size() - count_of(seen);
  }
  EXPECT_GT(hidden, unseen / 3);
}

}  // namespace
}  // namespace halfspace::test
