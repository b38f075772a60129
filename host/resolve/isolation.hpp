// isolation.hpp - intervals that hold one real root each of a squarefree polynomial, and how they are made narrower.
// Source  Descartes' rule of signs in Bernstein's basis, with halving (Collins and Akritas 1976).
#pragma once

#include <vector>

#include "host/resolve/line_root.hpp"

namespace halfspace {

// Ascending. Ends after at most as many halvings as the roots' distance has bits, for f is squarefree.
[[nodiscard]] std::vector<DyadicInterval> isolating_intervals(const Polynomial& f);

// A root of f and an interval around it, halved on demand. Neither end is a root, unless both are the root itself.
class RefinedRoot {
 public:
  RefinedRoot(const Polynomial& f, DyadicInterval within);
  explicit RefinedRoot(const LineRoot& x);

  [[nodiscard]] const DyadicInterval& within() const { return within_; }
  [[nodiscard]] bool is_point() const { return within_.low == within_.high; }
  void halve();

  // Is the root one of g, a divisor of f?
  [[nodiscard]] bool is_root_of(const Polynomial& divisor) const;

  // No zero of g inside the interval; then its sign there.
  [[nodiscard]] bool keeps_sign(const Polynomial& g) const;
  [[nodiscard]] int sign_inside(const Polynomial& g) const;

  // The sign of f' at the root.
  [[nodiscard]] int sign_of_slope() const;

  // The sign of root - value.
  [[nodiscard]] int compare_to_integer(const mpz_class& value) const;

 private:
  [[nodiscard]] int sign_of(const Polynomial& p, const mpz_class& numerator) const;

  const Polynomial& f_;
  DyadicInterval within_;
  int sign_low_ = 0;
};

// The sign of a - b of two intervals: 0 where they overlap.
[[nodiscard]] int order(const DyadicInterval& a, const DyadicInterval& b);

// Has p just one root, and a simple one, from the lower end of both intervals to the upper? Roots at these ends do not count, unless
// both intervals are the same point. False if signs do not tell.
[[nodiscard]] bool holds_one_root(const Polynomial& p, const DyadicInterval& a, const DyadicInterval& b);

}  // namespace halfspace
