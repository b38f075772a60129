// hidden_bodies.hpp - bodies that others hide on every dot, told before they are resolved.
// Method   A pyramid of squares over the page. A body that holds at depth z on every dot of a square, and not in front of some depth, has a
//          face no deeper than z on each of them; what lies deeper is hidden there. From front to back, each body is taken down the
//          pyramid: into squares where it may be, and may not be hidden yet. None left: it is hidden.
// Exact    Bounds in doubles that hold every rounding (depth_bounds.hpp): no dot changes, whatever is left out.
// Cost     A body is taken into as many squares as there are bodies at most, 32 .. 256; the smallest are some sixteen a body, of 8 dots or
//          more a side.
#pragma once

#include <vector>

#include "host/flatten/integer_scene.hpp"

namespace halfspace {

// Of each body: is it known to be hidden? Those that cannot be told are not.
[[nodiscard]] std::vector<bool> hidden_bodies(const IntegerScene& scene);

}  // namespace halfspace
