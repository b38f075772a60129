// placement.hpp - the trees of instances and arrays walked depth first: every body of the picture, in world space.
// Sharing  A half-space is transformed once per placed group and shared by the bodies of the group, so that `a` and
//          `!a` of two of them stay one surface.
// Precision  The half-spaces keep the coefficients of their statements and a matrix: only products of matrices are
//          rounded before the flattener knows where on the page a body lies, and can shift its frame there first.
// Limits   100,000 placed bodies (about a minute of work); instances 1000 deep.
// Source   Ressler 3.3.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/kinship.hpp"
#include "host/flatten/matrix.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

inline constexpr std::uint64_t placed_body_limit = 100'000;
inline constexpr int placement_depth_limit = 1000;

struct PlacedHalfSpace {
  RealHalfSpace shape;    // as its statement says, normalised
  std::size_t place = 0;  // index in PlacedScene::places
  bool transparent = false;
  std::string name;
  SourcePosition position;
  Kinship kin = {};  // quadrics only; its family is one of the place's
};

struct HalfSpaceUse {
  std::size_t half_space = 0;  // index in PlacedScene::half_spaces
  bool complement = false;
};

struct PlacedBody {
  std::string name;  // with its path: stack_of_bundles[1]/bundle[3]/tube
  SourcePosition position;
  std::vector<HalfSpaceUse> uses;
  const BodyStatement* statement = nullptr;
};

struct PlacedScene {
  std::vector<Matrix4> places;               // inverses: world to the group's own frame
  std::vector<PlacedHalfSpace> half_spaces;  // only those that a body uses
  std::vector<PlacedBody> bodies;            // flattened order
};

[[nodiscard]] PlacedScene place_bodies(const Scene& scene, Diagnostics& diagnostics);

}  // namespace halfspace
