// integer_form.hpp - the integer coefficients of a half-space: moved between frames, reduced, built from squares.
#pragma once

#include <gmpxx.h>

#include <array>

#include "host/flatten/matrix.hpp"

namespace halfspace {

using IntegerPoint = std::array<mpz_class, 3>;
using IntegerLinear = std::array<mpz_class, 4>;

// Coefficients as in IntegerHalfSpace, seen from a point of the dot frame.
struct IntegerForm {
  HalfSpaceKind kind = HalfSpaceKind::plane;
  std::array<mpz_class, 10> c;
  IntegerPoint origin = {};
};

// The same form seen from elsewhere in the dot frame. Exact; the common factor stays what it was.
[[nodiscard]] IntegerForm seen_from(const IntegerForm& form, const IntegerPoint& origin);
// Its coefficients alone.
void copy_seen_from(const IntegerForm& form, const IntegerPoint& origin, std::array<mpz_class, 10>& c);

// Takes its common factor out.
void make_primitive(IntegerForm& form);

// The same surface, written the other way round.
void negate(IntegerForm& form);

// Adds factor * linear^2 to a quadric.
void add_square(IntegerForm& quadric, const mpz_class& factor, const IntegerLinear& linear);

// Adds 2 a b to a quadric.
void add_twice_product(IntegerForm& quadric, const IntegerLinear& a, const IntegerLinear& b);

[[nodiscard]] RealHalfSpace to_real(HalfSpaceKind kind, const std::array<mpz_class, 10>& c);
[[nodiscard]] RealHalfSpace to_real(const IntegerForm& form);
[[nodiscard]] Vector4 to_real(const IntegerLinear& form);

[[nodiscard]] IntegerPoint round_to_integers(const Vector3& v);

}  // namespace halfspace
