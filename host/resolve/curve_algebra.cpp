#include "host/resolve/curve_algebra.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "host/algebra/content.hpp"

namespace halfspace {
namespace {

// A canonical one.
void append_once(Curve&& p, std::vector<Curve>& factors) {
  const auto same = [&p](const Curve& q) { return same_curve(p, q); };
  if (std::none_of(factors.begin(), factors.end(), same)) factors.push_back(std::move(p));
}

void append_line(const mpz_class& x, const mpz_class& y, const mpz_class& one, std::vector<Curve>& factors) {
  Curve line{{0, 0, 0, x, y, one}};
  make_canonical(line);
  append_once(std::move(line), factors);
}

// s y + t with (s y + t)^2 = p2 y^2 + p1 y + p0, when it is a rational (hence an integer) polynomial.
struct LinearRoot {
  mpz_class s, t;
};
std::optional<LinearRoot> square_root(const mpz_class& p2, const mpz_class& p1, const mpz_class& p0) {
  if (sgn(p2) < 0 || sgn(p0) < 0 || p1 * p1 != 4 * p2 * p0) return std::nullopt;
  if (mpz_perfect_square_p(p2.get_mpz_t()) == 0 || mpz_perfect_square_p(p0.get_mpz_t()) == 0) return std::nullopt;
  LinearRoot root{sqrt(p2), sqrt(p0)};
  if (sgn(p1) < 0) root.t = -root.t;
  return root;
}

// q0 != 0: reducible exactly when the discriminant in x is the square of a rational polynomial in y; that of an ellipse begins with a
// negative coefficient.
void append_factors_of_second_order_in_x(Curve&& p, std::vector<Curve>& factors) {
  const auto& q = p.q;
  const mpz_class leading = q[1] * q[1] - 4 * q[0] * q[2];
  if (sgn(leading) < 0) return append_once(std::move(p), factors);
  const auto root = square_root(leading, 2 * q[1] * q[3] - 4 * q[0] * q[4], q[3] * q[3] - 4 * q[0] * q[5]);
  if (!root) return append_once(std::move(p), factors);
  append_line(2 * q[0], q[1] + root->s, q[3] + root->t, factors);
  append_line(2 * q[0], q[1] - root->s, q[3] - root->t, factors);
}

// q0 = 0, q1 != 0: reducible exactly when q1 y + q3 divides the part without x.
void append_factors_of_mixed(Curve&& p, std::vector<Curve>& factors) {
  const auto& q = p.q;
  if (q[2] * q[3] * q[3] - q[4] * q[3] * q[1] + q[5] * q[1] * q[1] != 0) {
    return append_once(std::move(p), factors);
  }
  append_line(0, q[1], q[3], factors);
  append_line(q[1] * q[1], q[1] * q[2], q[4] * q[1] - q[2] * q[3], factors);
}

}  // namespace

Curve constant_curve(const mpz_class& value) { return {{0, 0, 0, 0, 0, value}}; }

Curve operator+(Curve p, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) p.q[i] += q.q[i];
  return p;
}

Curve operator-(Curve p, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) p.q[i] -= q.q[i];
  return p;
}

Curve operator*(const mpz_class& factor, const Curve& p) {
  Curve product;
  for (std::size_t i = 0; i < p.q.size(); ++i) {
    if (sgn(p.q[i]) != 0) product.q[i] = factor * p.q[i];
  }
  return product;
}

Curve plus_multiple(Curve p, const mpz_class& factor, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) mpz_addmul(p.q[i].get_mpz_t(), factor.get_mpz_t(), q.q[i].get_mpz_t());
  return p;
}

Curve minus_multiple(Curve p, const mpz_class& factor, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) mpz_submul(p.q[i].get_mpz_t(), factor.get_mpz_t(), q.q[i].get_mpz_t());
  return p;
}

Curve product_of_lines(const Curve& l, const Curve& m) {
  const auto& a = l.q;
  const auto& b = m.q;
  const auto mixed = [&](std::size_t i, std::size_t j) {
    mpz_class sum = a[i] * b[j];
    mpz_addmul(sum.get_mpz_t(), a[j].get_mpz_t(), b[i].get_mpz_t());
    return sum;
  };
  return {{a[3] * b[3], mixed(3, 4), a[4] * b[4], mixed(3, 5), mixed(4, 5), a[5] * b[5]}};
}

bool is_zero(const Curve& p) {
  return std::all_of(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) == 0; });
}

bool is_constant(const Curve& p) {
  return std::all_of(p.q.begin(), p.q.end() - 1, [](const mpz_class& c) { return sgn(c) == 0; });
}

bool same_curve(const Curve& p, const Curve& q) { return p.q == q.q; }

void make_canonical(Curve& p) {
  divide_by_content(p.q);
  const auto leading = std::find_if(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) != 0; });
  if (leading == p.q.end() || sgn(*leading) > 0) return;
  for (mpz_class& coefficient : p.q) mpz_neg(coefficient.get_mpz_t(), coefficient.get_mpz_t());
}

void append_factors(Curve p, std::vector<Curve>& factors) {
  if (is_constant(p)) return;
  make_canonical(p);
  if (sgn(p.q[0]) != 0) return append_factors_of_second_order_in_x(std::move(p), factors);
  if (sgn(p.q[1]) != 0) return append_factors_of_mixed(std::move(p), factors);
  append_once(std::move(p), factors);
}

}  // namespace halfspace
