// solid_extent.hpp - whether the box that a picture is fitted to is that of its solids.
// Right   On each side that counts some solid reaches the box, and none goes beyond. Points, edges and faces in which surfaces
//         only touch belong to a solid (docs/flatten.md), though no dot may show them.
// Method  The section of a solid with a plane, line by line along the rays: the point of a line that lies deepest inside all
//         half-spaces is known in closed form (parabolas.hpp). From line to line every local minimum is followed.
// Sure    Of a side that is reached: its witness is a point where no half-space is left by more than `touching` of its largest
//         term. That nothing goes beyond is tried at some distances only.
// Cost    Some ms for a solid.
#pragma once

#include "host/flatten/integer_scene.hpp"
#include "tests/oracle/true_scene.hpp"

namespace halfspace::oracle {

inline constexpr double touching = 1e-9;

// The sides of missing half-sizes count.
[[nodiscard]] bool is_extent_of_solids(const TrueScene& scene, const PictureExtent& extent);

}  // namespace halfspace::oracle
