// flatten.hpp - a scene and a device in, the integer scene out.
// Errors   In `diagnostics`, all that were found; the scene is only complete if none is worse than a warning.
// Cost     Linear in the placed bodies.
// Source   Ressler chapter 3; docs/flatten.md.
#pragma once

#include <cstdint>
#include <string>

#include "host/flatten/integer_scene.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

struct FlattenOptions {
  std::int32_t width = 0, height = 0;                         // dots, 1 .. 32767
  std::int32_t levels = 2;                                    // 2 .. 256
  std::int32_t aspect_numerator = 1, aspect_denominator = 1;  // width / height of a dot; positive
  std::string view_id;                                        // empty: the last one defined, else the automatic one
  bool boxes = true;  // of the bodies' integers, which drawing does not need; else each is the scissor
};

struct FlattenResult {
  IntegerScene scene;
  Diagnostics diagnostics;
};

[[nodiscard]] FlattenResult flatten(const Scene& scene, const FlattenOptions& options);

}  // namespace halfspace
