// true_scene.hpp - what a scene's text means, in the world's coordinates, at 256 bits.
// Frame   World: x right, y up, z into the scene. Points are rows (x, y, z, 1).
// Source  Ressler 1985, 2.1.4 to 2.1.6 and 3.3; design.md, section 5, where the paper is silent.
//         Nothing is shared with host/flatten.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/scene/scene.hpp"
#include "tests/oracle/real.hpp"

namespace halfspace::oracle {

using Vector3 = std::array<Real, 3>;
using Vector4 = std::array<Real, 4>;
using Matrix4 = std::array<Vector4, 4>;

// value(X) = X . plane, or X quadric X^T; the half-space is value <= 0, or >= 0 for a complement.
struct TrueHalfSpace {
  bool is_quadric = false;
  Vector4 plane;
  Matrix4 quadric;
  bool complement = false;
  bool transparent = false;
};

using TrueBody = std::vector<TrueHalfSpace>;

struct TrueLight {
  Real ambient, parallel;
  Vector3 direction;  // of length 1, to the light
};

// A point of the view plane is vrp + u right + v up. Its ray goes on along `ray`, or from the eye through it.
struct TrueView {
  bool perspective = false;
  Vector3 vrp, right, up, normal;  // the last three of length 1; normal points into the scene
  Vector3 ray;                     // parallel: away from the eye
  Vector3 eye;                     // perspective
  std::optional<Real> half_width, half_height;
};

struct TrueScene {
  std::vector<TrueBody> bodies;     // front and back clipping planes included
  std::size_t clipping_planes = 0;  // the last of every body: a fitted picture does not see them
  TrueLight light;
  TrueView view;
};

// A scene without a meaning: a scale of zero, a view without a direction.
class MeaninglessScene : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// With the view of that id; without an id, the last one, or the default.
TrueScene true_scene(const Scene& scene, const std::string& view_id = {});

}  // namespace halfspace::oracle
