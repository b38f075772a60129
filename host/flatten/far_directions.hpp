// far_directions.hpp - whether a body is certain to have an end in whatever direction, told in doubles.
// Method  A body is endless along d only if no half-space forbids d: a plane does where n d > 0, a quadric where d Q d > 0. Directions
//         and their opposites are the points of three faces of a cube; a part of a face is done with when some half-space forbids all of
//         it and some all of its opposite, and is else cut into four.
// Exact   A value of T in size, of at most 21 terms of at most three factors, each known to 2^-52, is off by less than 2^-46 T, and by
//         less than 2^-900 where a coefficient is too small for a double: twice that and more must be left.
// Cost    Some thirty parts for a cylinder between two planes.
#pragma once

#include <span>

#include "host/flatten/extent.hpp"

namespace halfspace {

// False: it may be endless, or ends so that doubles cannot tell.
[[nodiscard]] bool certainly_ends(std::span<const Side> sides);

}  // namespace halfspace
