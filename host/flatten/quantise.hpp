// quantise.hpp - one half-space of the page becomes integers that are what it was: classified, then rounded.
// Frame    Dot frame: x, y name dot centres (page - 1/2), z page depth; all in dots.
// Bound    No point of the surface within the box is moved by more than `bound` dots; docs/flatten.md has the proof.
// Target   That of the region (local_box.hpp); the integers are the smallest power-of-two scale that meets it.
#pragma once

#include <optional>

#include "host/flatten/integer_form.hpp"
#include "host/flatten/local_box.hpp"

namespace halfspace {

// Coefficients in the proportion of integers up to here are taken as they are.
inline constexpr int small_quadric_bits = 32;

struct Quantised {
  IntegerForm form;  // seen from the middle of the region
  Real bound = 0;
  int bits = 0;  // of its forms' scale, where it is rounded as a sum of squares
};

// `inverse` takes the dot frame to the half-space's own; `region` is finite. None where no scale below 2^400 meets the
// target, or where the region lies too far away for its size (local_box.hpp). A sum of squares gets `least_bits` at least.
[[nodiscard]] std::optional<Quantised> quantise(const RealHalfSpace& half_space, const Matrix4& inverse,
                                                const Region& region, int least_bits = 0);

// A half-space of a group, and the inverse that takes the dot frame to the group's.
struct PlacedShape {
  const RealHalfSpace& shape;
  const Matrix4& inverse;
};

// How far two quadrics lie apart within a region where they are nearly the same, whichever factor either is written with; none
// where the region lies too far away for its size.
[[nodiscard]] std::optional<Real> quadric_distance(const PlacedShape& a, const PlacedShape& truth,
                                                   const Region& region);

// How far the integer plane lies from the true one within a region, whichever way either is written.
[[nodiscard]] Real plane_distance(const IntegerForm& plane, const RealHalfSpace& truth, const Region& region);

}  // namespace halfspace
