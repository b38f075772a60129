#include "host/resolve/interval_polynomial.hpp"

#include <algorithm>

namespace halfspace {

IntervalPolynomial::IntervalPolynomial(std::initializer_list<Interval> coefficients) : size(coefficients.size()) {
  std::copy(coefficients.begin(), coefficients.end(), c.begin());
}

IntervalPolynomial enclosed(const Polynomial& p) {
  std::size_t bits = 0;
  for (const mpz_class& c : p) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
  IntervalPolynomial near;
  near.size = p.size();
  for (std::size_t i = 0; i < p.size(); ++i) near.c[i] = enclosure(p[i], static_cast<long>(bits));
  return near;
}

IntervalPolynomial plus(IntervalPolynomial p, const IntervalPolynomial& q) {
  p.size = std::max(p.size, q.size);
  for (std::size_t i = 0; i < q.size; ++i) p.c[i] = p.c[i] + q.c[i];
  return p;
}

IntervalPolynomial minus(IntervalPolynomial p, const IntervalPolynomial& q) {
  p.size = std::max(p.size, q.size);
  for (std::size_t i = 0; i < q.size; ++i) p.c[i] = p.c[i] - q.c[i];
  return p;
}

IntervalPolynomial times(const IntervalPolynomial& p, const IntervalPolynomial& q) {
  IntervalPolynomial r;
  if (p.size == 0 || q.size == 0) return r;
  r.size = p.size + q.size - 1;
  for (std::size_t i = 0; i < p.size; ++i) {
    for (std::size_t j = 0; j < q.size; ++j) r.c[i + j] = r.c[i + j] + p.c[i] * q.c[j];
  }
  return r;
}

IntervalPolynomial scaled(int factor, IntervalPolynomial p) {
  const auto size = static_cast<double>(factor);
  for (std::size_t i = 0; i < p.size; ++i) p.c[i] = Interval{size, size} * p.c[i];
  return p;
}

IntervalPolynomial derivative(const IntervalPolynomial& p) {
  IntervalPolynomial d;
  for (std::size_t i = 1; i < p.size; ++i) {
    const auto power = static_cast<double>(i);
    d.c[i - 1] = Interval{power, power} * p.c[i];
  }
  d.size = p.size == 0 ? 0 : p.size - 1;
  return d;
}

}  // namespace halfspace
