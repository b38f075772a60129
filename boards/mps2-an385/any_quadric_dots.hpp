// any_quadric_dots.hpp - A2's spans, for A4 to fall back on. The face has its surface (make_root_surface).
#pragma once

#include "firmware/core/shade.hpp"

namespace halfspace::mps2 {

void shade_any_quadric(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1);

}  // namespace halfspace::mps2
