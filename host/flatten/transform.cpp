#include "host/flatten/transform.hpp"

#include <variant>

namespace halfspace {
namespace {

std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }

Matrix4 inverse(const TranslateTransform& t) {
  Matrix4 m = identity_matrix;
  m[3][index(t.axis)] = -decimal_to_real(t.distance.text);
  return m;
}

Matrix4 inverse(const TranslateAllTransform& t) {
  const Real back = -decimal_to_real(t.distance.text);
  Matrix4 m = identity_matrix;
  m[3] = {back, back, back, 1};
  return m;
}

Matrix4 inverse(const ScaleTransform& t) {
  Matrix4 m = identity_matrix;
  m[index(t.axis)][index(t.axis)] = 1 / decimal_to_real(t.factor.text);
  return m;
}

Matrix4 inverse(const ScaleAllTransform& t) {
  const Real back = 1 / decimal_to_real(t.factor.text);
  Matrix4 m = identity_matrix;
  for (std::size_t i = 0; i < 3; ++i) m[i][i] = back;
  return m;
}

// =rz a takes (x, y) to (x cos a - y sin a, x sin a + y cos a); the inverse is the transpose.
Matrix4 inverse(const RotateTransform& t) {
  const SineCosine turn = sine_cosine_of_degrees(t.degrees.text);
  const std::size_t first = (index(t.axis) + 1) % 3;
  const std::size_t second = (index(t.axis) + 2) % 3;
  Matrix4 m = identity_matrix;
  m[first][first] = m[second][second] = turn.cosine;
  m[first][second] = -turn.sine;
  m[second][first] = turn.sine;
  return m;
}

Matrix4 inverse(const ShearTransform& t) {
  Matrix4 m = identity_matrix;
  m[index(t.along)][index(t.moved)] = -decimal_to_real(t.amount.text);
  return m;
}

bool flattens(const Transform& transform) {
  if (const auto* s = std::get_if<ScaleTransform>(&transform)) return decimal_to_real(s->factor.text) == 0;
  if (const auto* s = std::get_if<ScaleAllTransform>(&transform)) return decimal_to_real(s->factor.text) == 0;
  return false;
}

}  // namespace

std::optional<Matrix4> inverse_of(std::span<const Transform> transforms) {
  Matrix4 result = identity_matrix;
  for (const Transform& transform : transforms) {
    if (flattens(transform)) return std::nullopt;
    result = product(std::visit([](const auto& t) { return inverse(t); }, transform), result);
  }
  return result;
}

}  // namespace halfspace
