// line_root.hpp - the points where curves cross one scan line, as exact algebraic numbers of degree at most four:
// a squarefree integer polynomial and an interval that holds just one of its real roots.
// Exact  Order, floor and the sign of any polynomial at such a point need signs of integers alone: the interval is halved until
//        it is told from another, or a common divisor of the polynomials proves that both are the same number.
// Cost   Roots are found in floating point first and certified by signs; doubles settle nearly every question.
#pragma once

#include <gmpxx.h>

#include <memory>
#include <optional>
#include <vector>

#include "host/algebra/polynomial.hpp"
#include "host/flatten/interval.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// The closed interval [low, high] / 2^shift.
struct DyadicInterval {
  mpz_class low, high;
  unsigned shift = 0;
};

struct LineRoot {
  std::shared_ptr<const Polynomial> f;
  Interval near;                         // contains the root
  std::optional<DyadicInterval> within;  // isolates it; if not given, `near` does
};

// A curve of second order on the scan line y.
[[nodiscard]] Polynomial restricted(const Curve& p, long y);

// The real roots, ascending, a multiple root once; none of a constant.
[[nodiscard]] std::vector<LineRoot> real_roots(Polynomial f);

// -1, 0, 1: the sign of a - b.
[[nodiscard]] int compare(const LineRoot& a, const LineRoot& b);

// The sign of g at x.
[[nodiscard]] int sign_at(const Polynomial& g, const LineRoot& x);

// A polynomial whose sign is asked at many points: its coefficients are enclosed once.
class AskedPolynomial {
 public:
  AskedPolynomial() = default;
  explicit AskedPolynomial(Polynomial p);

  [[nodiscard]] const Polynomial& exact() const { return exact_; }
  [[nodiscard]] int sign_at(const LineRoot& x) const;

 private:
  Polynomial exact_;
  std::vector<Interval> near_;
};

[[nodiscard]] mpz_class floor_of(const LineRoot& x);
[[nodiscard]] mpz_class ceiling_of(const LineRoot& x);

[[nodiscard]] LineRoot rational_root(const mpz_class& numerator, const mpz_class& denominator);

// A number of few bits, an integer or a multiple of 2^-10, with low < it < high; none where they are too close or too far off.
[[nodiscard]] std::optional<double> short_number_between(double low, double high);

// A rational strictly between a and b, with a < b.
[[nodiscard]] LineRoot rational_between(const LineRoot& a, const LineRoot& b);

}  // namespace halfspace
