// ellipsoid_extent.hpp - how far an ellipsoid reaches, at once: value(x) = (x - m) A (x - m) - r is 0 at m +- sqrt(r (A^-1)_ii) furthest
// along axis i.
// Which    Those with all three a_ii above 2^-16 of the largest coefficient and det A above 2^-20 of their product. By Hadamard, and as
//          scaling A to a diagonal of ones leaves a trace of 3, their least eigenvalue is above 2^-22 of the least a_ii: so 113 bits
//          keep 90 of every term here, and extent.cpp would find them without a direction to infinity too.
#pragma once

#include <optional>

#include "host/flatten/extent.hpp"

namespace halfspace {

// None: something else, or too near to it.
[[nodiscard]] std::optional<Box> ellipsoid_extent(const Side& side);

}  // namespace halfspace
