#include "host/flatten/meeting_extent.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<RealHalfSpace> in_frame(std::span<const Side> sides, const Frame& frame) {
  Matrix4 matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    matrix[i][i] = frame.size[i];
    matrix[3][i] = frame.centre[i];
  }
  matrix[3][3] = 1;
  std::vector<RealHalfSpace> result;
  for (const Side& side : sides) {
    RealHalfSpace h = normalised(transformed(side.shape, matrix));
    if (side.complement) {
      for (Real& v : h.c) v = -v;
    }
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
Frame frame_around(const Cell& part, const Frame& frame, Real least_size) {
  Frame closer;
  for (std::size_t i = 0; i < 3; ++i) {
    closer.size[i] = larger(power_above(part.half[i] * frame.size[i] * Real(1.0625)), least_size);
    const Real unit = closer.size[i] / 16;
    closer.centre[i] = nearest_whole((frame.centre[i] + part.middle[i] * frame.size[i]) / unit) * unit;
  }
  return closer;
}

// Shrunk to the part that the body can be in, until it fits; none where there is no body.
std::optional<Frame> frame_of(std::span<const Side> sides, Real told, Cell& part) {
  const Real reach = told * power_of_two(endless_bits);
  Frame frame{{0, 0, 0}, {reach, reach, reach}};
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    std::vector<BoundForm> bounds;
    for (const RealHalfSpace& h : in_frame(sides, frame)) bounds.emplace_back(h);
    const auto found = part_with_body(bounds, {{0, 0, 0}, {1, 1, 1}});
    if (!found) return std::nullopt;
    part = *found;
    const Frame closer = frame_around(part, frame, told * power_of_two(-least_bits));
    if (closer.size == frame.size) break;
    frame = closer;
  }
  return frame;
}

mpz_class whole(Real v, int bits) { return round_to_integer(v * power_of_two(bits)); }

// Turned so that u is the axis, v and w across it and in no special direction, and moved outwards by the number's part.
SliceForm slice_form(const RealHalfSpace& h, std::size_t axis, std::size_t number) {
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
  m[3][3] -= (mpz_class(32) + number) << (form_bits + 1 - outward_bits - 5);
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

// The ends of a body along one axis, in its frame.
class AxisEnds {
 public:
  AxisEnds(const std::vector<RealHalfSpace>& shapes, const std::vector<BoundForm>& bounds, const Cell& part,
           std::size_t axis)
      : shapes_(shapes), bounds_(bounds), part_(part), axis_(axis) {}

  // The body's last position in the direction of `sign`; none where it has no point.
  [[nodiscard]] std::optional<Real> end(double sign, std::optional<double> known, double slack) {
    constexpr double none = -std::numeric_limits<double>::infinity();
    const Outermost outer = search_outwards(bounds_, part_, axis_, sign, known ? sign * *known : none, slack);
    if (!(outer.bound > outer.known)) return outer.known == none ? std::optional<Real>() : Real(sign * outer.known);
    if (outer.bound - outer.known <= slack) return Real(sign * outer.bound);
    const double inner = std::max(outer.known, sign * part_.middle[axis_] - part_.half[axis_] * 1.001);
    if (const auto exact = last_plane(sign, inner, outer)) return exact;
    return outer.known == none ? std::optional<Real>() : Real(sign * outer.known);
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
      if (gaps.is_empty(i) || !meets_plane(forms_, gaps.inside(i))) continue;
      return simple(sign > 0 ? gaps.high_end(i) : gaps.low_end(i));
    }
    return std::nullopt;
  }

  void prepare() {
    if (turning_) return;
    for (std::size_t i = 0; i < shapes_.size(); ++i) forms_.push_back(slice_form(shapes_[i], axis_, i));
    turning_ = std::make_unique<TurningPoints>(forms_);
  }

  static Real simple(const mpz_class& position) {
    mpz_class result = position + (mpz_class(1) << (position_bits - end_bits - 1));
    mpz_fdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), position_bits - end_bits);
    return to_real(result) * power_of_two(-end_bits);
  }

  const std::vector<RealHalfSpace>& shapes_;
  const std::vector<BoundForm>& bounds_;
  const Cell& part_;
  std::size_t axis_;
  std::vector<SliceForm> forms_;
  std::unique_ptr<TurningPoints> turning_;
};

}  // namespace

Extent meeting_extent(std::span<const Side> sides, const Extent& found, Real slack) {
  const Real told = power_above(size_told(sides));
  const Real endless = told * power_of_two(endless_bits - 1);
  Cell part;
  const auto frame = frame_of(sides, told, part);
  if (!frame) return found.empty ? Extent{} : Extent{false, false, found.box};
  const std::vector<RealHalfSpace> shapes = in_frame(sides, *frame);
  std::vector<BoundForm> bounds;
  for (const RealHalfSpace& h : shapes) bounds.emplace_back(h);

  Extent result;
  result.empty = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    AxisEnds ends(shapes, bounds, part, axis);
    const Real size = frame->size[axis];
    const auto end_in = [&](double sign, Real known) {
      std::optional<double> start;
      if (!found.empty) start = static_cast<double>((known - frame->centre[axis]) / size);
      const auto end = ends.end(sign, start, static_cast<double>(slack / size));
      if (!end) return false;
      const Real at = frame->centre[axis] + *end * size;
      (sign > 0 ? result.box.high : result.box.low)[axis] = at;
      if (magnitude(at) > endless) result.unbounded = true;
      return true;
    };
    if (!end_in(-1, found.box.low[axis]) || !end_in(1, found.box.high[axis]))
      return found.empty ? Extent{} : Extent{false, false, found.box};
  }
  return result;
}

}  // namespace halfspace
