#include "host/resolve/curve_algebra.hpp"

#include <algorithm>
#include <bit>
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

Curve line_of(mpz_class x, mpz_class y, mpz_class one) {
  Curve line{{0, 0, 0, std::move(x), std::move(y), std::move(one)}};
  make_canonical(line);
  return line;
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

using Lines = std::optional<std::array<Curve, 2>>;

// q0 != 0: reducible exactly when the discriminant in x is the square of a rational polynomial in y; that of an ellipse begins with a
// negative coefficient.
Lines lines_of_second_order_in_x(const Curve& p) {
  const auto& q = p.q;
  if (sgn(q[1]) == 0 && sgn(q[0]) * sgn(q[2]) > 0) return std::nullopt;
  const mpz_class leading = q[1] * q[1] - 4 * q[0] * q[2];
  if (sgn(leading) < 0) return std::nullopt;
  const auto root = square_root(leading, 2 * q[1] * q[3] - 4 * q[0] * q[4], q[3] * q[3] - 4 * q[0] * q[5]);
  if (!root) return std::nullopt;
  return {{line_of(2 * q[0], q[1] + root->s, q[3] + root->t), line_of(2 * q[0], q[1] - root->s, q[3] - root->t)}};
}

// q0 = 0, q1 != 0: reducible exactly when q1 y + q3 divides the part without x.
Lines mixed_lines(const Curve& p) {
  const auto& q = p.q;
  if (q[2] * q[3] * q[3] - q[4] * q[3] * q[1] + q[5] * q[1] * q[1] != 0) return std::nullopt;
  return {{line_of(0, q[1], q[3]), line_of(q[1] * q[1], q[1] * q[2], q[4] * q[1] - q[2] * q[3])}};
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

void negate(Curve& p) {
  for (mpz_class& c : p.q) mpz_neg(c.get_mpz_t(), c.get_mpz_t());
}

Curve plus_multiple(Curve p, const mpz_class& factor, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) mpz_addmul(p.q[i].get_mpz_t(), factor.get_mpz_t(), q.q[i].get_mpz_t());
  return p;
}

Curve minus_multiple(Curve p, const mpz_class& factor, const Curve& q) {
  subtract_multiple(p, factor, q);
  return p;
}

void subtract_multiple(Curve& p, const mpz_class& factor, const Curve& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) {
    const mpz_ptr c = p.q[i].get_mpz_t();
    if (mpz_sgn(c) != 0) {
      mpz_submul(c, factor.get_mpz_t(), q.q[i].get_mpz_t());
    } else {  // at half the cost
      mpz_mul(c, factor.get_mpz_t(), q.q[i].get_mpz_t());
      mpz_neg(c, c);
    }
  }
}

Curve product_of_lines(const Curve& l, const Curve& m) {
  const auto& a = l.q;
  const auto& b = m.q;
  const auto product = [&](std::size_t i, std::size_t j) {
    return sgn(a[i]) == 0 || sgn(b[j]) == 0 ? mpz_class() : mpz_class(a[i] * b[j]);
  };
  const auto mixed = [&](std::size_t i, std::size_t j) {
    mpz_class sum = product(i, j);
    mpz_addmul(sum.get_mpz_t(), a[j].get_mpz_t(), b[i].get_mpz_t());
    return sum;
  };
  return {{product(3, 3), mixed(3, 4), product(4, 4), mixed(3, 5), mixed(4, 5), product(5, 5)}};
}

bool is_zero(const Curve& p) {
  return std::all_of(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) == 0; });
}

bool is_constant(const Curve& p) {
  return std::all_of(p.q.begin(), p.q.end() - 1, [](const mpz_class& c) { return sgn(c) == 0; });
}

bool same_curve(const Curve& p, const Curve& q) { return p.q == q.q; }

long exponent_of(const Curve& p) {
  static_assert(GMP_NUMB_BITS == 64);
  std::size_t exponent = 1;
  for (const mpz_class& c : p.q) {
    const std::size_t limbs = mpz_size(c.get_mpz_t());
    if (limbs == 0) continue;
    const mp_limb_t top = mpz_getlimbn(c.get_mpz_t(), static_cast<mp_size_t>(limbs - 1));
    exponent = std::max(exponent, 64 * (limbs - 1) + static_cast<std::size_t>(std::bit_width(top)));
  }
  return static_cast<long>(exponent);
}

void make_canonical(Curve& p) {
  divide_by_content(p.q);
  const auto leading = std::find_if(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) != 0; });
  if (leading == p.q.end() || sgn(*leading) > 0) return;
  negate(p);
}

std::optional<std::array<Curve, 2>> rational_lines(const Curve& p) {
  if (sgn(p.q[0]) != 0) return lines_of_second_order_in_x(p);
  return sgn(p.q[1]) != 0 ? mixed_lines(p) : std::nullopt;
}

void append_factors(Curve p, std::vector<Curve>& factors) {
  if (is_constant(p)) return;
  make_canonical(p);
  auto lines = rational_lines(p);
  if (!lines) return append_once(std::move(p), factors);
  for (Curve& line : *lines) append_once(std::move(line), factors);
}

}  // namespace halfspace
