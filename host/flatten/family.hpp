// family.hpp - shells of one family (kinship.hpp) as integers that cannot meet either.
// Rule     All members are  sum +-M_i^2 + 2 U T + N U^2  with the same integer forms M_i, T and their own integer N; U is the
//          integer form of the world's constant 1: 1 itself, or z in perspective (w = -f^2 / z). So the pencil of any two
//          holds U^2, and they meet at U = 0 at most: at infinity, on the horizon.
// Rank     N = 0 where the member's constant is, so a cone stays one between its shells, and the apex of a cylinder or
//          cone lies on the horizon where the true one does.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/flatten/kinship.hpp"
#include "host/flatten/quantise.hpp"

namespace halfspace {

struct FamilyMember {
  RealHalfSpace shape;
  Kinship kin;
};

// All in the dot frame, within one region. `inverse` and `least_bits` are as in quantise.hpp, the place is theirs in common.
[[nodiscard]] std::optional<std::vector<Quantised>> quantise_family(std::span<const FamilyMember> members,
                                                                    const Matrix4& inverse, const Region& region,
                                                                    int least_bits = 0);

// One quadric in the box's frame by the same rule, U = 1: what it is survives. `kin` tells its ranks.
// An asymptote along z stays one in both: a z^2 left over by rounding would put a second sheet far away, perhaps in front.
[[nodiscard]] std::optional<Quantised> quantise_squares(const RealHalfSpace& here, const Kinship& kin,
                                                        const LocalBox& box, int least_bits);

}  // namespace halfspace
