#include "host/resolve/enclosed_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// The least e with all coefficients below 2^e.
long exponent_of(const mpz_class& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

long exponent_of(const Curve& p) {
  long exponent = 0;
  for (const mpz_class& q : p.q) exponent = std::max(exponent, exponent_of(q));
  return exponent;
}

long exponent_of(const Surface& s) { return std::max({exponent_of(s.a), exponent_of(s.b), exponent_of(s.c)}); }

Interval exactly(double v) { return {v, v}; }

// q / 2^exponent, truncated: relative error below 2^-52.
double rounded(const mpz_class& q, long exponent) {
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, q.get_mpz_t());
  return std::ldexp(mantissa, static_cast<int>(std::max(own - exponent, -4000L)));
}

}  // namespace

EnclosedCurve::EnclosedCurve(const Curve& p, long exponent) {
  for (std::size_t i = 0; i < q_.size(); ++i) q_[i] = rounded(p.q[i], exponent);
}

// Taylor's form at the box's centre: exact for degree two, so the enclosure closes in as fast as the box does.
// Rounding  A monomial of the value, and of a slope times its half side, passes at most ten roundings of 2^-53, the coefficient's
//           own counted twice: within 2^-48 of `size`, the sum of their absolute values. What underflows is below 2^-900.
Interval EnclosedCurve::over(const Box& box) const {
  const double x = (box.x0 + box.x1) / 2;
  const double y = (box.y0 + box.y1) / 2;
  const double half_x = std::max(box.x1 - x, x - box.x0);
  const double half_y = std::max(box.y1 - y, y - box.y0);
  const double centre = (q_[0] * x + q_[1] * y + q_[3]) * x + (q_[2] * y + q_[4]) * y + q_[5];
  const double slope_x = 2 * q_[0] * x + q_[1] * y + q_[3];
  const double slope_y = q_[1] * x + 2 * q_[2] * y + q_[4];
  const auto size_at = [this](double u, double v) {
    return (std::abs(q_[0]) * u + std::abs(q_[1]) * v + std::abs(q_[3])) * u +
           (std::abs(q_[2]) * v + std::abs(q_[4])) * v + std::abs(q_[5]);
  };
  const double size = size_at(std::abs(x) + half_x, std::abs(y) + half_y);
  const double spread = std::abs(slope_x) * half_x + std::abs(slope_y) * half_y + std::abs(q_[0]) * half_x * half_x +
                        std::abs(q_[1]) * half_x * half_y + std::abs(q_[2]) * half_y * half_y;
  const double radius = spread + size * 0x1p-46 + 0x1p-900;
  return {centre - radius, centre + radius};
}

EnclosedLine::EnclosedLine(const Curve& p, long exponent) {
  for (std::size_t i = 0; i < q_.size(); ++i) q_[i] = rounded(p.q[3 + i], exponent);
}

// Rounding as above, with fewer terms.
Interval EnclosedLine::over(const Box& box) const {
  const double x = (box.x0 + box.x1) / 2;
  const double y = (box.y0 + box.y1) / 2;
  const double half_x = std::max(box.x1 - x, x - box.x0);
  const double half_y = std::max(box.y1 - y, y - box.y0);
  const double centre = q_[0] * x + q_[1] * y + q_[2];
  const double spread = std::abs(q_[0]) * half_x + std::abs(q_[1]) * half_y;
  const double size = std::abs(q_[0] * x) + std::abs(q_[1] * y) + std::abs(q_[2]) + spread;
  const double radius = spread + size * 0x1p-46 + 0x1p-900;
  return {centre - radius, centre + radius};
}

EnclosedSheet::EnclosedSheet(const Sheets& sheets, Sheet sheet)
    : shape_(sheets.shape), t_(sheet == Sheet::front ? -1 : 1) {
  const long root = (exponent_of(sheets.d) + 1) / 2;
  if (shape_ == SheetShape::two_sheets) d_ = EnclosedCurve(sheets.d, 2 * root);
  if (shape_ == SheetShape::rational) {
    const long own = exponent_of(sheets.surface);
    b_ = EnclosedLine(sheets.surface.b, own);
    c_ = EnclosedCurve(sheets.surface.c, own);
  }
  for (const Constraint& k : sheets.constraints) constraints_.push_back(enclosed(k, root));
}

EnclosedSheet::EnclosedConstraint EnclosedSheet::enclosed(const Constraint& k, long root_exponent) const {
  if (shape_ == SheetShape::rational) {
    const long scale = exponent_of(k.surface);
    return {k.surface.sense, {k.surface.c, scale}, {k.surface.b, scale}, enclosure(k.surface.a, scale)};
  }
  const long scale = std::max(exponent_of(k.p), exponent_of(k.r) + root_exponent);  // one for P and R sqrt(d)
  return {k.surface.sense, {k.p, scale}, {k.r, scale - root_exponent}, {}};
}

EnclosedSheet::OnBox EnclosedSheet::own_forms(const Box& box) const {
  switch (shape_) {
    case SheetShape::two_sheets: {
      const Interval d = d_.over(box);
      return {d, square_root(d), {}, {}, d.low >= 0};
    }
    case SheetShape::rational: {
      const Interval b = b_.over(box);
      return {{}, {}, b, c_.over(box), !b.may_vanish()};
    }
    default:
      return {{}, {}, {}, {}, true};
  }
}

Interval EnclosedSheet::value_of(const EnclosedConstraint& k, const OnBox& own, const Box& box) const {
  switch (shape_) {
    case SheetShape::two_sheets:
      return k.p.over(box) + exactly(t_) * k.r.over(box) * own.root;
    case SheetShape::rational:
      return k.a * squared(own.c) - k.r.over(box) * own.b * own.c + k.p.over(box) * squared(own.b);
    default:
      return k.p.over(box);
  }
}

bool EnclosedSheet::is_held(const EnclosedConstraint& k, const Interval& value) {
  return k.sense > 0 ? value.high <= 0 : value.low >= 0;
}

Verdict EnclosedSheet::shows_over(const Box& box) const {
  const OnBox own = own_forms(box);
  if (own.d.negative()) return Verdict::nowhere;
  bool sure = own.exists;
  for (const EnclosedConstraint& k : constraints_) {
    const Interval value = value_of(k, own, box);
    if (k.sense > 0 ? value.positive() : value.negative()) return Verdict::nowhere;
    sure = sure && is_held(k, value);
  }
  return sure ? Verdict::everywhere : Verdict::unsure;
}

bool EnclosedSheet::surely_exists(const Box& box) const { return own_forms(box).exists; }

bool EnclosedSheet::surely_holds(std::size_t constraint, const Box& box) const {
  const EnclosedConstraint& k = constraints_[constraint];
  return is_held(k, value_of(k, own_forms(box), box));
}

bool EnclosedSheet::implies(std::size_t constraint, const Box& box) const {
  const OnBox own = own_forms(box);
  if (own.d.negative()) return true;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const EnclosedConstraint& k = constraints_[i];
    const Interval value = value_of(k, own, box);
    const bool is_outside = k.sense > 0 ? value.positive() : value.negative();
    const bool is_inside = k.sense > 0 ? value.negative() : value.positive();
    if (i == constraint ? is_inside : is_outside) return true;
  }
  return false;
}

}  // namespace halfspace
