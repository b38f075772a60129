#include "tests/oracle/promise_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "host/scene/parse.hpp"
#include "tests/oracle/describe.hpp"
#include "tests/oracle/exact_oracle.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/oracle/solid_extent.hpp"

namespace halfspace::oracle {
namespace {

Scene scene_of(const std::string& text) {
  const SourceText source{"test.uq", text};
  ParseResult result = parse_uniquadrix({&source, 1});
  for (const Diagnostic& d : result.diagnostics) {
    if (d.severity != Severity::warning) ADD_FAILURE() << d.position.line << ": " << d.message << "\n" << text;
  }
  return result.scene;
}

std::size_t broken_dots(const std::string& text, const IntegerScene& integers) {
  return check_promise(scene_of(text), integers, draw(integers, 0, integers.height)).broken.size();
}

// A page of 65 x 65 dots and a window of 65 x 65 units: the dot (32, 32) is the origin, a dot is a unit, y is turned.
struct Pair {
  const char* name;
  const char* text;
  const char* integers;
};

constexpr const char* head = "page 65 65 65 0 0 64 64\n";

const Pair pairs[] = {
    {"sphere",
     "quadric s <1 1 1 0 0 0 0 0 0 -625>; body b (s); light .2; light .8 1 2 -2;"
     "view v dop 0 0 -1 whw 32.5 whh 32.5;",
     "light 1 0 0 0  0 -1 0 0  0 0 1 0  1 2 -2  2 8 10\n"
     "body 32 32 0 0 0 64 64\nquadric 1 1 1 0 0 0 0 0 0 -625\n"},
    // (10, 4) turned by 90 degrees is (-4, 10): on the page 4 to the left and 10 up.
    {"turned",
     "definition d; quadric s <1 1 1 0 0 0 -10 -4 0 -28>; plane p <0 1 0 -4>; body b (s p); enddef;"
     "instance (d =rz 90); light .2; light .8 -1 2 -2; view v dop 0 0 -1 whw 32.5 whh 32.5;",
     "light 1 0 0 0  0 -1 0 0  0 0 1 0  -1 2 -2  2 8 10\n"
     "body 28 22 0 0 0 64 64\nquadric 1 1 1 0 0 0 0 0 0 -144\nplane! 1 0 0 0\n"},
    // The sphere of radius 20 seen from 100 before it: (x, y, z) is at (100 x / w, -100 y / w, -10^4 / w), w = z + 100.
    {"perspective",
     "quadric s <1 1 1 0 0 0 0 0 0 -400>; body b (s); light .2; light .8 1 2 -2;"
     "view v cop 0 0 -100 whw 32.5 whh 32.5;",
     "light 100 0 0 0  0 -100 0 0  32 32 0 1  1 2 -2  2 8 10\n"
     "body 32 32 0 0 0 64 64\nquadric 100 100 96 0 0 0 0 0 10000 1000000\nplanet 0 0 1 0\n"},
    // x + z / 2 on the view plane: a cylinder along z is drawn out to the right, its far end clipped at z = 20.
    {"oblique",
     "quadric c <1 1 0 0 0 0 0 0 0 -100>; body b (c); light .2; light .8 1 2 -2;"
     "view v dop 1 0 -2 vpn 0 0 1 whw 32.5 whh 32.5 fbp -10 20;",
     "light 2 0 0 0  0 -2 0 0  1 0 2 0  1 2 -2  2 8 10\n"
     "body 32 32 0 0 0 64 64\nquadric 4 4 1 0 0 -2 0 0 0 -400\nplane 0 0 -1 -10\nplane 0 0 1 -20\n"},
};

IntegerScene integers_of(const Pair& pair) {
  const auto scene = parse_description(std::string(head) + pair.integers);
  EXPECT_TRUE(scene) << pair.name;
  return scene.value_or(IntegerScene{});
}

TEST(PromiseOracle, AcceptsWhatIsTrue) {
  for (const Pair& pair : pairs) EXPECT_EQ(broken_dots(pair.text, integers_of(pair)), 0U) << pair.name;
}

struct Fault {
  const char* name;
  std::function<void(IntegerScene&)> plant;
};

// y turned about the page's middle line, picture and normals alike left as they are.
void swap_y(IntegerScene& scene) {
  for (IntegerBody& body : scene.bodies) {
    body.origin[1] = 64 - body.origin[1];
    for (IntegerHalfSpace& h : body.half_spaces) {
      for (const int i : {3, 4, 7}) h.c[i] = -h.c[i];
      if (h.kind == HalfSpaceKind::plane) h.c[1] = -h.c[1];
    }
  }
}

// x becomes x + 1/2: all coefficients times 4 (2 for planes), then 2 (x + 1/2) = 2 x + 1.
void shift_half_a_dot(IntegerScene& scene) {
  for (IntegerBody& body : scene.bodies) {
    for (IntegerHalfSpace& h : body.half_spaces) {
      auto& c = h.c;
      const bool plane = h.kind == HalfSpaceKind::plane;
      for (mpz_class& n : c) n *= plane ? 2 : 4;
      if (plane) {
        c[3] += c[0] / 2;
      } else {
        c[9] += c[6] + c[0] / 4;
        c[6] += c[0] / 2;
        c[7] += c[3] / 2;
        c[8] += c[5] / 2;
      }
    }
  }
}

TEST(PromiseOracle, ReportsEveryPlantedFault) {
  const Fault faults[] = {
      {"light from behind", [](IntegerScene& s) { s.lighting.light[2] *= -1; }},
      {"light from below", [](IntegerScene& s) { s.lighting.light[1] *= -1; }},
      {"light from the other side", [](IntegerScene& s) { s.lighting.light[0] *= -1; }},
      {"ambient forgotten", [](IntegerScene& s) { s.lighting.ambient = 0; }},
      {"normals not turned",
       [](IntegerScene& s) {
         for (auto& n : s.lighting.normal_matrix[1]) n = -n;
       }},
      {"half a dot aside", shift_half_a_dot},
      {"a dot lower", [](IntegerScene& s) { s.bodies[0].origin[1] += 1; }},
      {"complement lost", [](IntegerScene& s) { s.bodies[0].half_spaces[0].complement = true; }},
      {"last half-space lost", [](IntegerScene& s) { s.bodies[0].half_spaces.pop_back(); }},
      {"3 levels too bright", [](IntegerScene& s) { s.lighting.parallel = 9; }},
  };
  for (const Pair& pair : pairs) {
    for (const Fault& fault : faults) {
      IntegerScene wrong = integers_of(pair);
      fault.plant(wrong);
      const bool unseen = std::string(fault.name) == "last half-space lost" && std::string(pair.name) == "perspective";
      EXPECT_EQ(broken_dots(pair.text, wrong) > 0, !unseen) << pair.name << ": " << fault.name;
    }
  }
}

TEST(PromiseOracle, ReportsAMirroredPicture) {
  IntegerScene mirrored = integers_of(pairs[1]);
  swap_y(mirrored);
  EXPECT_GT(broken_dots(pairs[1].text, mirrored), 0U);
}

// The same picture held against texts that mean another one.
TEST(PromiseOracle, ReportsAnotherText) {
  const IntegerScene turned = integers_of(pairs[1]);
  const std::string text = pairs[1].text;
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  EXPECT_EQ(broken_dots(text, turned), 0U);
  EXPECT_GT(broken_dots(replaced("=rz 90", "=rz -90"), turned), 0U);
  EXPECT_GT(broken_dots(replaced("=rz 90", "=rz 90.3"), turned), 0U);
  EXPECT_GT(broken_dots(replaced("dop 0 0 -1", "dop 0 0 -1 vrp 0 .02 0"), turned), 0U);
  EXPECT_GT(broken_dots(replaced("dop 0 0 -1", "dop 0 0 -1 vup 0 -1 0"), turned), 0U);
  EXPECT_GT(broken_dots(replaced("dop 0 0 -1", "dop 0 0 1"), turned), 0U);
  EXPECT_GT(broken_dots(replaced("<0 1 0 -4>", "<0 1 0 -3.98>"), turned), 0U);
  EXPECT_EQ(broken_dots(replaced("<0 1 0 -4>", "<0 1 0 -3.998>"), turned), 0U);  // within the bound
}

// Without a window the ball fills the page's height.
TEST(PromiseOracle, FitsAPictureWithoutAWindow) {
  const std::string text = "quadric s <1 1 1 0 0 0 -3 -4 0 21>; body b (s); view v dop 0 0 -1;";
  IntegerScene integers;
  integers.width = 80;
  integers.height = 40;
  integers.extent = {{1, -6, -2}, {5, -2, 2}};
  const auto fit = fit_to_page(true_scene(scene_of(text)), integers);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->scale.to_double(), 10);
  EXPECT_EQ(fit->u.to_double(), 3);
  EXPECT_EQ(fit->v.to_double(), 4);
}

// Balls of radius 1 that touch in (2, 3, 0): the solid is that point. A third one aside, and a tip.
TEST(SolidExtent, IsHeldAgainstPointsAndSolids) {
  const std::string point =
      "quadric l <1 1 1 0 0 0 -1 -3 0 9>; quadric r <1 1 1 0 0 0 -3 -3 0 17>; body b (l r);"
      "view v dop 0 0 -1;";
  const std::string ball = "quadric s <1 1 1 0 0 0 1 0 0 0>; body c (s);";
  const auto holds = [](const std::string& text, const PictureExtent& extent) {
    return is_extent_of_solids(true_scene(scene_of(text)), extent);
  };
  EXPECT_TRUE(holds(point, {{2, -3, 0}, {2, -3, 0}}));
  EXPECT_TRUE(holds(ball + point, {{-2, -3, -1}, {2, 1, 1}}));
  EXPECT_FALSE(holds(ball + point, {{-1, -3, -1}, {2, 1, 1}}));      // the ball goes beyond
  EXPECT_FALSE(holds(ball + point, {{-2, -3, -1}, {2.001, 1, 1}}));  // too large
  EXPECT_FALSE(holds(ball + point, {{-2, -3, -1}, {2, 0.999, 1}}));  // too small
}

// Of a ball of radius 1 at the origin the whole is fitted, whatever clipping planes leave.
TEST(SolidExtent, IsNotClipped) {
  const TrueScene scene =
      true_scene(scene_of("quadric s <1 1 1 0 0 0 0 0 0 -1>; body c (s); view v dop 1 2 -2 fbp .5 2;"));
  EXPECT_TRUE(is_extent_of_solids(scene, {{-1, -1, -1}, {1, 1, 1}}));
}

// Of two planes closer than the bound either may be in front; of two further apart only the nearer one.
TEST(PromiseOracle, LetsFacesWithinTheBoundChangePlaces) {
  const auto text = [](const std::string& z) {
    return "plane p <0 0 -1 5>; body b (p); plane q <.1 0 -1 " + z +
           ">; body c (q); light 1 5 0 -1;"
           "view v dop 0 0 -1 whw .6 whh .6;";
  };
  const auto first = parse_description(
      "page 3 3 65 0 0 2 2\nlight 1 0 0 0  0 -1 0 0  0 0 1 0  5 0 -1  0 1 1\n"
      "body 1 1 0 0 0 2 2\nplane 0 0 -1 0\n");
  ASSERT_TRUE(first);
  const std::vector<std::int16_t> levels = draw(*first, 0, 3);
  const auto broken_at_middle = [&](const std::string& z) {
    const PromiseReport report = check_promise(scene_of(text(z)), *first, levels);
    return std::any_of(report.broken.begin(), report.broken.end(),
                       [](const BrokenDot& dot) { return dot.x == 1 && dot.y == 1; });
  };
  EXPECT_FALSE(broken_at_middle("4.999"));
  EXPECT_TRUE(broken_at_middle("4.9"));
}

// Every random text is a scene without errors, and has a meaning.
TEST(RandomScenes, TextsParseAndMeanSomething) {
  int shown = 0, quadrics = 0, perspective = 0, fitted = 0;
  constexpr int count = 300;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const std::string text = random_scene(seed);
    EXPECT_EQ(text, random_scene(seed));
    const Scene scene = scene_of(text);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    const TrueScene truth = true_scene(scene);
    perspective += truth.view.perspective;
    quadrics += text.find("quadric") != std::string::npos;
    fitted += !truth.view.half_width;
    IntegerScene page;
    page.width = page.height = 64;
    const auto fit = fit_to_page(truth, page);
    if (!fit) continue;
    const RayCaster<double> caster(truth, *fit, 64, 64, 65);
    int dots = 0;
    for (int i = 0; i < 64; ++i) dots += caster.shade(i + 0.5, 63.5 - i).has_value();
    shown += dots > 5;
  }
  EXPECT_GT(shown, count / 2);
  EXPECT_GT(quadrics, count / 2);
  EXPECT_GT(perspective, count / 5);
  EXPECT_GT(fitted, count / 20);
}

}  // namespace
}  // namespace halfspace::oracle
