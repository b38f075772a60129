// clan.hpp - families (kinship.hpp) of several groups that have a surface in common are one: a clan, rounded together.
// Why      A surface that two groups share becomes one integer quadric (mating.hpp), and its shells in both must not meet it.
// How      Shells are q and q + k of the world, so a shared surface fixes what the other family's constants are in the
//          first one's terms.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/flatten/family.hpp"
#include "host/flatten/placement.hpp"

namespace halfspace {

// A half-space of the scene, and which of the surfaces it has; none where it has no part in families.
using SurfaceOf = std::span<const std::optional<std::size_t>>;

struct Clan {
  std::size_t place = 0;  // whose frame the members are in
  std::vector<FamilyMember> members;
  std::vector<std::size_t> surfaces;  // of the members; each is written as by the first half-space that has it
};

// Those of two surfaces or more. `surfaces` of them are numbered in the order of appearance.
[[nodiscard]] std::vector<Clan> clans_of(const PlacedScene& scene, SurfaceOf surface_of, std::size_t surfaces);

}  // namespace halfspace
