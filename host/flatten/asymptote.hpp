// asymptote.hpp - a quadric that rays along z meet but once, as squares that stay so when they are rounded.
// Rounded squares would leave a z^2, and with it a second sheet far away, perhaps in front of everything. Lagrange's reduction keeps
// it out: with p and t at right angles in the page the second-order part is 2 b p (z + ...) + w t^2, and
//   2 b p g = b / 2 (g + p)^2 - b / 2 (g - p)^2
// has two squares of one weight, whose forms have the same z and so round it alike.
#pragma once

#include <optional>

#include "host/flatten/ranked_squares.hpp"

namespace halfspace {

// Of the second-order part: what counts as 0 beside it.
[[nodiscard]] Real zero_beside(const RealHalfSpace& quadric);

// Has the second-order part no z^2, but another term in z?
[[nodiscard]] bool is_asymptotic(const RealHalfSpace& quadric);

// Of an asymptotic quadric; the normals are not orthonormal. None as in ranked_squares.hpp.
[[nodiscard]] std::optional<RankedSquares> squares_along_asymptote(const RealHalfSpace& quadric, const Kinship& kin);

}  // namespace halfspace
