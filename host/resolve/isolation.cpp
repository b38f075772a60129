#include "host/resolve/isolation.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

int sign_at_dyadic(const Polynomial& p, const mpz_class& numerator, unsigned shift) {
  mpz_class value = 0;
  unsigned power = 0;
  for (std::size_t i = p.size(); i-- > 0; power += shift) value = value * numerator + (p[i] << power);
  return sgn(value);
}

// All real roots are within +-2^bits (Cauchy).
unsigned bits_of_bound(const Polynomial& f) {
  std::size_t most = 0;
  for (const mpz_class& c : f) most = std::max(most, mpz_sizeinbase(c.get_mpz_t(), 2));
  return static_cast<unsigned>(most - mpz_sizeinbase(f.back().get_mpz_t(), 2) + 2);
}

// Roots in the open interval, ascending. An interval that is kept has no root at its ends.
void isolate(const Polynomial& f, const DyadicInterval& within, std::vector<DyadicInterval>& found) {
  const int changes = sign_changes(f, within.low, within.high, within.shift);
  if (changes == 0) return;
  const auto is_root = [&](const mpz_class& end) { return sign_at_dyadic(f, end, within.shift) == 0; };
  if (changes == 1 && !is_root(within.low) && !is_root(within.high)) return found.push_back(within);
  const DyadicInterval fine{within.low << 1, within.high << 1, within.shift + 1};
  const mpz_class middle = within.low + within.high;
  isolate(f, {fine.low, middle, fine.shift}, found);
  if (sign_at_dyadic(f, middle, fine.shift) == 0) found.push_back({middle, middle, fine.shift});
  isolate(f, {middle, fine.high, fine.shift}, found);
}

DyadicInterval dyadic(const Interval& near) {
  // A double is an integer of 53 bits times a power of two.
  const auto exponent_of = [](double v) {
    int e = 0;
    std::frexp(v, &e);
    return v == 0 ? 0 : e - 53;
  };
  const int least = std::min({exponent_of(near.low), exponent_of(near.high), 0});
  const auto scaled = [least](double v) {
    int e = 0;
    mpz_class integer(std::ldexp(std::frexp(v, &e), 53));
    if (sgn(integer) != 0) integer <<= static_cast<unsigned>(e - 53 - least);
    return integer;
  };
  return {scaled(near.low), scaled(near.high), static_cast<unsigned>(-least)};
}

}  // namespace

std::vector<DyadicInterval> isolating_intervals(const Polynomial& f) {
  std::vector<DyadicInterval> found;
  const mpz_class bound = mpz_class(1) << bits_of_bound(f);
  isolate(f, {-bound, bound, 0}, found);
  return found;
}

RefinedRoot::RefinedRoot(const Polynomial& f, DyadicInterval within) : f_(f), within_(std::move(within)) {
  sign_low_ = sign_of(f_, within_.low);
  if (sign_low_ == 0) within_.high = within_.low;
  if (!is_point() && sign_of(f_, within_.high) == 0) within_.low = within_.high;
}

RefinedRoot::RefinedRoot(const LineRoot& x) : RefinedRoot(*x.f, x.within ? *x.within : dyadic(x.near)) {}

void RefinedRoot::halve() {
  if (is_point()) return;
  const mpz_class middle = within_.low + within_.high;
  within_ = {within_.low << 1, within_.high << 1, within_.shift + 1};
  const int sign = sign_of(f_, middle);
  if (sign == 0) {
    within_.low = within_.high = middle;
  } else {
    (sign == sign_low_ ? within_.low : within_.high) = middle;
  }
}

bool RefinedRoot::is_root_of(const Polynomial& divisor) const {
  if (degree(divisor) < 1) return false;
  if (is_point()) return sign_of(divisor, within_.low) == 0;
  return sign_of(divisor, within_.low) != sign_of(divisor, within_.high);  // no end is a root of f
}

bool RefinedRoot::keeps_sign(const Polynomial& g) const {
  return is_point() || sign_changes(g, within_.low, within_.high, within_.shift) == 0;
}

int RefinedRoot::sign_inside(const Polynomial& g) const {
  return sign_at_dyadic(g, within_.low + within_.high, within_.shift + 1);
}

int RefinedRoot::sign_of_slope() const { return is_point() ? sign_of(derivative(f_), within_.low) : -sign_low_; }

int RefinedRoot::compare_to_integer(const mpz_class& value) const {
  const mpz_class scaled = value << within_.shift;
  if (scaled < within_.low) return 1;
  if (scaled > within_.high) return -1;
  if (is_point()) return 0;
  const int sign = sign_of(f_, scaled);
  return sign == 0 ? 0 : sign == sign_low_ ? 1 : -1;
}

int RefinedRoot::sign_of(const Polynomial& p, const mpz_class& numerator) const {
  return sign_at_dyadic(p, numerator, within_.shift);
}

int order(const DyadicInterval& a, const DyadicInterval& b) {
  if ((a.high << b.shift) < (b.low << a.shift)) return -1;
  return (a.low << b.shift) > (b.high << a.shift) ? 1 : 0;
}

bool holds_one_root(const Polynomial& p, const DyadicInterval& a, const DyadicInterval& b) {
  const mpz_class a_low = a.low << b.shift;
  const mpz_class b_low = b.low << a.shift;
  const mpz_class a_high = a.high << b.shift;
  const mpz_class b_high = b.high << a.shift;
  const mpz_class& low = std::min(a_low, b_low);
  const mpz_class& high = std::max(a_high, b_high);
  return low == high || sign_changes(p, low, high, a.shift + b.shift) == 1;
}

}  // namespace halfspace
