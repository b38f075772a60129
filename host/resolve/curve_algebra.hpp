// curve_algebra.hpp - polynomials of degree two in (x, y) with integer coefficients: sums, products, rational factors.
// The type is that of the arcs (resolved_scene.hpp): q0 x^2 + q1 xy + q2 y^2 + q3 x + q4 y + q5.
// Exact  Everything; no coefficient overflows.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

[[nodiscard]] Curve constant_curve(const mpz_class& value);
[[nodiscard]] Curve operator+(Curve p, const Curve& q);
[[nodiscard]] Curve operator-(Curve p, const Curve& q);
[[nodiscard]] Curve operator*(const mpz_class& factor, const Curve& p);

void negate(Curve& p);

// p + factor q, and p - factor q, without numbers in between.
[[nodiscard]] Curve plus_multiple(Curve p, const mpz_class& factor, const Curve& q);
[[nodiscard]] Curve minus_multiple(Curve p, const mpz_class& factor, const Curve& q);
void subtract_multiple(Curve& p, const mpz_class& factor, const Curve& q);

// The product of two polynomials of first order (q0 = q1 = q2 = 0 in both).
[[nodiscard]] Curve product_of_lines(const Curve& l, const Curve& m);

[[nodiscard]] bool is_zero(const Curve& p);
[[nodiscard]] bool is_constant(const Curve& p);
[[nodiscard]] bool same_curve(const Curve& p, const Curve& q);

// The least e, but 1, with all coefficients below 2^e.
[[nodiscard]] long exponent_of(const Curve& p);

// Divides by the content and makes the first coefficient that is not 0 positive.
void make_canonical(Curve& p);

// The two canonical lines, maybe the same twice, that a curve consists of, if their coefficients are rational.
[[nodiscard]] std::optional<std::array<Curve, 2>> rational_lines(const Curve& p);

// Appends the factors of p that are irreducible over the rationals, canonical, none twice in `factors`. Constants have none.
// A pair of lines with irrational coefficients stays one curve. Two different results have no common component.
void append_factors(Curve p, std::vector<Curve>& factors);

}  // namespace halfspace
