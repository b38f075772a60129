// The hard cases, each as a text and as integers, in every exact shader, at several sizes and numbers of levels: zero wrong dots, and for
// texts the error of quantisation (docs/hard-cases.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <span>
#include <sstream>

#include "tests/hard/drawing.hpp"
#include "tests/hard/integer_cases.hpp"
#include "tests/hard/quantisation.hpp"
#include "tests/hard/text_cases.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::testing {
namespace {

struct Size {
  std::int32_t width, height;
  std::int64_t unit;  // of an integer case, in dots
};

// The sanitizers see the second and the third.
constexpr Size all_sizes[] = {{1, 40, 1}, {1, 1, 1}, {33, 33, 1}, {40, 1, 1}, {64, 64, 2}, {190, 161, 5}};
constexpr auto sizes = sanitized ? std::span(all_sizes).subspan(1, 2) : std::span(all_sizes);
constexpr std::int32_t level_counts[] = {2, 17, 65, 256};

// Every shader and number of levels beside the oracle.
void check_dots(const IntegerScene& scene) {
  const Lines lines = all_lines(scene);
  Drawing drawing(scene);
  for (const std::int32_t levels : level_counts) {
    const Levels truth = true_levels(scene, levels, lines);
    for (const Shader shader : exact_shaders) {
      const Comparison result = drawing.compare(levels, shader, lines, truth);
      EXPECT_EQ(result.limit + result.wrong, "")
          << scene.width << " x " << scene.height << ", shader " << static_cast<int>(shader);
    }
  }
}

// --- Integers.

class IntegerHardCase : public ::testing::TestWithParam<IntegerCase> {};

TEST_P(IntegerHardCase, IsExact) {
  for (const Size& size : sizes) check_dots(integer_scene(GetParam(), size.width, size.height, size.unit));
}

INSTANTIATE_TEST_SUITE_P(Hard, IntegerHardCase, ::testing::ValuesIn(integer_cases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// --- Texts.

// A row of docs/hard-cases.md: bound and radius in 1/256 dot, levels of 256.
std::string table_row(const std::string& name, const QuantisationError& error) {
  std::array<char, 64> figures;
  std::snprintf(figures.data(), figures.size(), "%.4f | %.4f | %.4f", error.bound * 256, error.radius * 256,
                error.levels);
  return "| " + name + " | " + figures.data() + " |";
}

struct KeptFigures {
  double bound = 0, radius = 0, levels = 0;
};

// Nothing if the case has no row.
std::optional<KeptFigures> kept_figures(const std::string& name) {
  std::ifstream in(HALFSPACE_SOURCE_DIR "/docs/hard-cases.md");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| " + name + " |")) continue;
    std::replace(line.begin(), line.end(), '|', ' ');
    std::istringstream words(line);
    std::string word;
    KeptFigures kept;
    if (!(words >> word >> kept.bound >> kept.radius >> kept.levels)) return std::nullopt;
    return kept;
  }
  return std::nullopt;
}

// The largest page on which the silhouette is promised within 1/256 dot.
double bound_on_a_large_page(const std::string& name) {
  const Flattened flat = flatten_text(name, text_of(name), 4096, 4096);
  EXPECT_EQ(flat.refusal, "");
  return flat.integers.bound;
}

class HardCase : public ::testing::TestWithParam<std::string> {};

TEST_P(HardCase, IsExactAndKeepsItsPromise) {
  QuantisationError error;
  for (const Size& size : sizes) {
    const Flattened flat = flatten_text(GetParam(), text_of(GetParam()), size.width, size.height);
    ASSERT_EQ(flat.refusal, "");
    check_dots(flat.integers);
    IntegerScene finest = flat.integers;
    finest.levels = 256;
    error.extend(quantisation_error(flat.scene, finest, true_levels(finest, 256, all_lines(finest))));
  }
  error.bound = std::max(error.bound, bound_on_a_large_page(GetParam()));
  const std::string row = table_row(GetParam(), error);
  std::printf("%s\n", row.c_str());
  EXPECT_LE(error.bound, 1.0 / 256);
  EXPECT_LE(error.radius, 1.0 / 256);
  const std::optional<KeptFigures> kept = kept_figures(GetParam());
  ASSERT_TRUE(kept) << "docs/hard-cases.md has no row for it";
  // A change in how a scene is rounded moves all figures a little; one that makes them worse is seen.
  constexpr double slack = 0.02;
  EXPECT_LE(error.bound * 256, 2 * kept->bound + slack);
  EXPECT_LE(error.radius * 256, 2 * kept->radius + slack);
  EXPECT_LE(error.levels, 2 * kept->levels + slack);
}

INSTANTIATE_TEST_SUITE_P(Hard, HardCase, ::testing::ValuesIn(text_cases()),
                         [](const auto& tested) { return tested.param; });

TEST(HardCases, AWrongDotIsTold) {
  const Flattened flat = flatten_text("steinmetz_2", text_of("steinmetz_2"), 33, 33);
  const Lines lines = all_lines(flat.integers);
  Levels picture = true_levels(flat.integers, 65, lines);
  EXPECT_EQ(quantisation_error(flat.scene, flat.integers, picture).radius, 0);
  picture[16 * 33 + 16] -= 3;
  EXPECT_NE(Drawing(flat.integers)
                .compare(65, Shader::isqrt, lines, picture)
                .wrong.find("1 wrong dots of 65 levels; dot (16, 16)"),
            std::string::npos);
  EXPECT_EQ(quantisation_error(flat.scene, flat.integers, picture).radius, 1);
}

TEST(HardCases, AreThereBothAsTextAndAsIntegers) {
  std::vector<std::string> names;
  for (const IntegerCase& item : integer_cases()) names.emplace_back(item.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, text_cases());
}

}  // namespace
}  // namespace halfspace::testing
