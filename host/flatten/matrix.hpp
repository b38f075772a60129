// matrix.hpp - row vectors (x y z w), the 4 x 4 matrices that move them, and half-spaces in Real coefficients.
//   x' = x T;   a plane's column P' = T^-1 P (3.4);   a quadric's matrix Q' = T^-1 Q (T^-1)^T (3.7).
// So only inverses are kept, as in the paper.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "host/flatten/integer_scene.hpp"
#include "host/flatten/real.hpp"

namespace halfspace {

using Vector3 = std::array<Real, 3>;
using Vector4 = std::array<Real, 4>;
using Matrix4 = std::array<Vector4, 4>;

// Most entries of a placement are 0 or 1, and a product in software is not free.
inline void add_nonzero_product(Real& sum, Real a, Real b) {
  const Real product = a.is_one() ? b : b.is_one() ? a : a * b;
  sum = is_zero(sum) ? product : sum + product;
}
inline void add_product(Real& sum, Real a, Real b) {
  if (!is_zero(a) && !is_zero(b)) add_nonzero_product(sum, a, b);
}

inline Real dot(const Vector3& a, const Vector3& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < 3; ++i) add_product(sum, a[i], b[i]);
  return sum;
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector3 scaled(const Vector3& v, Real s) { return {v[0] * s, v[1] * s, v[2] * s}; }
inline Vector3 sum(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector3 difference(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Real length(const Vector3& v) { return square_root(dot(v, v)); }
inline Real largest(const Vector3& v) { return larger(magnitude(v[0]), larger(magnitude(v[1]), magnitude(v[2]))); }
// Scaled by its largest coordinate first, so that neither 1e308 nor 1e-308 leaves the range.
inline Vector3 unit(const Vector3& v) {
  const Vector3 tame = scaled(v, 1 / largest(v));
  return scaled(tame, 1 / length(tame));
}

inline constexpr Matrix4 identity_matrix{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

inline Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 result{};
  for (std::size_t i = 0; i < 4; ++i) {
    bool is_begun = false;
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_zero(a[i][k])) continue;
      if (!std::exchange(is_begun, true) && a[i][k].is_one()) {
        result[i] = b[k];
        continue;
      }
      for (std::size_t j = 0; j < 4; ++j) add_product(result[i][j], a[i][k], b[k][j]);
    }
  }
  return result;
}

// The product of the matrix that shifts by `shift` with m.
inline Matrix4 shifted(const Vector3& shift, const Matrix4& m) {
  Matrix4 result = m;
  Vector4& last = result[3];
  last = {};
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_zero(shift[k])) continue;
    for (std::size_t j = 0; j < 4; ++j) add_product(last[j], shift[k], m[k][j]);
  }
  for (std::size_t j = 0; j < 4; ++j) add_product(last[j], 1, m[3][j]);
  return result;
}

inline bool finite(const Matrix4& m) {
  for (const auto& row : m) {
    for (const Real v : row) {
      if (!finite(v)) return false;
    }
  }
  return true;
}

// Coefficients in the order of IntegerHalfSpace: plane c[0..3], quadric A B C D E F G H J K.
struct RealHalfSpace {
  HalfSpaceKind kind = HalfSpaceKind::plane;
  std::array<Real, 10> c{};
};

// The quadric's symmetric matrix: entry (i, j) is c[quadric_index[i][j]].
inline constexpr std::array<std::array<std::size_t, 4>, 4> quadric_index{
    {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}}};

inline std::size_t coefficient_count(HalfSpaceKind kind) { return kind == HalfSpaceKind::plane ? 4 : 10; }

inline bool finite(const RealHalfSpace& h) {
  for (const Real v : h.c) {
    if (!finite(v)) return false;
  }
  return true;
}

inline RealHalfSpace transformed(const RealHalfSpace& h, const Matrix4& inverse) {
  RealHalfSpace result{h.kind, {}};
  if (h.kind == HalfSpaceKind::plane) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) add_product(result.c[i], inverse[i][k], h.c[k]);
    }
    return result;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    Vector4 half{};  // a row of T^-1 Q
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_zero(inverse[i][k])) continue;
      for (std::size_t j = 0; j < 4; ++j) {
        const Real& c = h.c[quadric_index[k][j]];
        if (!is_zero(c)) add_nonzero_product(half[j], inverse[i][k], c);
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_zero(half[k])) continue;
      for (std::size_t j = i; j < 4; ++j) {
        if (!is_zero(inverse[j][k])) add_nonzero_product(result.c[quadric_index[i][j]], half[k], inverse[j][k]);
      }
    }
  }
  return result;
}

// The same half-space, its coefficients divided by the largest of them. All zero stays so.
inline RealHalfSpace normalised(RealHalfSpace h) {
  Bits128 size = 0;
  for (const Real v : h.c) size = std::max(size, v.size_bits());
  const Real most = Real::of_bits(size);
  if (is_zero(most) || !finite(most)) return h;
  Real former = most;
  Real quotient = 1;
  for (Real& v : h.c) {
    if (is_zero(v)) continue;
    if (v.bits() != former.bits()) {  // a sphere has three coefficients of one size
      quotient = v.size_bits() == size ? Real(v.has_sign() ? -1 : 1) : v / most;
    }
    former = std::exchange(v, quotient);
  }
  return h;
}

// The same half-space seen from `origin`: x = origin + x'.
inline RealHalfSpace seen_from(const RealHalfSpace& h, const Vector3& origin) {
  Matrix4 shift = identity_matrix;
  shift[3] = {origin[0], origin[1], origin[2], 1};
  return transformed(h, shift);
}

}  // namespace halfspace
