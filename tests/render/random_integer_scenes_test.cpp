// Random integer scenes, dot for dot against the exact oracle. HALFSPACE_RANDOM_BODIES sets how many (seeds 1 ..).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/oracle/describe.hpp"
#include "tests/oracle/exact_oracle.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/render/draw_levels.hpp"

namespace halfspace {
namespace {

std::uint64_t scene_count() {
  const char* text = std::getenv("HALFSPACE_RANDOM_BODIES");
  return text == nullptr ? 2000 : std::strtoull(text, nullptr, 10);
}

// The first dot that differs, in words; empty if none does.
std::string first_difference(const IntegerScene& scene, const std::vector<std::int16_t>& drawn) {
  const std::vector<oracle::Dot> truth = oracle::explain(scene, 0, scene.height);
  int wrong = 0;
  std::string first;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (drawn[i] == truth[i].level || wrong++ > 0) continue;
    first = "dot (" + std::to_string(i % static_cast<std::size_t>(scene.width)) + ", " +
            std::to_string(i / static_cast<std::size_t>(scene.width)) + ") is " + std::to_string(drawn[i]) + ", truth " +
            std::to_string(truth[i].level) + " (body " + std::to_string(truth[i].body) + ", half-space " +
            std::to_string(truth[i].half_space) + ", sheet " + std::to_string(truth[i].sheet) + ")";
  }
  return wrong == 0 ? "" : std::to_string(wrong) + " wrong dots; " + first;
}

TEST(RandomIntegerScenes, AgreeWithTheOracle) {
  const std::uint64_t count = scene_count();
  std::uint64_t refused = 0;
  int failures = 0;
  for (std::uint64_t seed = 1; seed <= count && failures < 5; ++seed) {
    const IntegerScene scene = oracle::random_integer_scene(seed);
    const Shader shader = seed % 2 == 0 ? Shader::isqrt : Shader::jordan;  // both must give the same dots
    const testing::Drawn drawn = testing::draw_levels(scene, shader);
    if (!drawn.refusal.empty()) {
      ++refused;
      EXPECT_NE(drawn.refusal.find("meet"), std::string::npos) << "seed " << seed << ": " << drawn.refusal;
      continue;
    }
    const std::string difference = first_difference(scene, drawn.levels);
    if (difference.empty()) continue;
    ++failures;
    ADD_FAILURE() << "seed " << seed << ": " << difference << "\n" << oracle::describe(scene);
  }
  RecordProperty("refused", static_cast<int>(refused));
  std::printf("%llu random integer scenes, %llu refused because two quadrics of a body meet\n",
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(refused));
}

}  // namespace
}  // namespace halfspace
