#include "host/resolve/enclosed_sheet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/algebra/truncated.hpp"
#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

// The least e with all coefficients below 2^e.
long exponent_of(const mpz_class& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

long exponent_of(const Surface& s) {
  return std::max({exponent_of(s.a), halfspace::exponent_of(s.b), halfspace::exponent_of(s.c)});
}

// q / 2^exponent, truncated: relative error below 2^-52.
double rounded(const mpz_class& q, long exponent) {
  if (mpz_size(q.get_mpz_t()) <= 14 && exponent >= 0 &&
      exponent <= 900) {  // no shorter than 2^-900, nor longer than 2^896
    return truncated(q) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  }
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
Interval EnclosedCurve::over(const DotBox& box) const {
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

QuadraticOnLine EnclosedCurve::on_line(double y) const {
  const double size = std::abs(y);
  return {q_[0], q_[1] * y + q_[3], (q_[2] * y + q_[4]) * y + q_[5], std::abs(q_[1]) * size + std::abs(q_[3]),
          (std::abs(q_[2]) * size + std::abs(q_[4])) * size + std::abs(q_[5])};
}

// As on a box: the sums in b and c are of the same terms, and pass no more roundings.
Interval QuadraticOnLine::over(const Interval& x) const {
  const double middle = (x.low + x.high) / 2;
  const double half = std::max(x.high - middle, middle - x.low);
  const double centre = (a_ * middle + b_) * middle + c_;
  const double size_of_a = std::abs(a_);
  const double reach = std::abs(middle) + half;
  const double size = (size_of_a * reach + size_of_b_) * reach + size_of_c_;
  const double spread = (std::abs(2 * a_ * middle + b_) + size_of_a * half) * half;
  const double radius = spread + size * 0x1p-46 + 0x1p-900;
  return {centre - radius, centre + radius};
}

template <class Form, class Place>
auto SheetForms<Form, Place>::own_forms(const Place& place) const -> Own {
  switch (shape_) {
    case SheetShape::two_sheets: {
      const Interval d = d_.over(place);
      return {d, constraints_.empty() ? Interval{} : square_root(d), {}, {}, d.low >= 0};
    }
    case SheetShape::rational: {
      const Interval b = b_.over(place);
      return {{}, {}, b, c_.over(place), !b.may_vanish()};
    }
    default:
      return {{}, {}, {}, {}, true};
  }
}

template <class Form, class Place>
Interval SheetForms<Form, Place>::value_of(const ConstraintForm& k, const Own& own, const Place& place) const {
  switch (shape_) {
    case SheetShape::two_sheets: {
      const Interval radical = k.r.over(place) * own.root;
      return is_front_ ? k.p.over(place) - radical : k.p.over(place) + radical;
    }
    case SheetShape::rational:
      return k.a * squared(own.c) - k.r.over(place) * own.b * own.c + k.p.over(place) * squared(own.b);
    default:
      return k.p.over(place);
  }
}

template <class Form, class Place>
bool SheetForms<Form, Place>::is_held(const ConstraintForm& k, const Interval& value) {
  return k.sense > 0 ? value.high <= 0 : value.low >= 0;
}

template <class Form, class Place>
Verdict SheetForms<Form, Place>::shows_over(const Place& place) const {
  const Own own = own_forms(place);
  if (own.d.negative()) {
    last_hider_ = sheet_hides;
    return Verdict::nowhere;
  }
  bool sure = own.exists;
  const std::size_t first = last_to_hide_;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const std::size_t index = first + i < constraints_.size() ? first + i : first + i - constraints_.size();
    const ConstraintForm& k = constraints_[index];
    const Interval value = value_of(k, own, place);
    if (k.sense > 0 ? value.positive() : value.negative()) {
      last_to_hide_ = index;
      last_hider_ = static_cast<int>(index);
      return Verdict::nowhere;
    }
    sure = sure && is_held(k, value);
  }
  return sure ? Verdict::everywhere : Verdict::unsure;
}

template <class Form, class Place>
bool SheetForms<Form, Place>::surely_holds(std::size_t constraint, const Place& place) const {
  const ConstraintForm& k = constraints_[constraint];
  return is_held(k, value_of(k, own_forms(place), place));
}

template <class Form, class Place>
bool SheetForms<Form, Place>::implies(std::size_t constraint, const Place& place) const {
  const Own own = own_forms(place);
  if (own.d.negative()) return true;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const ConstraintForm& k = constraints_[i];
    const Interval value = value_of(k, own, place);
    const bool is_outside = k.sense > 0 ? value.positive() : value.negative();
    const bool is_inside = k.sense > 0 ? value.negative() : value.positive();
    if (i == constraint ? is_inside : is_outside) return true;
  }
  return false;
}

template class SheetForms<EnclosedCurve, DotBox>;
template class SheetForms<QuadraticOnLine, Interval>;

EnclosedSheet::EnclosedSheet(const Sheets& sheets, Sheet sheet) {
  shape_ = sheets.shape;
  is_front_ = sheet == Sheet::front;
  const long root = (exponent_of(sheets.d) + 1) / 2;
  if (shape_ == SheetShape::two_sheets) d_ = EnclosedCurve(sheets.d, 2 * root);
  if (shape_ == SheetShape::rational) {
    const long own = exponent_of(sheets.surface);
    b_ = EnclosedCurve(sheets.surface.b, own);
    c_ = EnclosedCurve(sheets.surface.c, own);
  }
  for (const Constraint& k : sheets.constraints) constraints_.push_back(enclosed(k, root));
}

EnclosedSheet::ConstraintForm EnclosedSheet::enclosed(const Constraint& k, long root_exponent) const {
  if (shape_ == SheetShape::rational) {
    const long scale = exponent_of(k.surface);
    return {k.surface.sense, {k.surface.c, scale}, {k.surface.b, scale}, enclosure(k.surface.a, scale)};
  }
  const long scale = std::max(exponent_of(k.p), exponent_of(k.r) + root_exponent);  // one for P and R sqrt(d)
  return {k.surface.sense, {k.p, scale}, {k.r, scale - root_exponent}, {}};
}

SheetOnLine EnclosedSheet::on_line(double y) const {
  SheetOnLine line;
  line.shape_ = shape_;
  line.is_front_ = is_front_;
  if (shape_ == SheetShape::two_sheets) line.d_ = d_.on_line(y);
  if (shape_ == SheetShape::rational) {
    line.b_ = b_.on_line(y);
    line.c_ = c_.on_line(y);
  }
  line.constraints_.reserve(constraints_.size());
  for (const ConstraintForm& k : constraints_) {
    line.constraints_.push_back({k.sense, k.p.on_line(y), k.r.on_line(y), k.a});
  }
  return line;
}

}  // namespace halfspace
