// Every scene of the gallery on the varian's full page: zero wrong dots, and the promise to the text kept.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/flatten/flatten.hpp"
#include "host/scene/parse.hpp"
#include "tests/oracle/promise_oracle.hpp"
#include "tests/render/compare.hpp"
#include "tests/render/draw_levels.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

std::vector<std::string> gallery() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(HALFSPACE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".uq") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
  return std::filesystem::path(info.param).stem().string();
}

// The oracles take ten times as long under the sanitizers, which look for other faults: a quarter of each side serves them.
constexpr std::int32_t part = testing::sanitized ? 4 : 1, width = 2112 / part, height = 2200 / part;

class Gallery : public ::testing::TestWithParam<std::string> {};

TEST_P(Gallery, IsExactOnTheVarian) {
  std::ifstream in(GetParam());
  const SourceText source{GetParam(), {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}};
  const ParseResult parsed = parse_uniquadrix(std::span(&source, 1));
  ASSERT_FALSE(has_errors(parsed.diagnostics)) << format(parsed.diagnostics.front());
  const FlattenResult flat = flatten(parsed.scene, {width, height, 65, 1, 1, ""});
  ASSERT_FALSE(has_errors(flat.diagnostics)) << format(flat.diagnostics.front());
  EXPECT_LE(flat.scene.bound, 1.0 / 256);
  const testing::Drawn drawn = testing::draw_levels(flat.scene);
  ASSERT_EQ(drawn.refusal, "");
  EXPECT_EQ(testing::first_difference(flat.scene, drawn.levels), "");
  EXPECT_EQ(testing::draw_levels(flat.scene, Shader::contour).levels, drawn.levels);
  EXPECT_EQ(testing::draw_levels(flat.scene, Shader::isqrt).levels, drawn.levels);
  EXPECT_EQ(testing::draw_levels(flat.scene, Shader::jordan).levels, drawn.levels);
  EXPECT_EQ(testing::draw_levels(flat.scene, Shader::stride, 1).levels, drawn.levels);
  const oracle::PromiseReport promise = oracle::check_promise(parsed.scene, flat.scene, drawn.levels);
  EXPECT_GT(promise.dots, 0U);
  EXPECT_FALSE(promise.wrong_extent);
  EXPECT_TRUE(promise.broken.empty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Gallery, ::testing::ValuesIn(gallery()), name_of);

}  // namespace
}  // namespace halfspace
