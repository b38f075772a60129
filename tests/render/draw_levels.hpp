// draw_levels.hpp - the integer scene through resolver, job and core, as the oracle states it: a level for every dot,
// -1 for background.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/core/engine.hpp"
#include "host/flatten/integer_scene.hpp"

namespace halfspace::testing {

struct Drawn {
  std::vector<std::int16_t> levels;  // row by row; empty when something refused
  std::string refusal;               // the first diagnostic, or the core's status
  DrawResult result;
};

[[nodiscard]] Drawn draw_levels(const IntegerScene& scene, Shader shader = Shader::automatic, std::int32_t stride = 1);

}  // namespace halfspace::testing
