#include "host/flatten/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "host/flatten/ellipsoid_extent.hpp"
#include "host/flatten/extent_filter.hpp"
#include "host/flatten/far_directions.hpp"
#include "host/flatten/meeting_extent.hpp"
#include "host/flatten/spectrum.hpp"

namespace halfspace {
namespace {

// Parts of a sum below 2^-90 of it are the rounding of 113 bits. A point found through a square root of such a part
// is good to 2^-45, which enters values of other surfaces at first order: 2^-40 of their terms is on the surface.
// (Extents are a frame for the integers, and never decide a dot.)
constexpr int parallel_bits = 90;
constexpr int held_bits = 40;

constexpr std::size_t no_side = static_cast<std::size_t>(-1);

struct UnitPlane {
  Vector3 normal{};
  Real offset = 0;
  std::size_t side = no_side;
};

struct Line {
  Vector3 point{}, direction{};  // direction of length 1
};

bool make_plane(const Vector4& c, std::size_t side, std::vector<UnitPlane>& planes) {
  const Vector3 normal{c[0], c[1], c[2]};
  const Real most = largest(normal);
  if (most == 0 || !(most > magnitude(c[3]) * power_of_two(-parallel_bits * 2))) return false;
  const Vector3 tame = scaled(normal, 1 / most);
  const Real size = length(tame);
  planes.push_back({scaled(tame, 1 / size), c[3] / most / size, side});
  return true;
}

bool meet(const UnitPlane& a, const UnitPlane& b, Line& line) {
  const Vector3 along = cross(a.normal, b.normal);
  const Real square = dot(along, along);
  if (square <= power_of_two(-2 * parallel_bits)) return false;
  line.point =
      scaled(sum(scaled(cross(b.normal, along), a.offset), scaled(cross(along, a.normal), b.offset)), -1 / square);
  line.direction = scaled(along, 1 / square_root(square));
  return true;
}

Real second_order(const RealHalfSpace& q, const Vector3& u, const Vector3& v) {
  Real total = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) total += q.c[quadric_index[i][j]] * u[i] * v[j];
  }
  return total;
}

struct Value {
  Real value = 0, terms = 0;  // terms: the sum of sizes
};

Value value_at(const RealHalfSpace& h, const Vector3& p) {
  Value result;
  const auto add = [&result](Real term) {
    result.value += term;
    result.terms += magnitude(term);
  };
  if (h.kind == HalfSpaceKind::plane) {
    for (std::size_t i = 0; i < 3; ++i) add(h.c[i] * p[i]);
    add(h.c[3]);
    return result;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) add(h.c[quadric_index[i][j]] * p[i] * p[j]);
    add(2 * h.c[6 + i] * p[i]);
  }
  add(h.c[9]);
  return result;
}

// Parameters t of the points of a line on a quadric, at most two.
std::size_t roots_on(const Line& line, const RealHalfSpace& q, std::array<Real, 2>& t) {
  Real scale = 0;
  for (std::size_t i = 0; i < 6; ++i) scale = larger(scale, magnitude(q.c[i]));
  const Vector3 gradient{q.c[6], q.c[7], q.c[8]};
  const Real a = second_order(q, line.direction, line.direction);
  const Real b = second_order(q, line.point, line.direction) + dot(gradient, line.direction);
  const Real c = value_at(q, line.point).value;
  if (magnitude(a) <= scale * power_of_two(-parallel_bits)) {
    if (b == 0) return 0;
    t[0] = -c / (2 * b);
    return 1;
  }
  const Real product = a * c;
  Real discriminant = b * b - product;
  if (magnitude(discriminant) <= power_of_two(-parallel_bits) * (b * b + magnitude(product))) discriminant = 0;
  if (discriminant < 0) return 0;
  const Real far = b < 0 ? square_root(discriminant) - b : -square_root(discriminant) - b;
  t[0] = far / a;
  t[1] = far == 0 ? 0 : c / far;
  return 2;
}

// Told in doubles by the minors of the symmetric matrix: in a pair of planes, or what `reduce` takes for one, all are below 2^-69 of the cube
// of its largest entry. Their own rounding is some 2^-49 of the terms.
bool is_no_plane_pair(const RealHalfSpace& q) {
  std::array<double, 10> c{};
  double most = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = static_cast<double>(q.c[i]);
    most = std::max(most, std::abs(c[i]));
  }
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const std::size_t i = left_out == 0 ? 1 : 0;
    const std::size_t j = left_out <= 1 ? 2 : 1;
    const std::size_t k = left_out <= 2 ? 3 : 2;
    const auto at = [&c](std::size_t row, std::size_t column) { return c[quadric_index[row][column]]; };
    const std::array<double, 5> terms{at(i, i) * at(j, j) * at(k, k), 2 * at(i, j) * at(j, k) * at(i, k),
                                      -at(i, i) * at(j, k) * at(j, k), -at(j, j) * at(i, k) * at(i, k),
                                      -at(k, k) * at(i, j) * at(i, j)};
    double minor = 0;
    double sizes = 0;
    for (const double term : terms) {
      minor += term;
      sizes += std::abs(term);
    }
    if (std::abs(minor) > sizes * 0x1p-40 && std::abs(minor) > most * most * most * 0x1p-60) return true;
  }
  return false;
}

class Search {
 public:
  Search(std::span<const Side> sides, Real slack)
      : sides_(sides),
        slack_(static_cast<double>(slack)),
        filter_(sides, static_cast<double>(power_of_two(-held_bits))) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const RealHalfSpace& h = sides[i].shape;
      if (h.kind == HalfSpaceKind::plane) {
        make_plane({h.c[0], h.c[1], h.c[2], h.c[3]}, i, planes_);
      } else {
        add_quadric(i);
      }
    }
    for (const UnitPlane& plane : planes_) near_planes_.push_back(enclosure(plane.normal, plane.offset));
  }

  Extent run() {
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      for (std::size_t j = i + 1; j < planes_.size(); ++j) search_line(i, j);
    }
    for (const std::size_t q : quadrics_) search_quadric(q);
    result_.unbounded = !certainly_ends(sides_) && reaches_infinity();
    return result_;
  }

 private:
  // Quadrics that are two planes also take part as planes.
  void add_quadric(std::size_t side) {
    const RealHalfSpace& q = sides_[side].shape;
    quadrics_.push_back(side);
    if (is_no_plane_pair(q)) return;
    const ReducedQuadric reduced = reduce(q, 1);
    const auto& [first, second, third] = reduced.squares;
    if (reduced.linear || reduced.count > 2) return;
    if (reduced.count == 2 && reduced.constant() == 0 && (first.weight < 0) != (second.weight < 0)) {
      const Real a = square_root(magnitude(first.weight));
      const Real b = square_root(magnitude(second.weight));
      for (const int sign : {-1, 1}) {
        Vector4 plane{};
        for (std::size_t i = 0; i < 4; ++i) plane[i] = a * first.form[i] + sign * b * second.form[i];
        make_plane(plane, side, planes_);
      }
    }
    if (reduced.count == 1) {
      const Real square = -reduced.constant() / first.weight;
      if (square < 0) return;
      for (const int sign : {-1, 1}) {
        Vector4 plane = first.form;
        plane[3] += sign * square_root(square);
        make_plane(plane, side, planes_);
      }
    }
  }

  [[nodiscard]] bool held(const Vector3& p, std::initializer_list<std::size_t> on) const {
    const IntervalVector near = enclosure(p);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      bool is_own = false;
      for (const std::size_t own : on) is_own = is_own || own == i;
      if (is_own) continue;
      if (const auto certain = filter_.holds_at(i, near)) {
        if (!*certain) return false;
        continue;
      }
      const Value v = value_at(sides_[i].shape, p);
      const Real outward = sides_[i].complement ? -v.value : v.value;
      if (outward > v.terms * power_of_two(-held_bits)) return false;
    }
    return true;
  }

  void offer(const Vector3& p, std::initializer_list<std::size_t> on) {
    if (!finite(p[0] + p[1] + p[2]) || filter_.is_in_box(enclosure(p)) || !held(p, on)) return;
    include({p, p});
  }

  void include(const Box& part) {
    result_.box = result_.empty ? part : around(result_.box, part);
    result_.empty = false;
    filter_.set_box(result_.box);
  }

  // Needs no look in Real: needless, or known to within the slack, which makes the box no smaller.
  bool settle(const ExtentFilter::Found& found) {
    if (!found) return false;
    const std::span points(found->at.data(), found->count);
    const auto is_far = [this](const IntervalVector& p) {
      return std::any_of(p.begin(), p.end(), [this](const Interval& v) { return !(v.high - v.low < slack_); });
    };
    if (std::any_of(points.begin(), points.end(), is_far)) return false;
    for (const IntervalVector& p : points) {
      include({{p[0].low, p[1].low, p[2].low}, {p[0].high, p[1].high, p[2].high}});
    }
    return true;
  }

  void offer_roots(const Line& line, std::size_t quadric, std::initializer_list<std::size_t> on) {
    std::array<Real, 2> t{};
    const std::size_t count = roots_on(line, sides_[quadric].shape, t);
    for (std::size_t i = 0; i < count; ++i) offer(sum(line.point, scaled(line.direction, t[i])), on);
  }

  // Vertices on the line of two planes: with further planes, and with quadrics.
  void search_line(std::size_t i, std::size_t j) {
    const std::size_t a = planes_[i].side;
    const std::size_t b = planes_[j].side;
    const auto near = meeting_line(near_planes_[i], near_planes_[j]);
    std::vector<std::size_t> planes;
    std::vector<std::size_t> quadrics;
    for (std::size_t k = j + 1; k < planes_.size(); ++k) {
      if (!near || !settle(filter_.on_plane(*near, near_planes_[k], {a, b, planes_[k].side}))) planes.push_back(k);
    }
    for (const std::size_t q : quadrics_) {
      if (!near || !settle(filter_.on_quadric(*near, q, {a, b, q}))) quadrics.push_back(q);
    }
    Line line;
    if ((planes.empty() && quadrics.empty()) || !meet(planes_[i], planes_[j], line)) return;
    for (const std::size_t k : planes) {
      const Real slope = dot(planes_[k].normal, line.direction);
      if (magnitude(slope) <= power_of_two(-parallel_bits)) continue;
      const Real t = -(dot(planes_[k].normal, line.point) + planes_[k].offset) / slope;
      offer(sum(line.point, scaled(line.direction, t)), {a, b, planes_[k].side});
    }
    for (const std::size_t q : quadrics) offer_roots(line, q, {a, b, q});
  }

  // Where the quadric turns along an axis, and where its section with a plane does.
  void search_quadric(std::size_t q) {
    const RealHalfSpace& shape = sides_[q].shape;
    std::array<Vector4, 3> polar{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) polar[i][j] = shape.c[quadric_index[i][j]];
    }
    std::array<IntervalPlane, 3> near_polar;
    for (std::size_t i = 0; i < 3; ++i) near_polar[i] = enclosure({polar[i][0], polar[i][1], polar[i][2]}, polar[i][3]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t b = (axis + 1) % 3;
      const std::size_t c = (axis + 2) % 3;
      std::vector<UnitPlane> turning;
      Line line;
      const auto near = meeting_line(near_polar[b], near_polar[c]);
      const bool is_settled = near && settle(filter_.on_quadric(*near, q, {q}));
      if (!is_settled && make_plane(polar[b], no_side, turning) && make_plane(polar[c], no_side, turning) &&
          meet(turning[0], turning[1], line)) {
        offer_roots(line, q, {q});
      }
      for (std::size_t i = 0; i < planes_.size(); ++i) {
        const UnitPlane& plane = planes_[i];
        if (plane.side == q || settles_section(i, q, near_polar[b], near_polar[c], b, c)) continue;
        search_section(plane, q, polar[b], polar[c], plane.normal[b], plane.normal[c]);
      }
    }
  }

  // The tangent normal x gradient has no part along the axis: normal_b gradient_c = normal_c gradient_b.
  void search_section(const UnitPlane& plane, std::size_t q, const Vector4& polar_b, const Vector4& polar_c,
                      Real normal_b, Real normal_c) {
    Vector4 condition{};
    for (std::size_t i = 0; i < 4; ++i) condition[i] = normal_b * polar_c[i] - normal_c * polar_b[i];
    std::vector<UnitPlane> turning;
    Line line;
    if (make_plane(condition, no_side, turning) && meet(plane, turning[0], line)) {
      offer_roots(line, q, {plane.side, q});
    }
  }

  // search_section without Real, where that will do.
  [[nodiscard]] bool settles_section(std::size_t i, std::size_t q, const IntervalPlane& polar_b,
                                     const IntervalPlane& polar_c, std::size_t b, std::size_t c) {
    const IntervalPlane& plane = near_planes_[i];
    const auto combined = [&](const Interval& of_b, const Interval& of_c) {
      return plane.normal[b] * of_c - plane.normal[c] * of_b;
    };
    IntervalPlane condition;
    for (std::size_t k = 0; k < 3; ++k) condition.normal[k] = combined(polar_b.normal[k], polar_c.normal[k]);
    condition.offset = combined(polar_b.offset, polar_c.offset);
    const auto line = meeting_line(plane, condition);
    return line && settle(filter_.on_quadric(*line, q, {planes_[i].side, q}));
  }

  // Whether half-space `side` allows going on forever along d (of length 1).
  [[nodiscard]] bool allows(const Side& side, const Vector3& d) const {
    const Real sign = side.complement ? -1 : 1;
    const RealHalfSpace& h = side.shape;
    const Real near = power_of_two(-held_bits);
    if (h.kind == HalfSpaceKind::plane) {
      const Vector3 normal{h.c[0], h.c[1], h.c[2]};
      return sign * dot(normal, d) <= near * largest(normal);
    }
    Real scale = 0;
    for (std::size_t i = 0; i < 6; ++i) scale = larger(scale, magnitude(h.c[i]));
    const Real curvature = sign * second_order(h, d, d);
    if (magnitude(curvature) > near * scale) return curvature < 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 row{h.c[quadric_index[i][0]], h.c[quadric_index[i][1]], h.c[quadric_index[i][2]]};
      if (magnitude(dot(row, d)) > near * scale) return true;  // an asymptote: it depends on where one starts
    }
    const Vector3 gradient{h.c[6], h.c[7], h.c[8]};
    return sign * dot(gradient, d) <= near * largest(gradient);
  }

  [[nodiscard]] bool recedes(const Vector3& d) const {
    if (filter_.ends_along(enclosure(d))) return false;
    const auto all_allow = [this](const Vector3& v) {
      for (const Side& side : sides_) {
        if (!allows(side, v)) return false;
      }
      return true;
    };
    return all_allow(d) || all_allow(scaled(d, -1));
  }

  // The body's directions at infinity form a region of the sphere of directions. If there is one, it has a corner
  // (two planes, or a plane and a quadric's asymptotic cone), or a whole circle or cone or all of the sphere in it:
  // then it holds one of the directions tried here.
  [[nodiscard]] bool reaches_infinity() const {
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (tries_circle(planes_[i].normal, quadrics_)) return true;
      for (std::size_t j = i + 1; j < planes_.size(); ++j) {
        const auto near = meeting_line(near_planes_[i], near_planes_[j]);
        if (near && filter_.ends_along(near->direction)) continue;
        Line line;
        if (meet(planes_[i], planes_[j], line) && recedes(line.direction)) return true;
      }
    }
    for (const std::size_t q : quadrics_) {
      for (const Vector3& axis : spectrum_of(sides_[q].shape).vectors) {
        const std::size_t own[] = {q};
        if (recedes(axis) || tries_circle(axis, own)) return true;
      }
    }
    return recedes({1, 0, 0});
  }

  // Directions perpendicular to `normal`: any one, and those on the quadrics' asymptotic cones.
  [[nodiscard]] bool tries_circle(const Vector3& normal, std::span<const std::size_t> quadrics) const {
    const Vector3 helper = magnitude(normal[0]) * 2 < 1 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 across = cross(normal, helper);
    if (filter_.ends_in_plane(enclosure(across), enclosure(cross(normal, across)), quadrics)) {
      return false;
    }
    const Line circle{unit(across), cross(normal, unit(across))};
    if (recedes(circle.point) || recedes(circle.direction)) return true;
    for (const std::size_t q : quadrics) {
      RealHalfSpace cone = sides_[q].shape;
      for (std::size_t i = 6; i < 10; ++i) cone.c[i] = 0;
      std::array<Real, 2> t{};
      const std::size_t count = roots_on(circle, cone, t);
      for (std::size_t i = 0; i < count; ++i) {
        if (recedes(unit(sum(circle.point, scaled(circle.direction, t[i]))))) return true;
      }
    }
    return false;
  }

  std::span<const Side> sides_;
  double slack_;
  ExtentFilter filter_;
  std::vector<UnitPlane> planes_;
  std::vector<IntervalPlane> near_planes_;
  std::vector<std::size_t> quadrics_;
  Extent result_;
};

}  // namespace

Extent extent_of(std::span<const Side> sides, Real slack) { return extent_of(sides, slack, quadrics_may_meet(sides)); }

Extent extent_of(std::span<const Side> sides, Real slack, bool meet) {
  if (sides.size() == 1) {
    if (const auto box = ellipsoid_extent(sides.front())) return {false, false, *box};
  }
  if (meet) {
    Extent extent = meeting_extent(sides, slack);
    if (!extent.unbounded) return extent;
    extent = Search(sides, slack).run();
    extent.unbounded = true;
    return extent;
  }
  return Search(sides, slack).run();
}

Box around(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.low[i] = smaller(a.low[i], b.low[i]);
    result.high[i] = larger(a.high[i], b.high[i]);
  }
  return result;
}

}  // namespace halfspace
