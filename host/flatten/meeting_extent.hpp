// meeting_extent.hpp - how far a body reaches whose quadrics may meet: along an axis, the outermost plane that it touches.
// Method   The planes u = c that meet the body are intervals of c, whose ends are among the turning points of its surfaces, pairs and
//          triples of them. Boxes of doubles say between which c the outermost end lies and which surfaces matter there
//          (outer_search.hpp); of the intervals between their turning points (turning_points.hpp) one plane each is
//          tried in integers (slice.hpp), the outermost first.
// Larger   Every half-space is moved outwards by about 2^-80 of its terms, each by a little more than the one before. A body of which
//          nothing but a face, an edge or a point is left gets an inside, and surfaces that touch or share a curve cross or
//          come apart, so that no degenerate case is left. The box holds the body. It is too large by some 2^-80 of its size where
//          surfaces cross, by 2^-40 or 2^-20 where they touch; an end is moved to a multiple of 2^-60 of the size, so that a simple
//          number stays simple.
// Endless  Is what passes 2^29 times the size that the coefficients tell.
#pragma once

#include "host/flatten/extent.hpp"

namespace halfspace {

// Two of different families, somewhere in the body? If they do not, extent.cpp's points tell all. Cheap.
[[nodiscard]] bool quadrics_may_meet(std::span<const Side> sides);

// A side is good enough when it is no further off than `slack`. Of a body without end no box is found.
[[nodiscard]] Extent meeting_extent(std::span<const Side> sides, Real slack);

}  // namespace halfspace
