// describe.hpp - an integer scene as a short text, to print a failing case and to keep it as a test.
//   page W H LEVELS x0 y0 x1 y1           the scissor last
//   light M(12, row by row) L(3) AMBIENT PARALLEL UNIT
//   body ox oy oz x0 y0 x1 y1             then its half-spaces
//   plane|quadric[!][t] c0 c1 ...         4 or 10 numbers; ! a complement, t transparent
// Names, positions and bounds are not kept.
#pragma once

#include <optional>
#include <string>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::oracle {

std::string describe(const IntegerScene& scene);

// The scene that `describe` printed; nothing if the text is not of that form.
std::optional<IntegerScene> parse_description(const std::string& text);

}  // namespace halfspace::oracle
