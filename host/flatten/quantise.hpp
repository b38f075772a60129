// quantise.hpp - one half-space of the page becomes integers that are what it was: classified, then rounded.
// Frame    Dot frame: x, y name dot centres (page - 1/2), z page depth; all in dots.
// Bound    No point of the surface within the box is moved by more than `bound` dots; docs/flatten.md has the proof.
// Target   2^-14 dot for boxes up to 1024 dots across, growing with the square of the size: 2^-10 at 4096 dots,
//          1/16 at 32767. The integers are the smallest power-of-two scale that meets it.
#pragma once

#include <optional>

#include "host/flatten/extent.hpp"
#include "host/flatten/integer_form.hpp"

namespace halfspace {

// Coefficients in the proportion of integers up to here are taken as they are.
inline constexpr int small_quadric_bits = 32;

struct Quantised {
  IntegerForm form;  // in the dot frame of the page
  Real bound = 0;
};

// `inverse` takes the dot frame to the half-space's own; `box` is finite. None where no scale below 2^400 meets the
// target, or where the box lies too far away for its size (local_box.hpp).
[[nodiscard]] std::optional<Quantised> quantise(const RealHalfSpace& half_space, const Matrix4& inverse,
                                                const Box& box);

// How far the integer plane lies from the true one within a box, whichever way either is written.
[[nodiscard]] Real plane_distance(const IntegerForm& plane, const RealHalfSpace& truth, const Box& box);

}  // namespace halfspace
