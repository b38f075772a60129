#include "host/resolve/line_root.hpp"

namespace halfspace {
namespace {

// The sign of a + b sqrt(e).
int sign_of(const mpz_class& a, const mpz_class& b, const mpz_class& e) {
  const int sign_a = sgn(a);
  const int sign_b = sgn(b) * sgn(e);
  if (sign_a * sign_b >= 0) return sign_a != 0 ? sign_a : sign_b;
  return sign_a * cmp(a * a, b * b * e);
}

// floor(2^shift x): floor((p +- sqrt(e)) / r) needs only the integer part of the square root.
mpz_class scaled_floor(const LineRoot& x, unsigned shift) {
  mpz_class numerator = x.p << shift;
  if (x.sigma != 0) {
    const mpz_class square = x.e << (2 * shift);
    mpz_class root = sqrt(square);
    if (x.sigma > 0) {
      numerator += root;
    } else {
      numerator -= root * root == square ? root : root + 1;
    }
  }
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), numerator.get_mpz_t(), x.r.get_mpz_t());
  return quotient;
}

LineRoot make_root(mpz_class p, mpz_class e, mpz_class r, int sigma) {
  const auto scale = static_cast<long>(mpz_sizeinbase(r.get_mpz_t(), 2));
  Interval numerator = enclosure(p, scale);
  if (sigma > 0) numerator = numerator + square_root(enclosure(e, 2 * scale));
  if (sigma < 0) numerator = numerator - square_root(enclosure(e, 2 * scale));
  const Interval near = numerator / enclosure(r, scale);
  return {std::move(p), std::move(e), std::move(r), sigma, near};
}

}  // namespace

LinePolynomial restricted(const Curve& p, const mpz_class& y) {
  const auto& q = p.q;
  return {q[0], q[1] * y + q[3], (q[2] * y + q[4]) * y + q[5]};
}

std::vector<LineRoot> real_roots(const LinePolynomial& f) {
  if (sgn(f.c2) == 0) {
    if (sgn(f.c1) == 0) return {};
    return {rational_root(-f.c0, f.c1)};
  }
  const mpz_class e = f.c1 * f.c1 - 4 * f.c2 * f.c0;
  if (sgn(e) < 0) return {};
  if (sgn(e) == 0) return {rational_root(-f.c1, 2 * f.c2)};
  const int up = sgn(f.c2);
  const mpz_class p = up > 0 ? mpz_class(-f.c1) : f.c1;
  const mpz_class r = 2 * abs(f.c2);
  return {make_root(p, e, r, -1), make_root(p, e, r, 1)};
}

int compare(const LineRoot& a, const LineRoot& b) {
  if (a.near.high < b.near.low) return -1;
  if (a.near.low > b.near.high) return 1;
  const mpz_class rational = a.p * b.r - b.p * a.r;
  if (a.sigma == 0 && b.sigma == 0) return sgn(rational);
  if (b.sigma == 0) return sign_of(rational, a.sigma * b.r, a.e);
  if (a.sigma == 0) return sign_of(rational, -b.sigma * a.r, b.e);
  // rational + s sqrt(f) + t sqrt(g)
  const mpz_class f = b.r * b.r * a.e;
  const mpz_class g = a.r * a.r * b.e;
  const int s = a.sigma;
  const int t = -b.sigma;
  const int irrational = s == t ? s : s * cmp(f, g);
  const int sign = sgn(rational);
  if (sign * irrational >= 0) return sign != 0 ? sign : irrational;
  const mpz_class difference = rational * rational - f - g;
  return sign * sign_of(difference, -2 * s * t, f * g);
}

mpz_class floor_of(const LineRoot& x) { return scaled_floor(x, 0); }

mpz_class ceiling_of(const LineRoot& x) {
  const LineRoot negated{-x.p, x.e, x.r, -x.sigma, {}};
  return -scaled_floor(negated, 0);
}

LineRoot rational_root(const mpz_class& numerator, const mpz_class& denominator) {
  return make_root(sgn(denominator) < 0 ? mpz_class(-numerator) : numerator, 0, abs(denominator), 0);
}

LineRoot rational_between(const LineRoot& a, const LineRoot& b) {
  for (unsigned shift = 0;; shift += 4) {  // ends: the floors part once 2^shift (b - a) >= 2
    const mpz_class low = scaled_floor(a, shift);
    const mpz_class high = scaled_floor(b, shift);
    if (high - low < 2) continue;
    const mpz_class middle = low + (high - low) / 2;  // a < low + 1 <= middle < high <= b, in units of 2^-shift
    return rational_root(middle, mpz_class(1) << shift);
  }
}

LinePoint::LinePoint(const LineRoot& x) : x_(x), p_squared_plus_e_(x.p * x.p), p_r_(x.p * x.r), r_squared_(x.r * x.r) {
  if (x.sigma != 0) p_squared_plus_e_ += x.e;
}

Surd LinePoint::quadratic(const LinePolynomial& f) const {
  Surd value{f.c2 * p_squared_plus_e_ + f.c1 * p_r_ + f.c0 * r_squared_, 0};
  if (x_.sigma != 0) value.v = x_.sigma * (2 * f.c2 * x_.p + f.c1 * x_.r);
  return value;
}

Surd LinePoint::linear(const LinePolynomial& f) const { return {f.c1 * x_.p + f.c0 * x_.r, x_.sigma * f.c1}; }

Surd LinePoint::times(const Surd& a, const Surd& b) const {
  if (x_.sigma == 0) return {a.u * b.u, 0};
  return {a.u * b.u + a.v * b.v * x_.e, a.u * b.v + a.v * b.u};
}

int LinePoint::sign(const Surd& a) const { return x_.sigma == 0 ? sgn(a.u) : sign_of(a.u, a.v, x_.e); }

int LinePoint::sign(const Surd& a, const Surd& b, const Surd& d) const {
  const int sign_a = sign(a);
  const int sign_b = sign(b) * sign(d);
  if (sign_a * sign_b >= 0) return sign_a != 0 ? sign_a : sign_b;
  const Surd a_squared = times(a, a);
  const Surd b_squared_d = times(times(b, b), d);
  return sign_a * sign({a_squared.u - b_squared_d.u, a_squared.v - b_squared_d.v});
}

}  // namespace halfspace
