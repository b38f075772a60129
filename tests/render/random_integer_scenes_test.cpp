// Random integer scenes, dot for dot against the exact oracle. HALFSPACE_RANDOM_BODIES sets how many (seeds 1 ..).
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/oracle/describe.hpp"
#include "tests/oracle/random_scenes.hpp"
#include "tests/render/compare.hpp"
#include "tests/render/draw_levels.hpp"

namespace halfspace {
namespace {

TEST(RandomIntegerScenes, AgreeWithTheOracle) {
  const std::uint64_t count = testing::random_count(2000);
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
    const std::string difference = testing::first_difference(scene, drawn.levels);
    if (difference.empty()) continue;
    ++failures;
    ADD_FAILURE() << "seed " << seed << ": " << difference << "\n" << oracle::describe(scene);
  }
  std::printf("%llu random integer scenes, %llu refused because two quadrics of a body meet\n",
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(refused));
}

}  // namespace
}  // namespace halfspace
