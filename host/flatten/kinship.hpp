// kinship.hpp - quadrics of one group that differ by a constant: a tube's walls, nested shells.
// Family   Those whose first nine coefficients are proportional, as decimals. Members are ratio (F + constant) for a
//          common F; they meet nowhere, except at infinity.
// Parallel Those whose second-order parts are proportional: bores of one plate. They meet in a plane, if at all.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/flatten/real.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

inline constexpr std::size_t no_family = static_cast<std::size_t>(-1);

struct Kinship {
  std::size_t family = no_family;  // numbered within its group
  Real ratio = 1;                  // of the shape as it is placed (placement.cpp): its first coefficient that is not 0
  Real constant = 0;
  // Ranks say what a quadric is (spectrum.hpp). Exact, so that no tolerance is needed to tell a cone from its shells.
  std::size_t squares = 3;           // of the second-order part
  std::size_t rank = 4;              // of all
  std::size_t parallel = no_family;  // numbered within its group
};

// Of a group's quadrics, in their order; without the ratios.
[[nodiscard]] std::vector<Kinship> kinships_of(std::span<const QuadricStatement> quadrics);

}  // namespace halfspace
