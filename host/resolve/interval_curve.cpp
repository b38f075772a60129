#include "host/resolve/interval_curve.hpp"

#include <cstddef>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

double least_size(const Interval& a) { return a.may_vanish() ? 0 : std::min(std::abs(a.low), std::abs(a.high)); }
double most_size(const Interval& a) { return std::max(std::abs(a.low), std::abs(a.high)); }

// b does not vanish.
Interval quotient(const Interval& a, const Interval& b) { return b.positive() ? a / b : -a / -b; }

Interval twice(const Interval& a) { return {2 * a.low, 2 * a.high}; }

// A quadratic's parts by which neither root suffers from cancellation: t / 2a and 2c / t.
Interval far_part(const Interval& b, const Interval& root) { return b.low + b.high < 0 ? root - b : -(b + root); }

Interval discriminant(const Interval& a, const Interval& b, const Interval& c) {
  return squared(b) - twice(twice(a * c));
}

IntervalRoots ascending(const Interval& u, const Interval& v) {
  return u.low + u.high < v.low + v.high ? IntervalRoots{2, {u, v}} : IntervalRoots{2, {v, u}};
}

// Of a quadratic whose leading coefficient may vanish: the roots within `reach`, if the others are certain to lie beyond.
std::optional<IntervalRoots> near_roots(const Interval& a, const Interval& b, const Interval& c, double reach) {
  const Interval others =
      Interval{0, most_size(a)} * Interval{0, reach * reach} + Interval{0, most_size(b)} * Interval{0, reach};
  if (least_size(c) > others.high) return IntervalRoots{};
  const Interval d = discriminant(a, b, c);
  if (!d.positive()) return std::nullopt;
  const Interval t = far_part(b, square_root(d));
  const Interval beyond = twice(Interval{most_size(a), most_size(a)}) * Interval{reach, reach};
  if (least_size(t) <= beyond.high) return std::nullopt;
  return IntervalRoots{1, {quotient(twice(c), t)}};
}

std::optional<IntervalPoints> meeting_of_lines(const IntervalCurve& l, const IntervalCurve& m) {
  const Interval det = l.q[3] * m.q[4] - m.q[3] * l.q[4];
  if (det.may_vanish()) return std::nullopt;
  const Interval x = quotient(l.q[4] * m.q[5] - m.q[4] * l.q[5], det);
  const Interval y = quotient(m.q[3] * l.q[5] - l.q[3] * m.q[5], det);
  return IntervalPoints{1, {{{x, y}}}};
}

// The curve on u x + v y + w = 0 as u^2 times a polynomial in y.
std::array<Interval, 3> eliminated_x(const std::array<Interval, 6>& q, const Interval& u, const Interval& v,
                                     const Interval& w) {
  return {(q[0] * v - q[1] * u) * v + q[2] * squared(u),
          twice(q[0] * v * w) - (q[1] * w + q[3] * v) * u + q[4] * squared(u),
          (q[0] * w - q[3] * u) * w + q[5] * squared(u)};
}

std::array<Interval, 6> mirrored(const std::array<Interval, 6>& q) { return {q[2], q[1], q[0], q[4], q[3], q[5]}; }

}  // namespace

IntervalCurve interval_curve(const Curve& p) {
  const long exponent = exponent_of(p);
  IntervalCurve result;
  for (std::size_t i = 0; i < p.q.size(); ++i) result.q[i] = enclosure(p.q[i], exponent);
  result.is_line = sgn(p.q[0]) == 0 && sgn(p.q[1]) == 0 && sgn(p.q[2]) == 0;
  return result;
}

std::optional<IntervalRoots> interval_roots(const Interval& a, const Interval& b, const Interval& c) {
  if (a.may_vanish()) return std::nullopt;
  const Interval d = discriminant(a, b, c);
  if (d.negative()) return IntervalRoots{};
  const Interval root = square_root(d);
  if (d.positive()) {
    const Interval t = far_part(b, root);
    if (!t.may_vanish()) return ascending(quotient(t, twice(a)), quotient(twice(c), t));
  }
  const Interval low = quotient(-b - root, twice(a));
  const Interval high = quotient(root - b, twice(a));
  return IntervalRoots{1, {{{std::min(low.low, high.low), std::max(low.high, high.high)}}}, true};
}

std::optional<IntervalRoots> roots_in_x(const IntervalCurve& p, const Interval& y) {
  const auto& q = p.q;
  const Interval b = q[1] * y + q[3];
  const Interval c = (q[2] * y + q[4]) * y + q[5];
  if (!q[0].is_zero()) return interval_roots(q[0], b, c);
  if (b.may_vanish()) return std::nullopt;
  return IntervalRoots{1, {quotient(-c, b)}};
}

// The other coordinate is eliminated by the larger of the line's coefficients, or nearly so: x rather than y, since y has a reach.
std::optional<IntervalPoints> meeting_points(const IntervalCurve& line, const IntervalCurve& p, double reach) {
  constexpr double steepness = 0x1p-6;
  if (p.is_line) return meeting_of_lines(line, p);
  const Interval& u = line.q[3];
  const Interval& v = line.q[4];
  const Interval& w = line.q[5];
  const bool by_y = least_size(u) > steepness * most_size(v);
  if (!by_y && v.may_vanish()) return std::nullopt;
  const auto [a, b, c] = by_y ? eliminated_x(p.q, u, v, w) : eliminated_x(mirrored(p.q), v, u, w);
  auto roots = interval_roots(a, b, c);
  if (!roots && by_y) roots = near_roots(a, b, c, reach);
  if (!roots) return std::nullopt;
  IntervalPoints points{roots->count, {}};
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    const Interval& t = roots->x[i];
    points.at[i] = by_y ? IntervalPoint{quotient(-(v * t + w), u), t} : IntervalPoint{t, quotient(-(u * t + w), v)};
  }
  return points;
}

}  // namespace halfspace
