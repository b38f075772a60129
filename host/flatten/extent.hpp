// extent.hpp - how far a body reaches: the box around its silhouette and its depths.
// Method   The box touches the body at a vertex (three planes, or two planes and a quadric), where a section of a
//          plane with a quadric turns, or where a quadric itself does. At each of these points two planes and a
//          surface meet: a curve turns along an axis where the plane of its turning points meets it, and those planes
//          are the polar planes of the axes. So every candidate comes from the line of two planes; those that all
//          half-spaces hold at are the body's. A body in which quadrics may meet goes another way (meeting_extent.hpp).
// Cost     Cubic in the half-spaces of one body.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/flatten/matrix.hpp"

namespace halfspace {

struct Side {
  RealHalfSpace shape;
  bool complement = false;
  // Of a quadric that is no pair of planes: those with the same number never meet (kinship.hpp).
  std::optional<std::size_t> family = std::nullopt;
};

struct Box {
  Vector3 low{}, high{};
};

struct Extent {
  bool empty = true;       // no point of the body was found
  bool unbounded = false;  // the body may reach infinity; `box` holds the points that were found
  Box box;
};

// A side of the box is good enough when it is outside the true one by no more than `slack`, of which intervals of doubles need next to
// nothing; points that they do not find outside the body count as its own.
[[nodiscard]] Extent extent_of(std::span<const Side> sides, Real slack = 0);
// `meet`: quadrics of two families may meet in the body (meeting_extent.hpp).
[[nodiscard]] Extent extent_of(std::span<const Side> sides, Real slack, bool meet);

[[nodiscard]] Box around(const Box& a, const Box& b);

}  // namespace halfspace
