#include "host/flatten/spectrum.hpp"

namespace halfspace {
namespace {

constexpr int sweeps = 12;  // Jacobi converges quadratically: 3 x 3 in 113 bits takes 6

using Matrix3 = std::array<Vector3, 3>;

// Makes a[p][q] zero by a rotation of the p, q plane.
void rotate(Matrix3& a, std::array<Vector3, 3>& vectors, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const Real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const Real t = (theta < 0 ? -1 : 1) / (magnitude(theta) + square_root(theta * theta + 1));
  const Real c = 1 / square_root(t * t + 1);
  const Real s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0;
  const Real rp = a[r][p];
  const Real rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real vp = vectors[p][i];
    const Real vq = vectors[q][i];
    vectors[p][i] = c * vp - s * vq;
    vectors[q][i] = s * vp + c * vq;
  }
}

// Two equal values leave their vectors free: one of them takes a coordinate of 0, so that what lies along an axis of
// the page is rounded to integers that do. Three equal ones take the axes.
void align_equal_values(Spectrum& spectrum) {
  if (agree(spectrum.values[0], spectrum.values[1]) && agree(spectrum.values[0], spectrum.values[2])) {
    spectrum.vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    return;
  }
  for (std::size_t r = 0; r < 3; ++r) {
    Vector3& u = spectrum.vectors[(r + 1) % 3];
    Vector3& v = spectrum.vectors[(r + 2) % 3];
    if (!agree(spectrum.values[(r + 1) % 3], spectrum.values[(r + 2) % 3])) continue;
    std::size_t axis = 0;
    while (larger(magnitude(u[axis]), magnitude(v[axis])) < power_of_two(-20)) ++axis;
    const Vector3 level = unit(difference(scaled(v, u[axis]), scaled(u, v[axis])));
    u = level;
    v = cross(spectrum.vectors[r], level);
    return;
  }
}

}  // namespace

Spectrum spectrum_of(const RealHalfSpace& quadric) {
  Matrix3 a{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) a[i][j] = quadric.c[quadric_index[i][j]];
  }
  Spectrum result;
  result.vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto& q = quadric.c;
  if (is_zero(q[3]) && is_zero(q[4]) && is_zero(q[5])) {
    result.values = {q[0], q[1], q[2]};
    align_equal_values(result);
    return result;
  }
  const Real negligible = times_power_of_two(larger(largest(a[0]), larger(largest(a[1]), largest(a[2]))), -125);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (magnitude(a[0][1]) + magnitude(a[0][2]) + magnitude(a[1][2]) <= negligible) break;
    rotate(a, result.vectors, 0, 1);
    rotate(a, result.vectors, 0, 2);
    rotate(a, result.vectors, 1, 2);
  }
  result.values = {a[0][0], a[1][1], a[2][2]};
  align_equal_values(result);
  return result;
}

ReducedQuadric reduce(const RealHalfSpace& quadric, Real radius) {
  const Spectrum spectrum = spectrum_of(quadric);
  const Vector3 gradient{quadric.c[6], quadric.c[7], quadric.c[8]};  // half of it, at the origin
  Real constant = quadric.c[9];
  const Real square = radius * radius;
  Real scale = larger(magnitude(constant), times_power_of_two(largest(gradient) * radius, 1));
  Vector3 bends{};  // sizes of the squares' parts
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_known = i > 0 && spectrum.values[i].bits() == spectrum.values[i - 1].bits();
    bends[i] = is_known ? bends[i - 1] : magnitude(spectrum.values[i]) * square;
    scale = larger(scale, bends[i]);
  }

  ReducedQuadric result;
  Vector3 normal{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& axis = spectrum.vectors[i];
    const Real along = dot(axis, gradient);
    const Real weight = spectrum.values[i];
    if (bends[i] <= times_power_of_two(scale, -zero_bits)) {
      normal = sum(normal, scaled(axis, 2 * along));
      continue;
    }
    const Real offset = along / weight;
    result.squares[result.count++] = {weight, {axis[0], axis[1], axis[2], offset}};
    const Real part = along * offset;
    constant -= part;
    scale = larger(scale, magnitude(part));
  }
  const Real zero = times_power_of_two(scale, -zero_bits);
  result.linear = largest(normal) * radius > zero;
  if (result.linear) {
    result.rest = {normal[0], normal[1], normal[2], constant};
  } else if (magnitude(constant) > zero) {
    result.rest[3] = constant;
  }
  return result;
}

}  // namespace halfspace
