// placement.hpp - the trees of instances and arrays walked depth first: every body of the picture, in world space.
// Sharing  A half-space is transformed once per placed group and shared by the bodies of the group, so that `a` and
//          `!a` of two of them stay one surface.
// Limits   1,000,000 placed bodies; instances 200 deep.
// Source   Ressler 3.3.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/matrix.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

inline constexpr std::uint64_t placed_body_limit = 1'000'000;
inline constexpr int placement_depth_limit = 200;

struct PlacedHalfSpace {
  RealHalfSpace shape;  // normalised
  bool transparent = false;
  std::string name;
  SourcePosition position;
};

struct HalfSpaceUse {
  std::size_t half_space = 0;  // index in PlacedScene::half_spaces
  bool complement = false;
};

struct PlacedBody {
  std::string name;  // with its path: stack_of_bundles[1]/bundle[3]/tube
  SourcePosition position;
  std::vector<HalfSpaceUse> uses;
};

struct PlacedScene {
  std::vector<PlacedHalfSpace> half_spaces;  // only those that a body uses
  std::vector<PlacedBody> bodies;            // flattened order
};

[[nodiscard]] PlacedScene place_bodies(const Scene& scene, Diagnostics& diagnostics);

}  // namespace halfspace
