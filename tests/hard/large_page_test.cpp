// The varian's widest roll, 7040 x 20000 dots: all scan lines on which an arc or a cell begins or ends, their neighbours, and 200 lines
// at random; with HALFSPACE_NIGHTLY set the whole page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tests/hard/drawing.hpp"
#include "tests/hard/integer_cases.hpp"
#include "tests/hard/text_cases.hpp"
#include "tests/oracle/dice.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::testing {
namespace {

// A tenth of each side serves the sanitizers.
constexpr std::int32_t part = sanitized ? 10 : 1, width = 7040 / part, height = 20000 / part, unit = 200 / part;

// 35.2 by 100 units: little of it is filled, as the core shades every line.
const char* const text = R"({ long bars, a ring, a needle, two cones, and planes that meet the page's corners }
quadric rod <400 0 400 0 0 0 6400 0 0 102399>;
plane top <0 1 0 -49.9>;
plane bottom <0 -1 0 -49.9>;
body bar (rod top bottom);
quadric slanted <4 1 5 2 0 0 0 0 0 -.05>;
body stay (slanted top bottom);
quadric rim <1 1 0 0 0 0 -8 -30 0 960>;
quadric eye <1 1 0 0 0 0 -8 -30 0 960.01>;
plane facing <.2 .1 -1 -5>;
body ring (rim !eye facing);
quadric cones <100 -1 100 0 0 0 -1000 30 0 9100>;
body hourglass (cones top bottom);
quadric needle <1e6 1 1e6 0 0 0 0 0 0 -2400>;
body needle (needle);
plane left <-1 0 0 17>;
plane corner <-1 -.35 -1 -.1>;
plane right <1 0 0 -17.6>;
body edge (left corner right);
light glow .2;
light sun .7 .4 .5 -1;
view page dop 0 0 -1 whw 17.6 whh 50;
)";

const IntegerCase integers = {"large page",
                              "body 9 0 0 quadric 400 0 400 0 0 0 0 0 0 -1 body -9 11 0 quadric 400 -1 400 0 0 0 0 0 0 "
                              "0 plane 0 1 0 -30 plane 1 0 0 0 "
                              "body 4 -30 0 quadric 1 1 0 0 0 0 0 0 0 -4 quadric! 1 1 0 0 0 0 0 0 0 -3 plane 1 2 -9 0 "
                              "body 0 0 9 quadric 4 1 5 2 0 0 0 0 0 0 "
                              "body 0 20 0 quadric 1000000 0 1000000 0 0 0 0 5000 0 0 plane 0 -1 0 -70 "
                              "body 0 40 0 plane 20 2 -1 -3 plane 20 -2 -1 -3 plane -20 1 -1 -3 plane 0 0 1 -9 body 12 "
                              "-45 0 sphere 0 0 0 1 plane 1 0 0 -1"};

// Beginnings and ends, their neighbours, and random lines.
Lines chosen_lines(const ResolvedScene& resolved) {
  std::set<std::int32_t> lines = {0, height - 1};
  const auto add = [&lines](std::int32_t y) {
    for (std::int32_t line = std::max(0, y - 1); line <= std::min(height - 1, y + 1); ++line) lines.insert(line);
  };
  for (const Arc& arc : resolved.arcs) add(arc.y0), add(arc.y1);
  for (const Cell& cell : resolved.cells) add(cell.y0), add(cell.y1);
  for (const LineSpan& span : resolved.spans) add(span.y);
  oracle::Dice dice(1985);
  for (int i = 0; i < 200; ++i) lines.insert(static_cast<std::int32_t>(dice.below(height)));
  return {lines.begin(), lines.end()};
}

void check(const IntegerScene& scene) {
  Drawing drawing(scene);
  const Lines lines = std::getenv("HALFSPACE_NIGHTLY") != nullptr ? all_lines(scene) : chosen_lines(drawing.resolved());
  const Levels truth = true_levels(scene, 65, lines);
  for (const Shader shader : exact_shaders) {
    const Comparison result = drawing.compare(65, shader, lines, truth);
    EXPECT_EQ(result.limit + result.wrong, "");
  }
}

TEST(LargePage, OfAText) {
  const Flattened flat = flatten_text("large page", text, width, height);
  ASSERT_EQ(flat.refusal, "");
  EXPECT_LE(flat.integers.bound, 1.0 / 16);
  check(flat.integers);
}

TEST(LargePage, OfIntegers) { check(integer_scene(integers, width, height, unit)); }

}  // namespace
}  // namespace halfspace::testing
