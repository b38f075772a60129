// Hard cases, mutated, beside the exact oracle. HALFSPACE_MUTANTS sets how many of each kind (seeds 1 ..); HALFSPACE_NIGHTLY
// alone makes it many.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "tests/hard/drawing.hpp"
#include "tests/hard/integer_cases.hpp"
#include "tests/hard/mutate.hpp"
#include "tests/hard/text_cases.hpp"
#include "tests/oracle/describe.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::testing {
namespace {

using oracle::Dice;

std::uint64_t mutants() {
  if (const char* text = std::getenv("HALFSPACE_MUTANTS")) return std::strtoull(text, nullptr, 10);
  const std::uint64_t count = std::getenv("HALFSPACE_NIGHTLY") != nullptr ? 200000 : 1000;
  return sanitized ? count / 20 : count;
}

struct Tally {
  std::uint64_t drawn = 0, refused = 0, slowest_seed = 0;
  double slowest = 0;  // seconds

  void print(const char* kind) const {
    std::printf("mutated %s: %llu drawn, %llu refused by an error or a limit; slowest: %.2f s, seed %llu\n", kind,
                static_cast<unsigned long long>(drawn), static_cast<unsigned long long>(refused), slowest,
                static_cast<unsigned long long>(slowest_seed));
  }
};

// One number of levels and one shader, in turns.
void check(const IntegerScene& scene, std::uint64_t seed, const std::string& text, Tally& tally) {
  const auto start = std::chrono::steady_clock::now();
  Drawing drawing(scene);
  static constexpr std::array level_counts = {2, 65, 256, 17, 3};
  const std::int32_t levels = level_counts[seed % level_counts.size()];
  const Lines lines = all_lines(scene);
  const Comparison result =
      drawing.compare(levels, exact_shaders[seed % exact_shaders.size()], lines, true_levels(scene, levels, lines));
  ++(result.limit.empty() ? tally.drawn : tally.refused);
  EXPECT_EQ(result.wrong, "") << "seed " << seed << ", page " << scene.width << " x " << scene.height << "\n" << text;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (took.count() > tally.slowest) {
    tally.slowest = took.count();
    tally.slowest_seed = seed;
  }
}

TEST(Mutants, OfTextsAreExact) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= mutants() && !HasFailure(); ++seed) {
    Dice dice(seed);
    const auto index = static_cast<std::size_t>(dice.below(static_cast<std::int64_t>(text_cases().size())));
    const std::string& name = text_cases()[index];
    const std::string text = mutated_text(text_of(name), dice);
    const auto width = static_cast<std::int32_t>(dice.between(1, 48));
    const auto height = static_cast<std::int32_t>(dice.between(1, 48));
    const Flattened flat = flatten_text(name, text, width, height);
    if (!flat.refusal.empty()) {
      ++tally.refused;
      continue;
    }
    check(flat.integers, seed, text, tally);
  }
  tally.print("texts");
}

TEST(Mutants, OfIntegersAreExact) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= mutants() && !HasFailure(); ++seed) {
    Dice dice(seed);
    const auto any_case = [&dice] {
      return integer_cases()[static_cast<std::size_t>(dice.below(static_cast<std::int64_t>(integer_cases().size())))];
    };
    const auto width = static_cast<std::int32_t>(dice.between(1, 48));
    const auto height = static_cast<std::int32_t>(dice.between(1, 48));
    const std::int64_t unit = dice.between(1, 3);
    IntegerScene scene = integer_scene(any_case(), width, height, unit);
    mutate(scene, integer_scene(any_case(), width, height, unit), dice);
    check(scene, seed, oracle::describe(scene), tally);
  }
  tally.print("integers");
}

}  // namespace
}  // namespace halfspace::testing
