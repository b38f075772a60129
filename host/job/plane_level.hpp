// plane_level.hpp - the one level of a planar face, decided exactly (integer_scene.hpp, IntegerLighting).
#pragma once

#include "host/flatten/integer_scene.hpp"

namespace halfspace {

[[nodiscard]] int plane_level(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& plane);

}  // namespace halfspace
