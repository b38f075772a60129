#include "host/resolve/quadric_meeting.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "host/resolve/interval.hpp"

namespace halfspace {
namespace {

constexpr int budget = 8192;        // boxes a sheet; more than a hundred times what a gap of a dot needs
constexpr double finest = 0x1p-16;  // dots: a box of this size that still may hold a meeting counts as one

struct Box {
  double x0, y0, x1, y1;  // multiples of 2^-17 below 2^17: midpoints are exact

  [[nodiscard]] bool is_finest() const { return x1 - x0 <= finest && y1 - y0 <= finest; }
  [[nodiscard]] std::array<Box, 2> halves() const {
    if (x1 - x0 > y1 - y0) {
      const double x = (x0 + x1) / 2;
      return {{{x0, y0, x, y1}, {x, y0, x1, y1}}};
    }
    const double y = (y0 + y1) / 2;
    return {{{x0, y0, x1, y}, {x0, y, x1, y1}}};
  }
};

// A curve's polynomial with enclosed coefficients, all divided by the same power of two.
class EnclosedCurve {
 public:
  EnclosedCurve() = default;
  EnclosedCurve(const Curve& p, long exponent) {
    for (std::size_t i = 0; i < q_.size(); ++i) q_[i] = enclosure(p.q[i], exponent);
  }

  // Taylor's form at the box's centre: exact for degree two, so the enclosure closes in as fast as the box does.
  [[nodiscard]] Interval over(const Box& box) const {
    const Interval x = exactly((box.x0 + box.x1) / 2);
    const Interval y = exactly((box.y0 + box.y1) / 2);
    const double half_x = (box.x1 - box.x0) / 2;
    const double half_y = (box.y1 - box.y0) / 2;
    const Interval dx{-half_x, half_x};
    const Interval dy{-half_y, half_y};
    const Interval two{2, 2};
    const Interval centre = (q_[0] * x + q_[1] * y + q_[3]) * x + (q_[2] * y + q_[4]) * y + q_[5];
    const Interval slope_x = two * q_[0] * x + q_[1] * y + q_[3];
    const Interval slope_y = q_[1] * x + two * q_[2] * y + q_[4];
    return centre + slope_x * dx + slope_y * dy + q_[0] * squared(dx) + q_[1] * (dx * dy) + q_[2] * squared(dy);
  }

 private:
  static Interval exactly(double v) { return {v, v}; }
  std::array<Interval, 6> q_{};
};

// The least e with all coefficients below 2^e.
long exponent_of(const Curve& p) {
  std::size_t bits = 0;
  for (const mpz_class& q : p.q) bits = std::max(bits, mpz_sizeinbase(q.get_mpz_t(), 2));
  return static_cast<long>(bits);
}

long exponent_of(const mpz_class& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

long exponent_of(const Surface& s) { return std::max({exponent_of(s.a), exponent_of(s.b), exponent_of(s.c)}); }

// What sheet.hpp says of two_sheets and of rational, in intervals.
struct EnclosedConstraint {
  std::uint32_t half_space = 0;
  bool curved = false;
  int sense = 1;
  EnclosedCurve p, r;  // rational: c' and b'
  Interval a;
};

class EnclosedSheet {
 public:
  EnclosedSheet(const Sheets& sheets, int t) : two_sheets_(sheets.shape == SheetShape::two_sheets), t_(t) {
    const long own = exponent_of(sheets.surface);
    const long root = (exponent_of(sheets.d) + 1) / 2;
    d_ = EnclosedCurve(sheets.d, 2 * root);
    b_ = EnclosedCurve(sheets.surface.b, own);
    c_ = EnclosedCurve(sheets.surface.c, own);
    for (const Constraint& k : sheets.constraints) constraints_.push_back(enclosed(k, root));
  }

  // The curved constraint that may vanish in the box, or none if no point of the box can be a meeting.
  [[nodiscard]] std::optional<std::uint32_t> possible_meeting(const Box& box) const {
    const Interval d = two_sheets_ ? d_.over(box) : Interval{};
    if (d.negative()) return std::nullopt;
    const Interval b = two_sheets_ ? Interval{} : b_.over(box);
    const Interval c = two_sheets_ ? Interval{} : c_.over(box);
    const Interval root = square_root(d);
    std::optional<std::uint32_t> meeting;
    for (const EnclosedConstraint& k : constraints_) {
      const Interval value = two_sheets_ ? k.p.over(box) + Interval{t_, t_} * k.r.over(box) * root
                                         : k.a * squared(c) - k.r.over(box) * b * c + k.p.over(box) * squared(b);
      if (k.sense > 0 ? value.positive() : value.negative()) return std::nullopt;
      if (k.curved && value.may_vanish()) meeting = k.half_space;
    }
    return meeting;
  }

 private:
  [[nodiscard]] EnclosedConstraint enclosed(const Constraint& k, long root) const {
    if (two_sheets_) {  // P and R sqrt(d) divided by the same 2^scale
      const long scale = std::max(exponent_of(k.p), exponent_of(k.r) + root);
      return {k.half_space, k.curved, k.surface.sense, {k.p, scale}, {k.r, scale - root}, {}};
    }
    const long scale = exponent_of(k.surface);
    return {k.half_space,         k.curved,
            k.surface.sense,      {k.surface.c, scale},
            {k.surface.b, scale}, enclosure(k.surface.a, scale)};
  }

  bool two_sheets_;
  double t_;
  EnclosedCurve d_, b_, c_;
  std::vector<EnclosedConstraint> constraints_;
};

// Depth first: a true meeting is reached after one path of halvings.
std::optional<QuadricMeeting> search(const EnclosedSheet& sheet, const Extent& extent) {
  std::vector<Box> open{{static_cast<double>(extent.x0), static_cast<double>(extent.y0), static_cast<double>(extent.x1),
                         static_cast<double>(extent.y1)}};
  for (int boxes = 0; !open.empty(); ++boxes) {
    const Box box = open.back();
    open.pop_back();
    const auto other = sheet.possible_meeting(box);
    if (!other) continue;
    if (box.is_finest() || boxes >= budget) return QuadricMeeting{*other, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
    for (const Box& half : box.halves()) open.push_back(half);
  }
  return std::nullopt;
}

}  // namespace

std::optional<QuadricMeeting> find_meeting(const Sheets& sheets, const Extent& extent) {
  if (!has_untraced_constraint(sheets)) return std::nullopt;
  if (sheets.shape == SheetShape::rational) return search(EnclosedSheet(sheets, 0), extent);
  if (const auto meeting = search(EnclosedSheet(sheets, -1), extent)) return meeting;
  return search(EnclosedSheet(sheets, 1), extent);
}

}  // namespace halfspace
