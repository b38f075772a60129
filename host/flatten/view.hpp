// view.hpp - the view's parameters settled: where the eye is, and the frame that rays are parallel to z in.
// View frame  X right and Y down in the plane through vrp, Z along vpn, vrp at the origin, world units. An oblique
//             view shears along that plane. A perspective one divides by the depth w from cop:
//                 X = f u / w - u(vrp),  Y = f v / w - v(vrp),  Z = -f^2 / w,   f = the depth of vrp,
//             so that rays are parallel to Z, smaller Z is nearer, dZ/dw = 1 at vrp, and points before the eye are
//             those of Z < 0. A half-space's value is divided by w or w^2: its sign holds where w > 0.
// Source      Ressler 2.1.6; the signs are those of docs/flatten.md.
#pragma once

#include <optional>
#include <string>

#include "host/flatten/matrix.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

struct ClippingPlanes {
  Real front = 0, back = 0;  // distances from vrp along vpn
  SourcePosition position;
};

struct View {
  Vector3 vrp{};
  Vector3 right{}, down{}, into{};  // orthonormal; `into` is vpn
  bool perspective = false;
  Vector3 ray{};  // parallel: along a ray into the scene, ray . into = 1
  Vector3 cop{};  // perspective
  std::optional<Real> half_width, half_height;
  std::optional<ClippingPlanes> clipping;
  SourcePosition position;
};

// The view named `id`, or the last one, or `dop .3 .3 -1`.
[[nodiscard]] std::optional<View> settle_view(const Scene& scene, const std::string& id, Diagnostics& diagnostics);

// Takes view frame coordinates to the world: the inverse that half-spaces are transformed by.
[[nodiscard]] Matrix4 view_to_world(const View& view);

// Rows: the world's directions right, down and into, taken to homogeneous view frame coordinates (X, Y, Z, w).
[[nodiscard]] std::array<Vector4, 3> directions_to_view(const View& view);

// The plane at `distance` from vrp along vpn, in the view frame; the half-space before it.
[[nodiscard]] RealHalfSpace before_plane(const View& view, Real distance);

}  // namespace halfspace
