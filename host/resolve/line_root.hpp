// line_root.hpp - the points where curves cross one scan line, as exact algebraic numbers of degree two.
//   x = (p + sigma sqrt(e)) / r      p, e, r integers, e >= 0, r > 0, sigma -1, 0 or 1; sigma = 0: rational
// Exact  Order, floor, ceiling and the sign of any polynomial at such a point need integers alone: squares are compared.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "host/flatten/interval.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

struct LineRoot {
  mpz_class p, e, r = 1;
  int sigma = 0;
  Interval near;  // contains x: settles most comparisons
};

// A polynomial in x on one scan line: c2 x^2 + c1 x + c0.
struct LinePolynomial {
  mpz_class c2, c1, c0;
};

// p on the scan line y.
[[nodiscard]] LinePolynomial restricted(const Curve& p, const mpz_class& y);

// The real roots, ascending, a double root once; none of a constant.
[[nodiscard]] std::vector<LineRoot> real_roots(const LinePolynomial& f);

// -1, 0, 1: the sign of a - b.
[[nodiscard]] int compare(const LineRoot& a, const LineRoot& b);

[[nodiscard]] mpz_class floor_of(const LineRoot& x);
[[nodiscard]] mpz_class ceiling_of(const LineRoot& x);

[[nodiscard]] LineRoot rational_root(const mpz_class& numerator, const mpz_class& denominator);

// A rational strictly between a and b, with a < b.
[[nodiscard]] LineRoot rational_between(const LineRoot& a, const LineRoot& b);

// u + v sqrt(e): a number of the field of one point, whose e it does not carry.
struct Surd {
  mpz_class u, v;
};

// A point with the powers that polynomials need: values come multiplied by r^2 > 0 (quadratic) or by r > 0 (linear).
class LinePoint {
 public:
  explicit LinePoint(const LineRoot& x);
  [[nodiscard]] Surd quadratic(const LinePolynomial& f) const;
  [[nodiscard]] Surd linear(const LinePolynomial& f) const;  // f.c2 is 0
  [[nodiscard]] Surd times(const Surd& a, const Surd& b) const;
  [[nodiscard]] int sign(const Surd& a) const;
  // The sign of a + b sqrt(d), where d >= 0.
  [[nodiscard]] int sign(const Surd& a, const Surd& b, const Surd& d) const;

 private:
  LineRoot x_;
  mpz_class p_squared_plus_e_, p_r_, r_squared_;
};

}  // namespace halfspace
