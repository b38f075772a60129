#include "host/flatten/extent_filter.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr double slack = 1.125;      // pays for the roundings of a plain sum of sizes
constexpr double largest = 0x1p200;  // keeps products of coordinates finite

Interval dot(const IntervalVector& a, const IntervalVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
IntervalVector cross(const IntervalVector& a, const IntervalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
IntervalVector scaled(const IntervalVector& v, const Interval& s) { return {v[0] * s, v[1] * s, v[2] * s}; }
IntervalVector sum(const IntervalVector& a, const IntervalVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Interval quotient(const Interval& a, const Interval& b) { return b.positive() ? a / b : -a / -b; }
double most(const Interval& v) { return std::max(std::abs(v.low), std::abs(v.high)); }
bool is_large(const Interval& v) { return !(-largest < v.low && v.high < largest); }
bool is_large(const IntervalVector& v) { return is_large(v[0]) || is_large(v[1]) || is_large(v[2]); }

IntervalVector polar(const std::array<Interval, 10>& c, const IntervalVector& v) {
  IntervalVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = c[quadric_index[i][0]] * v[0] + c[quadric_index[i][1]] * v[1] + c[quadric_index[i][2]] * v[2];
  }
  return result;
}

// The points t of a t^2 + 2 b t + c = 0 in one or two intervals; none: they cannot be told.
struct Parameters {
  int count = 0;
  std::array<Interval, 2> t;
};
std::optional<Parameters> parameters_of_roots(const Interval& a, const Interval& b, const Interval& c) {
  constexpr double certain = 0x1p-60;  // Real counts a discriminant below 2^-90 of its terms as 0
  if (a.may_vanish()) return std::nullopt;
  const Interval product = a * c;
  const Interval d = squared(b) - product;
  if (d.high < -certain * (most(b) * most(b) + most(product))) return Parameters{};
  const Interval root = square_root(d);
  return Parameters{2, {quotient(-b - root, a), quotient(root - b, a)}};
}

// All roots are at least so large: below it a t^2 + 2 b t cannot outweigh c.
double least_root(const Interval& a, const Interval& b, const Interval& c) {
  if (c.may_vanish()) return 0;
  const double least_c = std::min(std::abs(c.low), std::abs(c.high));
  const double most_b = most(b);
  return least_c / (most_b + std::sqrt(most_b * most_b + most(a) * least_c)) * (1 - 0x1p-40);
}

}  // namespace

Interval enclosure(Real v) {
  const auto near = static_cast<double>(v);
  return outward(near, near);
}

IntervalVector enclosure(const Vector3& v) { return {enclosure(v[0]), enclosure(v[1]), enclosure(v[2])}; }

IntervalPlane enclosure(const Vector3& normal, Real offset) { return {enclosure(normal), enclosure(offset)}; }

std::optional<IntervalLine> meeting_line(const IntervalPlane& a, const IntervalPlane& b) {
  if (is_large(a.normal) || is_large(b.normal) || is_large(a.offset) || is_large(b.offset)) return std::nullopt;
  const IntervalVector along = cross(a.normal, b.normal);
  const Interval square = dot(along, along);
  if (!square.positive()) return std::nullopt;
  const IntervalVector sum_of_parts =
      sum(scaled(cross(b.normal, along), a.offset), scaled(cross(along, a.normal), b.offset));
  const IntervalLine line{scaled(sum_of_parts, quotient({-1, -1}, square)), along};
  if (is_large(line.point)) return std::nullopt;
  return line;
}

ExtentFilter::ExtentFilter(std::span<const Side> sides, double tolerance) : tolerance_(tolerance) {
  for (const Side& side : sides) {
    FilterSide mine{side.shape.kind == HalfSpaceKind::plane, {}, 0};
    for (std::size_t i = 0; i < mine.c.size(); ++i) {
      mine.c[i] = enclosure(side.complement ? -side.shape.c[i] : side.shape.c[i]);
      if (i < (mine.is_plane ? 3U : 6U)) mine.size = std::max(mine.size, most(mine.c[i]));
    }
    sides_.push_back(mine);
  }
}

void ExtentFilter::set_box(const Box& box) {
  inside_.emplace();
  for (std::size_t i = 0; i < 3; ++i) (*inside_)[i] = {enclosure(box.low[i]).high, enclosure(box.high[i]).low};
}

ExtentFilter::Found ExtentFilter::on_plane(const IntervalLine& line, const IntervalPlane& plane, Owners on) const {
  const Interval slope = dot(plane.normal, line.direction);
  if (slope.may_vanish()) return std::nullopt;
  const Interval t = quotient(-(dot(plane.normal, line.point) + plane.offset), slope);
  if (is_large(t)) return std::nullopt;
  const IntervalVector p = sum(line.point, scaled(line.direction, t));
  return drops(p, on) ? Points{} : Points{1, {p}};
}

ExtentFilter::Found ExtentFilter::on_quadric(const IntervalLine& line, std::size_t quadric, Owners on) const {
  const auto& c = sides_[quadric].c;
  const IntervalVector gradient{c[6], c[7], c[8]};
  const IntervalVector of_point = sum(polar(c, line.point), gradient);  // half the gradient there
  const Interval bend = dot(polar(c, line.direction), line.direction);
  const Interval slope = dot(of_point, line.direction);
  const Interval value = dot(sum(of_point, gradient), line.point) + c[9];
  const auto roots = parameters_of_roots(bend, slope, value);
  if (!roots) {
    const bool needs_none = drops_beyond(line, least_root(bend, slope, value), on);
    return needs_none ? Found(Points{}) : std::nullopt;
  }
  Points found;
  for (std::size_t i = 0; i < static_cast<std::size_t>(roots->count); ++i) {
    if (is_large(roots->t[i])) return std::nullopt;
    const IntervalVector p = sum(line.point, scaled(line.direction, roots->t[i]));
    if (!drops(p, on)) found.at[found.count++] = p;
  }
  return found;
}

bool ExtentFilter::ends_along(const IntervalVector& d) const {
  const IntervalVector back{-d[0], -d[1], -d[2]};
  const auto forbidden = [this](const IntervalVector& v) {
    return std::any_of(sides_.begin(), sides_.end(), [&](const FilterSide& side) { return forbids(side, v); });
  };
  return !is_large(d) && forbidden(d) && forbidden(back);
}

bool ExtentFilter::ends_in_plane(const IntervalVector& u, const IntervalVector& v,
                                 std::span<const std::size_t> quadrics) const {
  if (!ends_along(u) || !ends_along(v)) return false;
  for (const std::size_t q : quadrics) {
    const auto& c = sides_[q].c;
    const IntervalVector of_u = polar(c, u);
    const auto roots = parameters_of_roots(dot(polar(c, v), v), dot(of_u, v), dot(of_u, u));
    if (!roots) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(roots->count); ++i) {
      if (is_large(roots->t[i]) || !ends_along(sum(u, scaled(v, roots->t[i])))) return false;
    }
  }
  return true;
}

std::optional<bool> ExtentFilter::holds_at(std::size_t index, const IntervalVector& p) const {
  if (is_large(p)) return std::nullopt;
  const FilterSide& side = sides_[index];
  const auto& c = side.c;
  Interval value = side.is_plane ? c[3] : c[9];
  double terms = most(value);
  const auto add = [&](const Interval& term) {
    value = value + term;
    terms += most(term);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (side.is_plane) {
      add(c[i] * p[i]);
      continue;
    }
    for (std::size_t j = 0; j < 3; ++j) add(c[quadric_index[i][j]] * p[i] * p[j]);
    add((c[6 + i] + c[6 + i]) * p[i]);
  }
  if (value.negative()) return true;
  if (value.low > slack * tolerance_ * terms) return false;
  return std::nullopt;
}

bool ExtentFilter::is_in_box(const IntervalVector& p) const {
  const auto within = [&](std::size_t i) { return (*inside_)[i].low <= p[i].low && p[i].high <= (*inside_)[i].high; };
  return inside_ && within(0) && within(1) && within(2);
}

bool ExtentFilter::drops(const IntervalVector& p, Owners on) const {
  if (is_in_box(p)) return true;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const bool is_own = std::find(on.begin(), on.end(), i) != on.end();
    if (!is_own && !holds_at(i, p).value_or(true)) return true;
  }
  return false;
}

// Are all points of the line needless that are t or more from its point, either way? Planes alone are asked: their values grow as t does.
bool ExtentFilter::drops_beyond(const IntervalLine& line, double t, Owners on) const {
  bool there = false;
  bool opposite = false;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!sides_[i].is_plane || std::find(on.begin(), on.end(), i) != on.end()) continue;
    const auto& c = sides_[i].c;
    const IntervalVector normal{c[0], c[1], c[2]};
    const Interval start = dot(normal, line.point) + c[3];
    const Interval slope = dot(normal, line.direction);
    double start_terms = most(c[3]);
    double slope_terms = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      start_terms += most(normal[k]) * most(line.point[k]);
      slope_terms += most(normal[k]) * most(line.direction[k]);
    }
    const auto excludes = [&](const Interval& growth) {
      const double grows = growth.low - slack * tolerance_ * slope_terms;
      return grows > 0 &&
             start.low - slack * tolerance_ * start_terms + grows * t * (1 - 0x1p-40) > std::abs(start.low) * 0x1p-40;
    };
    there = there || excludes(slope);
    opposite = opposite || excludes(-slope);
  }
  return there && opposite;
}

// Does going on along d leave the side for good? Told by the terms that decide far out.
bool ExtentFilter::forbids(const FilterSide& side, const IntervalVector& d) const {
  const double square = dot(d, d).high;
  if (side.is_plane) {
    const Interval value = dot({side.c[0], side.c[1], side.c[2]}, d);
    return value.low > slack * tolerance_ * side.size * std::max(1.0, square);  // a length is at most this
  }
  return dot(polar(side.c, d), d).low > slack * tolerance_ * side.size * square;
}

}  // namespace halfspace
