// polynomial.hpp - polynomials in one variable with integer coefficients; coefficient i belongs to the power i.
// Exact  Everything. The zero polynomial is empty or holds zeros alone; leading zeros are allowed unless `trimmed`.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace halfspace {

using Polynomial = std::vector<mpz_class>;

// sum += a b without a product of its own.
inline void add_product(mpz_class& sum, const mpz_class& a, const mpz_class& b) {
  mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}

// value = value y + c: a step of Horner's scheme.
inline void times_plus(mpz_class& value, long y, const mpz_class& c) {
  mpz_mul_si(value.get_mpz_t(), value.get_mpz_t(), y);
  value += c;
}

[[nodiscard]] Polynomial trimmed(Polynomial p);
[[nodiscard]] int degree(const Polynomial& p);  // -1 for zero

[[nodiscard]] Polynomial plus(Polynomial p, const Polynomial& q);
[[nodiscard]] Polynomial minus(Polynomial p, const Polynomial& q);
[[nodiscard]] Polynomial times(const Polynomial& p, const Polynomial& q);
[[nodiscard]] Polynomial derivative(const Polynomial& p);

// The coefficients of p(x + shift).
[[nodiscard]] Polynomial shifted(Polynomial p, const mpz_class& shift);

[[nodiscard]] mpz_class value_at(const Polynomial& p, const mpz_class& x);

// denominator^(p.size() - 1) p(numerator / denominator): the value's sign, as denominator > 0.
[[nodiscard]] mpz_class scaled_value_at(const Polynomial& p, const mpz_class& numerator, const mpz_class& denominator);

// How often the coefficients of p change sign in Bernstein's basis of [low, high] / 2^shift, low < high. The number of roots
// in the open interval is less by an even number (Descartes): none for 0, one for 1.
[[nodiscard]] int sign_changes(const Polynomial& p, const mpz_class& low, const mpz_class& high, unsigned shift);

// p without a zero in the closed interval [low, high] of integers? True only if Bernstein's coefficients prove it.
[[nodiscard]] bool surely_without_zero(const Polynomial& p, const mpz_class& low, const mpz_class& high);

// Primitive.
[[nodiscard]] Polynomial greatest_common_divisor(const Polynomial& p, const Polynomial& q);
[[nodiscard]] Polynomial squarefree_part(const Polynomial& p);

}  // namespace halfspace
