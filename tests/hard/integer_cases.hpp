// integer_cases.hpp - every hard case once more with coefficients that are integers already, so that it is degenerate
// exactly, whatever the flattener does.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::testing {

// A text of words and numbers, in units from the page's middle: x right, y down, z into the scene.
//   light LX LY LZ AMBIENT PARALLEL UNIT     otherwise 4 -5 -8  1 4 5
//   eye F                                    perspective: half-spaces are given in (x, y, w) from the eye; the page is at w = F
//   body X Y Z                               its origin; then its half-spaces
//   plane|quadric|sphere[!][=t] ...           4, 10 numbers; or centre and squared radius; ! a complement, =t transparent
struct IntegerCase {
  const char* name;
  const char* text;
};

inline void PrintTo(const IntegerCase& item, std::ostream* out) { *out << item.name; }

[[nodiscard]] const std::vector<IntegerCase>& integer_cases();

// On a page of that size, `unit` dots to a unit. Throws std::invalid_argument where the text is not of that form.
[[nodiscard]] IntegerScene integer_scene(const IntegerCase& item, std::int32_t width, std::int32_t height,
                                         std::int64_t unit);

}  // namespace halfspace::testing
