// interval_polynomial.hpp - polynomials in one variable whose coefficients are enclosed in intervals; coefficient i belongs to the power i.
// Certain  The exact polynomial's coefficients lie in the intervals, all divided by one positive number. A coefficient that is exactly 0 may
//          be known as [0, 0].
// Ranges   Those of interval.hpp: polynomials that are made of coefficients up to 1.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include "host/algebra/polynomial.hpp"
#include "host/flatten/interval.hpp"

namespace halfspace {

struct IntervalPolynomial {
  static constexpr std::size_t capacity = 20;

  IntervalPolynomial() = default;
  IntervalPolynomial(std::initializer_list<Interval> coefficients);

  std::array<Interval, capacity> c;  // the first `size`
  std::size_t size = 0;
};

// Divided by a power of two so that no coefficient is above 1; at most `capacity` coefficients.
[[nodiscard]] IntervalPolynomial enclosed(const Polynomial& p);

[[nodiscard]] IntervalPolynomial plus(IntervalPolynomial p, const IntervalPolynomial& q);
[[nodiscard]] IntervalPolynomial minus(IntervalPolynomial p, const IntervalPolynomial& q);
[[nodiscard]] IntervalPolynomial times(const IntervalPolynomial& p, const IntervalPolynomial& q);
[[nodiscard]] IntervalPolynomial scaled(int factor, IntervalPolynomial p);
[[nodiscard]] IntervalPolynomial derivative(const IntervalPolynomial& p);

}  // namespace halfspace
