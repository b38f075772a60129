// The shader of strides on random scenes: with a stride of 1 the exact picture, with longer ones the same silhouettes.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/oracle/describe.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/render/compare.hpp"
#include "tests/render/draw_levels.hpp"

namespace halfspace {
namespace {

std::vector<bool> silhouette(const std::vector<std::int16_t>& levels) {
  std::vector<bool> shown(levels.size());
  std::transform(levels.begin(), levels.end(), shown.begin(), [](std::int16_t level) { return level >= 0; });
  return shown;
}

TEST(Stride, OfOneIsExactAndNoneMovesASilhouette) {
  std::uint64_t coarser = 0;
  for (std::uint64_t seed = 1; seed <= testing::random_count(1000) && !HasFailure(); ++seed) {
    const IntegerScene scene = oracle::random_integer_scene(seed);
    const testing::Drawn exact = testing::draw_levels(scene);
    if (!exact.refusal.empty()) continue;
    EXPECT_EQ(testing::draw_levels(scene, Shader::stride, 1).levels, exact.levels) << oracle::describe(scene);
    const testing::Drawn drawn = testing::draw_levels(scene, Shader::stride, 16);
    EXPECT_EQ(silhouette(drawn.levels), silhouette(exact.levels)) << oracle::describe(scene);
    if (drawn.levels != exact.levels) ++coarser;
  }
  EXPECT_GT(coarser, 0U);
}

}  // namespace
}  // namespace halfspace
