#include "host/resolve/line_root.hpp"

#include <cmath>
#include <utility>

#include "host/resolve/approximate_roots.hpp"
#include "host/resolve/isolation.hpp"

namespace halfspace {
namespace {

Interval near_of(const DyadicInterval& x) {
  const auto scale = static_cast<long>(x.shift);
  return {enclosure(x.low, scale).low, enclosure(x.high, scale).high};
}

// Narrow enough for doubles to tell it from most others.
LineRoot root_within(const std::shared_ptr<const Polynomial>& f, const DyadicInterval& within) {
  RefinedRoot root(*f, within);
  constexpr int most_halvings = 96;
  for (int i = 0; i < most_halvings && !root.is_point(); ++i) root.halve();
  return {f, near_of(root.within()), root.within()};
}

std::vector<LineRoot> isolated_roots(const Polynomial& f) {
  const auto once = std::make_shared<const Polynomial>(squarefree_part(f));
  std::vector<LineRoot> roots;
  for (const DyadicInterval& within : isolating_intervals(*once)) roots.push_back(root_within(once, within));
  return roots;
}

std::vector<LineRoot> roots_of_second_order(Polynomial f) {
  const mpz_class e = f[1] * f[1] - 4 * f[2] * f[0];
  if (sgn(e) < 0) return {};
  if (sgn(e) == 0) return {rational_root(-f[1], 2 * f[2])};
  const auto scale = static_cast<long>(mpz_sizeinbase(f[2].get_mpz_t(), 2));
  const Interval root = square_root(enclosure(e, 2 * scale));
  const Interval middle = enclosure(sgn(f[2]) > 0 ? mpz_class(-f[1]) : f[1], scale);
  const Interval divisor = enclosure(2 * abs(f[2]), scale);
  const Interval low = (middle - root) / divisor;
  const Interval high = (middle + root) / divisor;
  if (!std::isfinite(low.low) || !std::isfinite(high.high) || !(low.high < high.low)) return isolated_roots(f);
  const auto shared = std::make_shared<const Polynomial>(std::move(f));
  return {{shared, low, std::nullopt}, {shared, high, std::nullopt}};
}

std::vector<LineRoot> roots_of_higher_order(Polynomial f) {
  const std::vector<Interval> found = certain_sign_changes(f);
  const auto certain = static_cast<int>(found.size());
  if (certain != degree(f)) {
    const int count = count_of_real_roots(f);
    if (count == 0) return {};
    if (certain != count) return isolated_roots(f);
  }
  const auto shared = std::make_shared<const Polynomial>(std::move(f));
  std::vector<LineRoot> roots;
  roots.reserve(found.size());
  for (const Interval& near : found) roots.push_back({shared, near, std::nullopt});
  return roots;
}

// Divided by a power of two so that no coefficient is above 1.
std::vector<Interval> enclosed(const Polynomial& g) {
  std::size_t bits = 0;
  for (const mpz_class& c : g) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
  std::vector<Interval> near;
  near.reserve(g.size());
  for (const mpz_class& c : g) near.push_back(enclosure(c, static_cast<long>(bits)));
  return near;
}

// In doubles: 0 if it is not sure.
int quick_sign_at(const std::vector<Interval>& g, const Interval& x) {
  constexpr double largest =
      0x1p70;  // keeps every product in the enclosures finite: of degree four, and coefficients at most 1
  if (!(x.low > -largest && x.high < largest)) return 0;
  Interval value{};
  for (std::size_t i = g.size(); i-- > 0;) value = value * x + g[i];
  return value.positive() ? 1 : value.negative() ? -1 : 0;
}

// The sign of f' at its root.
int sign_of_slope(const LineRoot& x) {
  const int sign = quick_sign_at(enclosed(derivative(*x.f)), x.near);
  return sign != 0 ? sign : RefinedRoot(x).sign_of_slope();
}

// The sign of p + q sqrt(e), e > 0.
int sign_of_sum(const mpz_class& p, const mpz_class& q, const mpz_class& e) {
  if (sgn(p) * sgn(q) >= 0) return sgn(p) != 0 ? sgn(p) : sgn(q);
  const int order = cmp(p * p, q * q * e);
  return order > 0 ? sgn(p) : order < 0 ? sgn(q) : 0;
}

// x is a root of a x^2 + b x + c, so 2 a x + b = +-sqrt(b^2 - 4 a c) with the sign of the slope, and of g only its remainder counts:
// a^n g(x) = r1 x + r0, which is (2 a r0 - b r1 +- r1 sqrt) / 2a.
int sign_at_second_order(const Polynomial& g, const LineRoot& x) {
  const mpz_class& a = (*x.f)[2];
  const mpz_class& b = (*x.f)[1];
  const mpz_class& c = (*x.f)[0];
  Polynomial r = g;
  int sign = sgn(a);
  for (; r.size() > 2; sign *= sgn(a)) {
    const mpz_class top = std::move(r.back());
    r.pop_back();
    for (mpz_class& v : r) v *= a;
    r[r.size() - 1] -= top * b;
    r[r.size() - 2] -= top * c;
  }
  r.resize(2);
  const int slope = sgn(r[1]) == 0 ? 1 : sign_of_slope(x);
  return sign * sign_of_sum(2 * a * r[0] - b * r[1], slope * r[1], b * b - 4 * a * c);
}

int exact_sign_at(const Polynomial& g, const LineRoot& x) {
  if (x.f->size() == 2) return sgn(scaled_value_at(g, -(*x.f)[0], (*x.f)[1]));
  if (x.f->size() == 3) return sign_at_second_order(g, x);
  RefinedRoot root(x);
  if (degree(g) < 0 || root.is_root_of(greatest_common_divisor(*x.f, g))) return 0;
  while (!root.keeps_sign(g)) root.halve();  // ends: g is not 0 at x
  return root.sign_inside(g);
}

// Of all numbers in the interval, if it is one.
std::optional<mpz_class> common_floor(const Interval& x) {
  const double floor = std::floor(x.low);
  if (!(std::abs(floor) < 0x1p50) || floor != std::floor(x.high)) return std::nullopt;
  return mpz_class(floor);
}

// Narrows the interval to less than 1, so that it holds at most one integer: the first that is not below it.
mpz_class first_integer(RefinedRoot& root) {
  const auto is_wide = [](const DyadicInterval& x) { return x.high - x.low >= mpz_class(1) << x.shift; };
  while (is_wide(root.within())) root.halve();
  mpz_class integer;
  mpz_cdiv_q_2exp(integer.get_mpz_t(), root.within().low.get_mpz_t(), root.within().shift);
  return integer;
}

}  // namespace

Polynomial restricted(const Curve& p, long y) {
  const auto& q = p.q;
  Polynomial f(3);
  f[0] = q[2];
  times_plus(f[0], y, q[4]);
  times_plus(f[0], y, q[5]);
  f[1] = q[1];
  times_plus(f[1], y, q[3]);
  f[2] = q[0];
  return f;
}

std::vector<LineRoot> real_roots(Polynomial f) {
  while (!f.empty() && sgn(f.back()) == 0) f.pop_back();
  if (f.size() <= 1) return {};
  if (f.size() == 2) return {rational_root(-f[0], f[1])};
  return f.size() == 3 ? roots_of_second_order(std::move(f)) : roots_of_higher_order(std::move(f));
}

int compare(const LineRoot& a, const LineRoot& b) {
  if (a.near.high < b.near.low) return -1;
  if (a.near.low > b.near.high) return 1;
  const Polynomial common = greatest_common_divisor(*a.f, *b.f);
  RefinedRoot first(a);
  RefinedRoot second(b);
  const bool may_be_equal = first.is_root_of(common) && second.is_root_of(common);
  while (true) {  // ends: different numbers come apart, and around equal ones the divisor's other roots are left behind
    const int sign = order(first.within(), second.within());
    if (sign != 0) return sign;
    if (may_be_equal && holds_one_root(common, first.within(), second.within())) return 0;
    first.halve();
    second.halve();
  }
}

int sign_at(const Polynomial& g, const LineRoot& x) { return AskedPolynomial(g).sign_at(x); }

AskedPolynomial::AskedPolynomial(Polynomial p) : exact_(trimmed(std::move(p))), near_(enclosed(exact_)) {}

int AskedPolynomial::sign_at(const LineRoot& x) const {
  const int sign = quick_sign_at(near_, x.near);
  return sign != 0 ? sign : exact_sign_at(exact_, x);
}

mpz_class floor_of(const LineRoot& x) {
  if (const auto floor = common_floor(x.near)) return *floor;
  RefinedRoot root(x);
  const mpz_class next = first_integer(root);
  return root.compare_to_integer(next) < 0 ? mpz_class(next - 1) : next;
}

mpz_class ceiling_of(const LineRoot& x) {
  if (const auto floor = common_floor(x.near)) {
    if (x.near.low > floor->get_d()) return *floor + 1;
  }
  RefinedRoot root(x);
  const mpz_class next = first_integer(root);
  return root.compare_to_integer(next) > 0 ? mpz_class(next + 1) : next;
}

LineRoot rational_root(const mpz_class& numerator, const mpz_class& denominator) {
  const bool negative = sgn(denominator) < 0;
  auto f = std::make_shared<const Polynomial>(
      Polynomial{negative ? numerator : mpz_class(-numerator), negative ? mpz_class(-denominator) : denominator});
  const auto scale = static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  const Interval near = enclosure(-(*f)[0], scale) / enclosure((*f)[1], scale);
  if (!std::isfinite(near.low) || !std::isfinite(near.high)) return root_within(f, isolating_intervals(*f).front());
  return {std::move(f), near, std::nullopt};
}

std::optional<double> short_number_between(double low, double high) {
  constexpr double largest = 0x1p40;  // doubles up to here carry at least 12 bits after the point
  if (!(low > -largest && high < largest)) return std::nullopt;
  const double integer = std::floor(low) + 1;
  if (integer < high) return integer;
  const double middle = std::round((low + high) / 2 * 0x1p10) * 0x1p-10;
  if (low < middle && middle < high) return middle;
  return std::nullopt;
}

LineRoot rational_between(const LineRoot& a, const LineRoot& b) {
  if (const auto x = short_number_between(a.near.high, b.near.low))
    return rational_root(mpz_class(*x * 0x1p10), 1 << 10);
  RefinedRoot first(a);
  RefinedRoot second(b);
  while (order(first.within(), second.within()) == 0) {
    first.halve();
    second.halve();
  }
  const DyadicInterval& low = first.within();
  const DyadicInterval& high = second.within();
  return rational_root((low.high << high.shift) + (high.low << low.shift), mpz_class(1)
                                                                               << (low.shift + high.shift + 1));
}

}  // namespace halfspace
