// spectrum.hpp - a quadric as a signed sum of squares of orthonormal linear forms and what is left over.
//   value(x) = sum_i weight_i (n_i . x + offset_i)^2 + rest . (x, 1),      n_i orthonormal, rest's normal _|_ every n_i
// Which weights, and which parts of the rest, are 0 decides what the quadric is: see ReducedQuadric.
#pragma once

#include <array>
#include <cstddef>

#include "host/flatten/matrix.hpp"

namespace halfspace {

struct Spectrum {
  std::array<Real, 3> values{};
  std::array<Vector3, 3> vectors{};  // orthonormal
};

// Of the second-order part of a quadric, by Jacobi's rotations: values are good to 2^-108 of the largest.
[[nodiscard]] Spectrum spectrum_of(const RealHalfSpace& quadric);

struct SquareTerm {
  Real weight = 0;
  Vector4 form{};  // unit normal and offset
};

//   squares  rest      the surface
//   3        0         a cone, or a point
//   3        constant  an ellipsoid or hyperboloid, or empty
//   2        linear    a paraboloid
//   2        constant  an elliptic or hyperbolic cylinder, or empty       0: two planes, or a line
//   1        linear    a parabolic cylinder
//   1        constant  two parallel planes, or empty                      0: a double plane
//   0        linear    a plane                                            constant: everything or nothing
struct ReducedQuadric {
  std::array<SquareTerm, 3> squares{};
  std::size_t count = 0;
  Vector4 rest{};
  bool linear = false;  // rest has a normal
  [[nodiscard]] Real constant() const { return rest[3]; }
};

// The relative size below which a weight or a rest counts as 0. Decimals that went through transforms in 113 bits
// are wrong by some 2^-105, up to 2^-85 where a frame lies 10^3 sizes away; a part that is dropped although it was
// there moves the surface by at most 2^-36 of `radius` (a double root is the worst case: the square root of it).
inline constexpr int zero_bits = 73;

[[nodiscard]] inline bool agree(Real a, Real b) {
  return a.bits() == b.bits() || magnitude(a - b) <= times_power_of_two(magnitude(a), -zero_bits);
}

// `radius` is the reach of the body that uses the quadric, from the frame's origin.
[[nodiscard]] ReducedQuadric reduce(const RealHalfSpace& quadric, Real radius);

}  // namespace halfspace
