// scene.hpp - what a UniQuadrix text says, statement by statement, before any coordinate is computed.
// Order    Statements keep the order of the text: it decides which of two coincident faces wins.
// Numbers  A coefficient keeps its text, so that flattener and oracle read the same decimal exactly.
// Source   Ressler 1985, chapter 2.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/scene/diagnostic.hpp"

namespace halfspace {

// A decimal number of the scene. The parser guarantees that `text` is [-] digits [. digits] [e [+-] digits]
// (digits on one side of the point are enough), at most 400 bytes, "0" for zero; that its magnitude is 0 or
// within [1e-308, 1e308]; and that `value` is the double nearest to it.
struct Number {
  std::string text;
  double value = 0;
};

// A x + B y + C z + D <= 0 (2.1).
struct PlaneStatement {
  std::string id;
  std::array<Number, 4> coefficients;
  bool transparent = false;
  SourcePosition position;
};

// A x^2 + B y^2 + C z^2 + 2D xy + 2E yz + 2F xz + 2G x + 2H y + 2J z + K <= 0 (2.2); ten numbers A..H, J, K.
struct QuadricStatement {
  std::string id;
  std::array<Number, 10> coefficients;
  bool transparent = false;
  SourcePosition position;
};

struct HalfSpaceReference {
  std::string id;
  bool complement = false;  // written with a leading '!'
  SourcePosition position;
};

struct BodyStatement {
  std::string id;
  std::vector<HalfSpaceReference> half_spaces;  // never empty
  SourcePosition position;
};

enum class Axis : std::uint8_t { x, y, z };

struct TranslateTransform {
  Axis axis;
  Number distance;
};
struct TranslateAllTransform {  // =ta
  Number distance;
};
struct ScaleTransform {
  Axis axis;
  Number factor;
};
struct ScaleAllTransform {  // =sa
  Number factor;
};
struct RotateTransform {  // right-hand rule, row vectors
  Axis axis;
  Number degrees;
};
struct ShearTransform {  // =vxy: along x, moved y: y' = y + amount * x
  Axis along;
  Axis moved;
  Number amount;
};
using Transform = std::variant<TranslateTransform, TranslateAllTransform, ScaleTransform, ScaleAllTransform,
                               RotateTransform, ShearTransform>;

struct InstanceStatement {
  std::string id;
  std::string definition;
  std::vector<Transform> transforms;  // concatenated left to right; row vectors
  SourcePosition position;
};

// Copy k (0 <= k < count) is placed by initial * delta^k.
struct ArrayStatement {
  std::string id;
  std::string definition;
  std::vector<Transform> initial;
  std::uint32_t count = 0;  // 1 .. 1'000'000
  std::vector<Transform> delta;
  SourcePosition position;
};

using Placement = std::variant<BodyStatement, InstanceStatement, ArrayStatement>;

// The statements of one definition, or those outside any definition (id empty).
// The parser has resolved every reference: a body names half-spaces of its own group, an instance names a
// definition of the scene, and definitions do not contain themselves.
struct Group {
  std::string id;
  std::vector<PlaneStatement> planes;
  std::vector<QuadricStatement> quadrics;
  std::vector<Placement> placements;  // bodies, instances and arrays in the order of the text
  SourcePosition position;
};

struct LightStatement {
  std::string id;
  Number intensity;
  std::optional<std::array<Number, 3>> direction;  // absent: ambient; present: from the scene to the light
  SourcePosition position;
};

enum class ViewKey : std::uint8_t { vrp, vpn, vup, dop, cop, whh, whw, fbp };
enum class ViewOption : std::uint8_t { standard, vector, point, absolute, relative };  // none, =v, =p, =a, =r

struct ViewParameter {
  ViewKey key;
  std::array<Number, 3> values;  // vrp..cop: 3 used; fbp: 2; whh, whw: 1
  ViewOption option = ViewOption::standard;
  SourcePosition position;
};

struct ViewStatement {
  std::string id;
  std::vector<ViewParameter> parameters;  // in the order of the text: set left to right, the last one wins
  SourcePosition position;
};

struct Scene {
  Group top;
  std::vector<Group> definitions;
  std::vector<LightStatement> lights;  // the automatic default light is not listed
  std::vector<ViewStatement> views;    // the automatic default view is not listed
};

}  // namespace halfspace
