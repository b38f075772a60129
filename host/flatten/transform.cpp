#include "host/flatten/transform.hpp"

#include <variant>

namespace halfspace {
namespace {

std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }

void add_multiple(Matrix4& m, std::size_t row, std::size_t of, Real factor) {
  for (std::size_t j = 0; j < 4; ++j) add_product(m[row][j], factor, m[of][j]);
}

void multiply(Vector4& row, Real factor) {
  for (Real& v : row) {
    if (!is_zero(v)) v = v.is_one() ? factor : v * factor;
  }
}

// Each takes m to T^-1 m; false where there is none.
bool undo(const TranslateTransform& t, Matrix4& m) {
  add_multiple(m, 3, index(t.axis), -decimal_to_real(t.distance.text));
  return true;
}

bool undo(const TranslateAllTransform& t, Matrix4& m) {
  const Real back = -decimal_to_real(t.distance.text);
  Vector4 moved{};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 3; ++i) add_product(moved[j], back, m[i][j]);
    moved[j] += m[3][j];
  }
  m[3] = moved;
  return true;
}

bool undo(const ScaleTransform& t, Matrix4& m) {
  const Real factor = decimal_to_real(t.factor.text);
  if (factor == 0) return false;
  multiply(m[index(t.axis)], 1 / factor);
  return true;
}

bool undo(const ScaleAllTransform& t, Matrix4& m) {
  const Real factor = decimal_to_real(t.factor.text);
  if (factor == 0) return false;
  const Real back = 1 / factor;
  for (std::size_t i = 0; i < 3; ++i) multiply(m[i], back);
  return true;
}

// =rz a takes (x, y) to (x cos a - y sin a, x sin a + y cos a); the inverse is the transpose.
bool undo(const RotateTransform& t, Matrix4& m) {
  const SineCosine turn = sine_cosine_of_degrees(t.degrees.text);
  const std::size_t first = (index(t.axis) + 1) % 3;
  const std::size_t second = (index(t.axis) + 2) % 3;
  Matrix4 back = identity_matrix;
  back[first][first] = back[second][second] = turn.cosine;
  back[first][second] = -turn.sine;
  back[second][first] = turn.sine;
  m = product(back, m);
  return true;
}

bool undo(const ShearTransform& t, Matrix4& m) {
  add_multiple(m, index(t.along), index(t.moved), -decimal_to_real(t.amount.text));
  return true;
}

}  // namespace

std::optional<Matrix4> inverse_of(std::span<const Transform> transforms) {
  Matrix4 result = identity_matrix;
  for (const Transform& transform : transforms) {
    if (!std::visit([&result](const auto& t) { return undo(t, result); }, transform)) return std::nullopt;
  }
  return result;
}

}  // namespace halfspace
