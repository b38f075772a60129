#include "host/flatten/meeting_extent.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "host/flatten/outer_search.hpp"
#include "host/flatten/turning_points.hpp"

namespace halfspace {
namespace {

constexpr int form_bits = 110;    // of coefficients in the body's frame
constexpr int outward_bits = 80;  // 2^-80 of the terms, see above
constexpr int end_bits = 60;
constexpr int endless_bits = 30;
constexpr int least_bits =
    24;  // a frame is no smaller than 2^-24 of what is told: then 2^-80 of its terms is more than 113 bits lose

// Body coordinates x' with x = centre + size x'; sizes are powers of two.
struct Frame {
  Vector3 centre{}, size{};
};

Real power_above(Real v) {
  Real power = 1;
  while (power < v) power = power * 2;
  while (power / 2 >= v && power > power_of_two(-4000)) power = power / 2;
  return power;
}

// Negative inside.
RealHalfSpace signed_shape(const Side& side) {
  RealHalfSpace h = side.shape;
  if (side.complement) {
    for (Real& v : h.c) v = -v;
  }
  return h;
}

// Of x with the form's own coordinates unit x; of the same size about x = 1.
RealHalfSpace in_units(const RealHalfSpace& shape, Real unit) {
  RealHalfSpace h = shape;
  const bool is_plane = h.kind == HalfSpaceKind::plane;
  for (std::size_t i = is_plane ? 3 : 6; i < (is_plane ? 4 : 9); ++i) h.c[i] = h.c[i] / unit;
  if (!is_plane) h.c[9] = h.c[9] / (unit * unit);
  return h;
}

// Moved outwards.
std::vector<RealHalfSpace> in_frame(std::span<const Side> sides, const Frame& frame) {
  Matrix4 matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    matrix[i][i] = frame.size[i];
    matrix[3][i] = frame.centre[i];
  }
  matrix[3][3] = 1;
  std::vector<RealHalfSpace> result;
  for (const Side& side : sides) {
    RealHalfSpace h = normalised(transformed(signed_shape(side), matrix));
    const Real share = 1 + Real(result.size()) / 32;
    h.c[h.kind == HalfSpaceKind::plane ? 3 : 9] -= share * power_of_two(-outward_bits);
    result.push_back(h);
  }
  return result;
}

// The distances that the coefficients hold: of centres from the origin, and radii.
Real size_told(std::span<const Side> sides) {
  Real size = 0;
  for (const Side& side : sides) {
    const auto& c = side.shape.c;
    if (side.shape.kind == HalfSpaceKind::plane) {
      const Real normal = largest({c[0], c[1], c[2]});
      if (normal != 0) size = larger(size, magnitude(c[3]) / normal);
      continue;
    }
    Real squares = 0;
    for (std::size_t i = 0; i < 6; ++i) squares = larger(squares, magnitude(c[i]));
    if (squares == 0) continue;
    size = larger(size, largest({c[6], c[7], c[8]}) / squares);
    size = larger(size, square_root(magnitude(c[9]) / squares));
  }
  return size == 0 ? Real(1) : size;
}

// The part's middle is rounded, so that simple numbers stay simple.
Frame frame_around(const CentredBox& part, const Frame& frame, Real least_size) {
  Frame closer;
  for (std::size_t i = 0; i < 3; ++i) {
    closer.size[i] = larger(power_above(part.half[i] * frame.size[i] * Real(1.0625)), least_size);
    const Real unit = closer.size[i] / 16;
    closer.centre[i] = nearest_whole((frame.centre[i] + part.middle[i] * frame.size[i]) / unit) * unit;
  }
  return closer;
}

// A body and the part of its frame that it can be in.
struct FramedBody {
  Frame frame;
  std::vector<RealHalfSpace> shapes;
  std::vector<BoundForm> bounds;
  CentredBox part{{0, 0, 0}, {1, 1, 1}};
};

// The frame shrunk until the part fills it; none where there is no body.
std::optional<FramedBody> framed(std::span<const Side> sides, const Frame& whole, Real told) {
  FramedBody body{whole, {}, {}, {}};
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    body.shapes = in_frame(sides, body.frame);
    body.bounds.clear();
    for (const RealHalfSpace& h : body.shapes) body.bounds.emplace_back(h);
    const bool is_far = largest(body.frame.size) > told * 64;
    const auto part = part_with_body(body.bounds, {{0, 0, 0}, {1, 1, 1}}, is_far);
    if (!part) return std::nullopt;
    body.part = *part;
    const Frame closer = frame_around(body.part, body.frame, told * power_of_two(-least_bits));
    if (closer.size == body.frame.size || step + 1 == most_steps) break;
    body.frame = closer;
  }
  return body;
}

mpz_class whole(Real v, int bits) { return round_to_integer(v * power_of_two(bits)); }

// Turned so that u is the axis, v and w across it and in no special direction.
SliceForm slice_form(const RealHalfSpace& h, std::size_t axis) {
  constexpr std::array<std::array<int, 4>, 4> turn{{{1, 0, 0, 0}, {0, 1, 2, 0}, {0, -2, 3, 0}, {0, 0, 0, 1}}};
  const std::array<std::size_t, 4> place{axis, (axis + 1) % 3, (axis + 2) % 3, 3};
  std::array<std::array<mpz_class, 4>, 4> m;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const bool is_plane = h.kind == HalfSpaceKind::plane;
      const std::size_t a = place[i];
      const std::size_t b = place[j];
      const bool is_last = a == 3 && b == 3;
      const Real entry = !is_plane ? h.c[quadric_index[a][b]]
                         : is_last ? h.c[3]
                         : a == 3  ? h.c[b] / 2
                         : b == 3  ? h.c[a] / 2
                                   : 0;
      m[i][j] = whole(entry, form_bits + 1);
    }
  }
  const auto entry = [&](std::size_t i, std::size_t j) {
    mpz_class sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l < 4; ++l) sum += turn[i][k] * m[k][l] * turn[j][l];
    }
    return sum;
  };
  SliceForm form{{entry(0, 0), entry(1, 1), entry(2, 2), 2 * entry(0, 1), 2 * entry(1, 2), 2 * entry(0, 2),
                  2 * entry(0, 3), 2 * entry(1, 3), 2 * entry(2, 3), entry(3, 3)}};
  mpz_class divisor = 0;
  for (const mpz_class& c : form.q) divisor = gcd(divisor, c);
  for (mpz_class& c : form.q) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return form;
}

mpz_class position_of(double v) { return whole(Real(v), position_bits); }

// A body along one axis of its frame.
class AxisSearch {
 public:
  AxisSearch(const FramedBody& body, std::size_t axis) : body_(body), axis_(axis) {}

  // The body's last position in the direction of `sign`; none where it has no point.
  [[nodiscard]] std::optional<Real> end(double sign, double slack) {
    const CentredBox& part = body_.part;
    const Outermost outer = search_outwards(body_.bounds, part, axis_, sign, slack);
    const bool is_known = std::isfinite(outer.known);
    if (outer.bound > outer.known) {
      if (outer.bound - outer.known <= slack) return Real(sign * outer.bound);
      const double inner = is_known ? outer.known : sign * part.middle[axis_] - part.half[axis_] * (1 + 0x1p-30);
      if (const auto exact = last_plane(sign, inner, outer)) return exact;
    }
    return is_known ? std::optional(Real(sign * outer.known)) : std::nullopt;
  }

  // Has the body a point in this plane? Boxes first, then integers.
  [[nodiscard]] bool has_section_at(double at) {
    if (const auto quick = meets_plane(body_.bounds, body_.part, axis_, at)) return *quick;
    prepare();
    return meets_plane(forms_, Dyadic{position_of(at), position_bits});
  }

 private:
  [[nodiscard]] std::optional<Real> last_plane(double sign, double inner, const Outermost& outer) {
    prepare();
    std::vector<Polynomial> marks;
    for (const Meeting& meeting : outer.meetings) {
      const std::vector<Polynomial>& own = turning_->of(meeting);
      marks.insert(marks.end(), own.begin(), own.end());
    }
    const double low = sign > 0 ? inner : -outer.bound;
    const double high = sign > 0 ? outer.bound : -inner;
    RootGaps gaps(marks, position_of(low), position_of(high));
    for (std::size_t n = 0; n < gaps.count(); ++n) {
      const std::size_t i = sign > 0 ? gaps.count() - 1 - n : n;
      if (gaps.is_empty(i) || !has_section_in(gaps, i)) continue;
      return simple(sign > 0 ? gaps.high_end(i) : gaps.low_end(i));
    }
    return std::nullopt;
  }

  // One plane tells, whichever: one that doubles can name, if there is one.
  [[nodiscard]] bool has_section_in(const RootGaps& gaps, std::size_t gap) {
    const Dyadic u = gaps.inside(gap);
    const double near = std::ldexp(u.number.get_d(), -static_cast<int>(u.shift));
    return gaps.holds(gap, position_of(near)) ? has_section_at(near) : meets_plane(forms_, u);
  }

  void prepare() {
    if (turning_) return;
    for (const RealHalfSpace& h : body_.shapes) forms_.push_back(slice_form(h, axis_));
    turning_ = std::make_unique<TurningPoints>(forms_);
  }

  static Real simple(const mpz_class& position) {
    mpz_class result = position + (mpz_class(1) << (position_bits - end_bits - 1));
    mpz_fdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), position_bits - end_bits);
    return to_real(result) * power_of_two(-end_bits);
  }

  const FramedBody& body_;
  std::size_t axis_;
  std::vector<SliceForm> forms_;
  std::unique_ptr<TurningPoints> turning_;
};

// Does it pass through the planes at this distance from the origin?
bool reaches(const FramedBody& body, Real distance) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      const auto at = static_cast<double>((sign * distance - body.frame.centre[axis]) / body.frame.size[axis]);
      if (std::abs(at - body.part.middle[axis]) > body.part.half[axis]) continue;
      if (AxisSearch(body, axis).has_section_at(at)) return true;
    }
  }
  return false;
}

std::optional<Box> box_of(const FramedBody& body, Real slack) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    AxisSearch search(body, axis);
    const Real size = body.frame.size[axis];
    const auto low = search.end(-1, static_cast<double>(slack / size));
    const auto high = low ? search.end(1, static_cast<double>(slack / size)) : std::nullopt;
    if (!high) return std::nullopt;
    box.low[axis] = body.frame.centre[axis] + *low * size;
    box.high[axis] = body.frame.centre[axis] + *high * size;
  }
  return box;
}

Frame frame_around(const Box& box, Real least_size) {
  const Frame unit{{0, 0, 0}, {1, 1, 1}};
  CentredBox cell;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.middle[i] = static_cast<double>((box.low[i] + box.high[i]) / 2);
    cell.half[i] = static_cast<double>((box.high[i] - box.low[i]) / 2 + magnitude(box.low[i]) * power_of_two(-50));
  }
  return frame_around(cell, unit, least_size);
}

bool is_much_smaller(const Frame& a, const Frame& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.size[i] * 8 <= b.size[i]) return true;
  }
  return false;
}

}  // namespace

bool quadrics_may_meet(std::span<const Side> sides) {
  std::set<std::size_t> families;
  for (const Side& side : sides) {
    if (side.family) families.insert(*side.family);
  }
  if (families.size() < 2) return false;
  const Real unit = 2 * power_above(size_told(sides));
  std::vector<BoundForm> forms;
  std::vector<std::optional<std::size_t>> families_of;
  for (const Side& side : sides) {
    forms.emplace_back(in_units(signed_shape(side), unit));
    families_of.push_back(side.family);
  }
  return may_meet(forms, families_of);
}

Extent meeting_extent(std::span<const Side> sides, Real slack) {
  const Real told = power_above(size_told(sides));
  const Real reach = told * power_of_two(endless_bits);
  Frame frame{{0, 0, 0}, {reach, reach, reach}};
  constexpr int most_frames = 4;
  for (int n = 1;; ++n) {
    const auto body = framed(sides, frame, told);
    if (!body) return {};
    if (reaches(*body, reach / 2)) return {true, true, {}};
    const auto box = box_of(*body, slack);
    if (!box) return {};
    frame = frame_around(*box, told * power_of_two(-least_bits));
    // In one that is too large surfaces have been moved too far.
    if (n == most_frames || !is_much_smaller(frame, body->frame)) return {false, false, *box};
  }
}

}  // namespace halfspace
