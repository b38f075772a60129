#include "host/algebra/polynomial.hpp"

#include <flint/fmpz_poly.h>

#include <algorithm>

namespace halfspace {
namespace {

// A polynomial in FLINT's keeping.
class FlintPolynomial {
 public:
  FlintPolynomial() { fmpz_poly_init(p_); }
  explicit FlintPolynomial(const Polynomial& p) : FlintPolynomial() {
    fmpz_t c;
    fmpz_init(c);
    for (std::size_t i = 0; i < p.size(); ++i) {
      fmpz_set_mpz(c, p[i].get_mpz_t());
      fmpz_poly_set_coeff_fmpz(p_, static_cast<slong>(i), c);
    }
    fmpz_clear(c);
  }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
  ~FlintPolynomial() { fmpz_poly_clear(p_); }

  [[nodiscard]] fmpz_poly_struct* get() { return p_; }
  [[nodiscard]] Polynomial copy() const {
    Polynomial p(static_cast<std::size_t>(fmpz_poly_length(p_)));
    for (std::size_t i = 0; i < p.size(); ++i) {
      fmpz_get_mpz(p[i].get_mpz_t(), fmpz_poly_get_coeff_ptr(p_, static_cast<slong>(i)));
    }
    return p;
  }

 private:
  fmpz_poly_t p_;
};

// q(t) with q = scale^n p(low + (high - low) t) / 2^shift, so that the interval becomes [0, 1].
Polynomial on_unit_interval(const Polynomial& p, const mpz_class& low, const mpz_class& high, unsigned shift) {
  Polynomial q = p;
  const std::size_t n = q.size() - 1;
  for (std::size_t i = 0; i < n; ++i) q[i] <<= shift * (n - i);
  q = shifted(std::move(q), low);
  const mpz_class width = high - low;
  mpz_class power = 1;
  for (std::size_t i = 1; i <= n; ++i) {
    power *= width;
    q[i] *= power;
  }
  return q;
}

// Bernstein's coefficients, each times a positive number: those of (1 + t)^n q(1 / (1 + t)), last first.
Polynomial bernstein_signs(Polynomial q) {
  std::reverse(q.begin(), q.end());
  for (std::size_t i = 0; i + 1 < q.size(); ++i) {
    for (std::size_t j = q.size() - 1; j-- > i;) q[j] += q[j + 1];
  }
  return q;
}

}  // namespace

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
  return p;
}

int degree(const Polynomial& p) {
  auto size = static_cast<int>(p.size());
  while (size > 0 && sgn(p[static_cast<std::size_t>(size) - 1]) == 0) --size;
  return size - 1;
}

Polynomial plus(Polynomial p, const Polynomial& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) p[i] += q[i];
  return p;
}

Polynomial minus(Polynomial p, const Polynomial& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) p[i] -= q[i];
  return p;
}

Polynomial times(const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return {};
  Polynomial r(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) add_product(r[i + j], p[i], q[j]);
  }
  return r;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * static_cast<unsigned long>(i));
  return d;
}

Polynomial shifted(Polynomial p, const mpz_class& shift) {
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = p.size() - 1; j-- > i;) add_product(p[j], p[j + 1], shift);
  }
  return p;
}

mpz_class value_at(const Polynomial& p, const mpz_class& x) {
  mpz_class value = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    value *= x;
    value += p[i];
  }
  return value;
}

mpz_class scaled_value_at(const Polynomial& p, const mpz_class& numerator, const mpz_class& denominator) {
  mpz_class value = 0;
  mpz_class power = 1;
  for (std::size_t i = p.size(); i-- > 0;) {
    value = value * numerator + p[i] * power;
    power *= denominator;
  }
  return value;
}

int sign_changes(const Polynomial& p, const mpz_class& low, const mpz_class& high, unsigned shift) {
  if (p.empty()) return 0;
  int changes = 0;
  int last = 0;
  for (const mpz_class& c : bernstein_signs(on_unit_interval(p, low, high, shift))) {
    const int sign = sgn(c);
    if (sign * last < 0) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

bool surely_without_zero(const Polynomial& p, const mpz_class& low, const mpz_class& high) {
  if (p.empty()) return false;
  const Polynomial signs = bernstein_signs(on_unit_interval(p, low, high, 0));
  const int first = sgn(signs.front());
  return first != 0 && std::all_of(signs.begin(), signs.end(), [first](const mpz_class& c) { return sgn(c) == first; });
}

Polynomial greatest_common_divisor(const Polynomial& p, const Polynomial& q) {
  FlintPolynomial a(p);
  FlintPolynomial b(q);
  FlintPolynomial divisor;
  fmpz_poly_gcd(divisor.get(), a.get(), b.get());
  fmpz_poly_primitive_part(divisor.get(), divisor.get());
  return divisor.copy();
}

Polynomial squarefree_part(const Polynomial& p) {
  FlintPolynomial whole(p);
  FlintPolynomial slope(derivative(p));
  FlintPolynomial repeated;
  fmpz_poly_gcd(repeated.get(), whole.get(), slope.get());
  FlintPolynomial once;
  fmpz_poly_div(once.get(), whole.get(), repeated.get());
  fmpz_poly_primitive_part(once.get(), once.get());
  return once.copy();
}

}  // namespace halfspace
