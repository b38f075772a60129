// ranked_squares.hpp - a statement's quadric as a sum of squares, of which as many are there as its decimals say.
//   value(x) = sum weight_i (n_i . x + offset_i)^2 + 2 rest . x + constant,     n_i orthonormal, rest _|_ every n_i
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "host/flatten/kinship.hpp"
#include "host/flatten/spectrum.hpp"

namespace halfspace {

struct RankedSquares {
  std::vector<SquareTerm> squares;
  std::optional<Vector3> rest;
  Real constant = 0;
};

// None where 113 bits cannot tell from 0 what the ranks say is there.
[[nodiscard]] std::optional<RankedSquares> ranked_squares_of(const RealHalfSpace& quadric, const Kinship& kin);

// The two planes of a quadric that is their product, or one twice: value = first * second. None for any other.
[[nodiscard]] std::optional<std::array<RealHalfSpace, 2>> plane_pair_of(const RealHalfSpace& quadric,
                                                                        const Kinship& kin);

}  // namespace halfspace
