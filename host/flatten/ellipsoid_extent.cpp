#include "host/flatten/ellipsoid_extent.hpp"

namespace halfspace {
namespace {

// A point, or nearly one, is none of those told here.
constexpr int least_size_bits = 80;

bool is_ball(const std::array<Real, 10>& c) {
  const bool is_round = c[0].bits() == c[1].bits() && c[0].bits() == c[2].bits();
  return is_round && is_zero(c[3]) && is_zero(c[4]) && is_zero(c[5]);
}

// The cofactors of the second-order part, in the places of its coefficients.
std::array<Real, 6> cofactors(const std::array<Real, 10>& c) {
  const auto minor = [&c](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    Real difference = 0;
    add_product(difference, c[i], c[j]);
    add_product(difference, c[k], -c[l]);
    return difference;
  };
  const Real first = minor(1, 2, 4, 4);
  if (is_ball(c)) return {first, first, first, 0, 0, 0};
  return {first, minor(0, 2, 5, 5), minor(0, 1, 3, 3), minor(4, 5, 3, 2), minor(3, 5, 4, 0), minor(3, 4, 5, 1)};
}

// Of the second-order part, if it is clearly definite and positive; else 0.
Real determinant(const std::array<Real, 10>& c, const std::array<Real, 6>& cofactor) {
  Real most = 0;
  for (std::size_t i = 0; i < 6; ++i) most = larger(most, magnitude(c[i]));
  if (smaller(c[0], smaller(c[1], c[2])) <= times_power_of_two(most, -16) || !(cofactor[2] > 0)) return 0;
  const Real det = dot({c[0], c[3], c[5]}, {cofactor[0], cofactor[3], cofactor[5]});
  return is_ball(c) || det > times_power_of_two(c[0] * c[1] * c[2], -20) ? det : 0;
}

}  // namespace

std::optional<Box> ellipsoid_extent(const Side& side) {
  std::array<Real, 10> c = side.shape.c;
  if (side.shape.kind == HalfSpaceKind::plane) return std::nullopt;
  if (side.complement) {
    for (Real& v : c) v = -v;
  }
  const std::array<Real, 6> cofactor = cofactors(c);
  const Real det = determinant(c, cofactor);
  if (!(det > 0)) return std::nullopt;
  Vector3 middle{};
  Real size = -c[9];
  Real largest_term = magnitude(c[9]);
  const Vector3 gradient{c[6], c[7], c[8]};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = quadric_index[i];
    middle[i] = -dot({cofactor[row[0]], cofactor[row[1]], cofactor[row[2]]}, gradient) / det;
    const Real term = gradient[i] * middle[i];
    size -= term;
    largest_term = larger(largest_term, magnitude(term));
  }
  if (!(size > times_power_of_two(largest_term, -least_size_bits))) return std::nullopt;
  Vector3 half{};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_round = i > 0 && cofactor[i] == cofactor[i - 1];
    half[i] = is_round ? half[i - 1] : square_root(size * cofactor[i] / det);
  }
  return Box{difference(middle, half), sum(middle, half)};
}

}  // namespace halfspace
