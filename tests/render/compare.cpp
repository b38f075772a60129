#include "tests/render/compare.hpp"

#include <cstdlib>

#include "tests/oracle/exact_oracle.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::testing {

std::string first_difference(const IntegerScene& scene, const std::vector<std::int16_t>& drawn, bool trust_boxes) {
  const std::vector<oracle::Dot> truth =
      oracle::explain(scene, 0, scene.height, {.filter = true, .trust_boxes = trust_boxes});
  int wrong = 0;
  std::string first;
  const auto width = static_cast<std::size_t>(scene.width);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (drawn[i] == truth[i].level || wrong++ > 0) continue;
    first = "dot (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ") is " +
            std::to_string(drawn[i]) + ", truth " + std::to_string(truth[i].level) + " (body " +
            std::to_string(truth[i].body) + ", half-space " + std::to_string(truth[i].half_space) + ", sheet " +
            std::to_string(truth[i].sheet) + ")";
  }
  return wrong == 0 ? "" : std::to_string(wrong) + " wrong dots; " + first;
}

std::uint64_t random_count(std::uint64_t standard) {
  const char* text = std::getenv("HALFSPACE_RANDOM_BODIES");
  return text == nullptr ? (sanitized ? standard / 40 : standard) : std::strtoull(text, nullptr, 10);
}

}  // namespace halfspace::testing
