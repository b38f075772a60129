// Random scenes from their text to the dots: the integer picture against the exact oracle, dot for dot, and against the text
// by the promise oracle. HALFSPACE_RANDOM_BODIES sets how many scenes (seeds 1 ..); of those of quadrics that meet, which take
// longer, a twentieth.
#include <gtest/gtest.h>

#include <cstdio>

#include "host/flatten/flatten.hpp"
#include "host/scene/parse.hpp"
#include "tests/oracle/promise_oracle.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/oracle/solid_extent.hpp"
#include "tests/render/compare.hpp"
#include "tests/render/draw_levels.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

struct Tally {
  std::uint64_t drawn = 0, refused = 0, beyond_limits = 0, broken_bounds = 0;
};

// One scene through everything; failures are reported with its seed and text.
void check(std::uint64_t seed, const std::string& text, Tally& tally) {
  const SourceText source{"seed " + std::to_string(seed), text};
  const ParseResult parsed = parse_uniquadrix(std::span(&source, 1));
  ASSERT_FALSE(has_errors(parsed.diagnostics)) << source.name << ": " << format(parsed.diagnostics.front()) << "\n"
                                               << text;
  const FlattenResult flat = flatten(parsed.scene, {64, 64, seed % 3 == 0 ? 256 : 65, 1, 1, ""});
  if (has_errors(flat.diagnostics)) {
    ++tally.refused;
    return;
  }
  const testing::Drawn drawn = testing::draw_levels(flat.scene, seed % 3 == 0   ? Shader::isqrt
                                                                : seed % 3 == 1 ? Shader::jordan
                                                                                : Shader::contour);
  if (!drawn.refusal.empty()) {
    ++tally.refused;
    if (drawn.refusal.find("draw it smaller") != std::string::npos) {
      ++tally.beyond_limits;
    } else {
      EXPECT_NE(drawn.refusal.find("meet"), std::string::npos) << source.name << ": " << drawn.refusal << "\n" << text;
    }
    return;
  }
  ++tally.drawn;
  EXPECT_EQ(testing::first_difference(flat.scene, drawn.levels), "") << source.name << "\n" << text;
  const oracle::PromiseReport promise = oracle::check_promise(parsed.scene, flat.scene, drawn.levels);
  EXPECT_FALSE(promise.wrong_extent) << source.name << "\n" << text;
  if (!promise.broken.empty()) {
    const oracle::BrokenDot& dot = promise.broken.front();
    ADD_FAILURE() << source.name << ": dot (" << dot.x << ", " << dot.y << ") is " << dot.level << ", the text says "
                  << dot.truth << "\n"
                  << text;
  }
  if (flat.scene.bound > 1.0 / 256) ++tally.broken_bounds;
}

// Four shares, so that two processors have something to do.
constexpr std::uint64_t shares = 4;

class RandomTextScenes : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomTextScenes, KeepTruthAndPromise) {
  Tally tally;
  const std::uint64_t count = testing::random_count(4000);
  for (std::uint64_t seed = 1 + GetParam(); seed <= count && !HasFailure(); seed += shares)
    check(seed, oracle::random_scene(seed), tally);
  std::printf("random texts, share %llu of %llu: %llu drawn, %llu refused, %llu with a bound over 1/256 dot\n",
              static_cast<unsigned long long>(GetParam() + 1), static_cast<unsigned long long>(shares),
              static_cast<unsigned long long>(tally.drawn), static_cast<unsigned long long>(tally.refused),
              static_cast<unsigned long long>(tally.broken_bounds));
  // An eye on a surface that reaches the limit of depth can take more bits than a job holds.
  EXPECT_LE(tally.beyond_limits, 1 + count / 1000);
}

INSTANTIATE_TEST_SUITE_P(Shares, RandomTextScenes, ::testing::Range(std::uint64_t{0}, shares));

// Bodies of quadrics that meet, without a window.
class FittedMeetingScenes : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(FittedMeetingScenes, KeepTruthAndPromise) {
  Tally tally;
  const std::uint64_t count = testing::random_count(20000) / 20;
  for (std::uint64_t seed = 1 + GetParam(); seed <= count && !HasFailure(); seed += shares) {
    check(seed, oracle::random_meeting_scene(seed), tally);
  }
  std::printf("fitted meetings, share %llu of %llu: %llu drawn, %llu refused\n",
              static_cast<unsigned long long>(GetParam() + 1), static_cast<unsigned long long>(shares),
              static_cast<unsigned long long>(tally.drawn), static_cast<unsigned long long>(tally.refused));
  EXPECT_LE(tally.refused, 1 + count / 4);
}

INSTANTIATE_TEST_SUITE_P(Shares, FittedMeetingScenes, ::testing::Range(std::uint64_t{0}, shares));

// An end that is a millionth of the picture too far out is reached by no solid, one a thousandth too near is passed.
TEST(FittedExtent, AWrongOneIsTold) {
  int told = 0;
  constexpr std::uint64_t count = testing::trials(24U);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const SourceText source{"seed", oracle::random_meeting_scene(seed)};
    const Scene scene = parse_uniquadrix(std::span(&source, 1)).scene;
    const std::optional<PictureExtent> right = flatten(scene, {64, 64, 65, 1, 1, ""}).scene.extent;
    if (!right) continue;
    const oracle::TrueScene truth = oracle::true_scene(scene);
    EXPECT_TRUE(oracle::is_extent_of_solids(truth, *right)) << source.text;
    const std::size_t axis = seed % 2;
    const double size = right->high[axis] - right->low[axis];
    for (const double off : {1e-6, -1e-3}) {
      PictureExtent low = *right, high = *right;
      low.low[axis] -= off * size;
      high.high[axis] += off * size;
      EXPECT_FALSE(oracle::is_extent_of_solids(truth, low)) << off << "\n" << source.text;
      EXPECT_FALSE(oracle::is_extent_of_solids(truth, high)) << off << "\n" << source.text;
    }
    ++told;
  }
  EXPECT_GT(told, static_cast<int>(count) / 2);
}

// Scenes that once failed, each for its own reason (the log of this file's history tells).
TEST(KeptTextScenes, StayRight) {
  Tally tally;
  for (const std::uint64_t seed : {185, 187, 203, 802, 916, 1604, 3156, 3663, 3741, 4802, 4882, 6597, 10973})
    check(seed, oracle::random_scene(seed), tally);
}

// Planes a billionth apart in direction, seen along them: what shows lies some 10^9 dots away. In the last two a plane exactly along the
// rays has a body without end.
TEST(KeptTextScenes, PlanesNearlyAlongTheRays) {
  Tally tally;
  for (const std::uint64_t seed : {11125, 14474, 28912, 38183, 44071, 61008})
    check(seed, oracle::random_scene(seed), tally);
  EXPECT_EQ(tally.drawn, 6U);
}

// Surfaces touch in points and end in thin tips, which are ends of the picture that no dot shows.
TEST(KeptTextScenes, FittedToWhatNoDotShows) {
  Tally tally;
  for (const std::uint64_t seed : {589, 2583, 7567, 16284, 20719, 31241, 37254})
    check(seed, oracle::random_meeting_scene(seed), tally);
  for (const std::uint64_t seed : {27226, 43247, 43993, 46199, 53024, 58072})
    check(seed, oracle::random_scene(seed), tally);
  EXPECT_EQ(tally.drawn, 13U);
}

// Shells in perspective that reach their vanishing point.
TEST(KeptTextScenes, ShellsReachTheHorizon) {
  Tally tally;
  for (const std::uint64_t seed :
       {68, 104, 116, 205, 263, 365, 430, 498, 756, 869, 887, 1216, 1419, 1427, 1472, 1504, 1562, 1607, 1796}) {
    check(seed, oracle::random_scene(seed), tally);
  }
  EXPECT_EQ(tally.refused, 0U);
}

}  // namespace
}  // namespace halfspace
