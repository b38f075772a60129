#include "tests/oracle/exact_oracle.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "tests/oracle/describe.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::oracle {
namespace {

constexpr const char* plain_light = "light 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -1 0 1 1\n";

// The picture of a description, a character a dot: '.' background, else the level in base 36.
std::vector<std::string> rows_of(const std::string& description) {
  const auto scene = parse_description(description);
  if (!scene) return {"not a description"};
  const std::vector<std::int16_t> levels = draw(*scene, 0, scene->height);
  EXPECT_EQ(levels, draw(*scene, 0, scene->height, {false, false}));
  std::vector<std::string> rows(scene->height);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    rows[i / scene->width] += levels[i] < 0 ? '.' : "0123456789abcdefghijklmnopqrstuvwxyz"[levels[i]];
  }
  return rows;
}

using Rows = std::vector<std::string>;

// x^2 + y^2 + z^2 <= 25 from the front: cos = sqrt(25 - x^2 - y^2) / 5, the level floor(5 cos). The poles (0, 5),
// (3, 4), (5, 0) ... touch the sphere's limb: they show, black.
TEST(ExactOracle, SphereWithPointsOnItsLimb) {
  const std::string sphere = "quadric 1 1 1 0 0 0 0 0 0 -25\n";
  EXPECT_EQ(rows_of(std::string("page 11 11 6 0 0 10 10\n") + plain_light + "body 5 5 0 0 0 10 10\n" + sphere),
            (Rows{".....0.....",  //
                  "..0223220..",  //
                  ".023343320.",  //
                  ".234444432.",  //
                  ".234444432.",  //
                  "03444544430",  //
                  ".234444432.",  //
                  ".234444432.",  //
                  ".023343320.",  //
                  "..0223220..",  //
                  ".....0....."}));
}

// Its complement shows the same surface from inside: lit from the eye, the near half is dark and wins.
TEST(ExactOracle, ComplementTurnsTheNormalRound) {
  EXPECT_EQ(rows_of(std::string("page 5 5 9 0 0 4 4\n") + plain_light +
                    "body 2 2 0 0 0 4 4\nquadric! 1 1 1 0 0 0 0 0 0 -4\n"),
            (Rows{"..0..", ".000.", "00000", ".000.", "..0.."}));
}

// Without its near half (a transparent plane z >= 1 bounds it) the far wall of the hollow is seen, lit.
TEST(ExactOracle, TransparentPlaneOpensAHollow) {
  EXPECT_EQ(rows_of(std::string("page 5 5 9 0 0 4 4\n") + plain_light +
                    "body 2 2 0 0 0 4 4\nquadric! 1 1 1 0 0 0 0 0 0 -4\nplane!t 0 0 1 -1\n"),
            (Rows{".....", ".565.", ".686.", ".565.", "....."}));
}

// Two planes at one depth along x = 0, dark and lit: the first body wins the tie there.
TEST(ExactOracle, FirstBodyWinsATie) {
  const std::string head = std::string("page 5 2 4 0 0 4 1\n") + plain_light;
  const std::string lit = "body 2 0 0 0 0 4 1\nplane! 0 0 1 -5\n";  // z >= 5
  const std::string dark = "body 1 0 3 0 0 4 1\nplane 1 0 1 -3\n";  // (x - 1) + (z - 3) <= 3, seen from behind
  EXPECT_EQ(rows_of(head + lit + dark), (Rows{"33300", "33300"}));
  EXPECT_EQ(rows_of(head + dark + lit), (Rows{"33000", "33000"}));
}

// A cone's apex, where the normal vanishes: ambient alone. A plane along the ray is not hit.
TEST(ExactOracle, ApexIsAmbientAndAPlaneAlongTheRayIsNotHit) {
  const std::string light = "light 1 0 0 0  0 1 0 0  0 0 1 0  0 0 -1 3 7 10\n";
  EXPECT_EQ(rows_of("page 5 3 11 0 0 4 2\n" + light +
                    "body 2 1 0 0 0 4 2\nquadric 1 1 -1 0 0 0 0 0 0 0\nplane! 0 0 1 0\nplane 1 0 0 0\n"),
            (Rows{"777..", "773..", "777.."}));
}

// Only the scissor's dots show; the rows asked for are the page's.
TEST(ExactOracle, ScissorAndRows) {
  const auto scene =
      parse_description(std::string("page 4 4 2 1 1 2 2\n") + plain_light + "body 0 0 0 0 0 3 3\nplane! 0 0 1 0\n");
  ASSERT_TRUE(scene);
  EXPECT_EQ(draw(*scene, 2, 4), (std::vector<std::int16_t>{-1, 1, 1, -1, -1, -1, -1, -1}));
  EXPECT_EQ(explain(*scene, 1, 2)[1], (Dot{1, 0, 0, 0}));
}

// A visible dot outside the box that its body claims is counted, and lost where boxes are trusted.
TEST(ExactOracle, FalseBoxIsReported) {
  const auto scene =
      parse_description(std::string("page 4 1 2 0 0 3 0\n") + plain_light + "body 0 0 0 0 0 2 0\nplane! 0 0 1 0\n");
  ASSERT_TRUE(scene);
  Statistics statistics;
  EXPECT_EQ(draw(*scene, 0, 1, {}, &statistics), (std::vector<std::int16_t>{1, 1, 1, 1}));
  EXPECT_EQ(statistics.outside_box, 1U);
  EXPECT_EQ(draw(*scene, 0, 1, {true, true}), (std::vector<std::int16_t>{1, 1, 1, -1}));
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// Pure GMP and the filter: the same dots, faces and sheets.
TEST(ExactOracle, FilterAgreesWithGmpOnRandomScenes) {
  Statistics filtered, pure;
  std::uint64_t shown = 0;
  for (std::uint64_t seed = 0; seed < testing::trials(400U); ++seed) {
    const IntegerScene scene = random_integer_scene(seed, 16);
    const std::vector<Dot> quick = explain(scene, 0, 16, {true, false}, &filtered);
    ASSERT_EQ(quick, explain(scene, 0, 16, {false, false}, &pure)) << "seed " << seed << "\n" << describe(scene);
    for (const Dot& dot : quick) shown += dot.body >= 0;
  }
  EXPECT_EQ(pure.exact, pure.questions);
  EXPECT_LT(filtered.exact, filtered.questions / 4);
  EXPECT_GT(shown, filtered.dots / 10);
  std::cout << "exact " << percent(filtered.exact, filtered.questions) << " % of " << filtered.questions
            << " questions; " << percent(shown, filtered.dots) << " % of the dots show a face\n";
}

TEST(Describe, ReadsWhatItPrints) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::string text = describe(random_integer_scene(seed));
    const auto scene = parse_description(text);
    ASSERT_TRUE(scene.has_value());
    EXPECT_EQ(describe(*scene), text);
  }
  EXPECT_FALSE(parse_description("plane 1 2 3 4"));
  EXPECT_FALSE(parse_description("body 0 0 0 0 0 9 9\nplane 1 2 3 x"));
}

}  // namespace
}  // namespace halfspace::oracle
