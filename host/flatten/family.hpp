// family.hpp - quadrics that differ by a constant (a tube's walls, nested shells) stay apart as integers.
// Family   Quadrics of one group whose first nine coefficients are proportional, as decimals. Members are
//          ratio (F + constant) for a common F; they meet nowhere, except at infinity.
// Rule     One member is rounded as any quadric is, the others are multiples of it plus multiples of the integer form of
//          the world's constant 1: of 1 itself, or of z^2 in perspective (w = -f^2 / z). So their pencil holds that form.
//          The first member of the least rank leads: what is a cone stays one, and its shells follow.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/flatten/quantise.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

inline constexpr std::size_t no_family = static_cast<std::size_t>(-1);

// What makes a quadric a member.
struct Kinship {
  std::size_t family = no_family;  // numbered within its group
  Real ratio = 1;
  Real constant = 0;
  int rank = 4;  // of its matrix
};

// Of a group's quadrics, in their order.
[[nodiscard]] std::vector<Kinship> kinships_of(std::span<const QuadricStatement> quadrics);

struct FamilyMember {
  RealHalfSpace shape;
  Kinship kin;
};

// All in the dot frame, within one box. `inverse` is as in quantise.hpp, that of their common place.
[[nodiscard]] std::optional<std::vector<Quantised>> quantise_family(std::span<const FamilyMember> members,
                                                                    const Matrix4& inverse, const Box& box);

}  // namespace halfspace
