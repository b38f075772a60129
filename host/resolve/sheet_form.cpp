#include "host/resolve/sheet_form.hpp"

#include <algorithm>

namespace halfspace {
namespace {

int factor_of(Sheet sheet) { return sheet == Sheet::front ? -1 : 1; }

// a' c^2 - b' b c + c' b^2
Polynomial rational_form(const Surface& own, const Surface& k, long y) {
  const Polynomial b = restricted(own.b, y);
  const Polynomial c = restricted(own.c, y);
  const Polynomial mixed = times(times(restricted(k.b, y), b), c);
  return plus(minus(times({k.a}, times(c, c)), mixed), times(restricted(k.c, y), times(b, b)));
}

// Of a value in an interval; nothing where that is not sure.
std::optional<int> sign_of(const Interval& value) {
  if (value.may_vanish()) return std::nullopt;
  return value.positive() ? 1 : -1;
}

}  // namespace

EnclosedForm::EnclosedForm(const Sheets& sheets, const Constraint& k) {
  const long root = (exponent_of(sheets.d) + 1) / 2;
  const long scale = std::max(exponent_of(k.p), exponent_of(k.r) + root);  // one for P and R sqrt(d)
  p = EnclosedCurve(k.p, scale);
  r = EnclosedCurve(k.r, scale - root);
  d = EnclosedCurve(sheets.d, 2 * root);
}

ValueOnLine::ValueOnLine(const Sheets& sheets, const Constraint& k, long y, const EnclosedForm* near)
    : sheets_(&sheets), constraint_(&k), y_(y) {
  if (near == nullptr || sheets.shape != SheetShape::two_sheets) return;
  const auto line = static_cast<double>(y);
  near_ = OnLine{near->p.on_line(line), near->r.on_line(line), near->d.on_line(line)};
}

const ValueOnLine::OnLine* ValueOnLine::near(const LineRoot& x) const {
  constexpr double largest = 0x1p70;  // keeps every product in the enclosures finite
  return near_ && -largest < x.near.low && x.near.high < largest ? &*near_ : nullptr;
}

const ValueOnLine::Exact& ValueOnLine::exact() const {
  if (exact_) return *exact_;
  exact_.emplace();
  if (sheets_->shape == SheetShape::rational) {
    exact_->p = AskedPolynomial(rational_form(sheets_->surface, constraint_->surface, y_));
    return *exact_;
  }
  exact_->p = AskedPolynomial(restricted(constraint_->p, y_));
  if (sheets_->shape != SheetShape::two_sheets) return *exact_;
  exact_->r = AskedPolynomial(restricted(constraint_->r, y_));
  exact_->d = AskedPolynomial(restricted(sheets_->d, y_));
  return *exact_;
}

int ValueOnLine::sign(Sheet sheet, const LineRoot& x) const {
  const int t = factor_of(sheet);
  if (const OnLine* line = near(x)) {
    const Interval radical = line->r.over(x.near) * square_root(line->d.over(x.near));
    const Interval p = line->p.over(x.near);
    if (const auto sign = sign_of(t < 0 ? p - radical : p + radical)) return *sign;
  }
  const auto& [p, r, d] = exact();
  const int sign_p = p.sign_at(x);
  if (sheets_->shape != SheetShape::two_sheets) return sign_p;
  const int sign_r = t * r.sign_at(x);
  if (sign_r == 0 || sign_r == sign_p) return sign_p;
  const int sign_root = sign_r * d.sign_at(x);
  if (sign_p * sign_root >= 0) return sign_p != 0 ? sign_p : sign_root;
  const Polynomial rr = times(r.exact(), r.exact());
  return sign_p * sign_at(minus(times(p.exact(), p.exact()), times(rr, d.exact())), x);
}

bool ValueOnLine::vanishes(Sheet sheet, const LineRoot& root) const {
  if (sheets_->shape != SheetShape::two_sheets) return true;
  const OnLine* line = near(root);
  const auto sign = [&](QuadraticOnLine OnLine::*enclosed, AskedPolynomial Exact::*asked) {
    const auto certain = line != nullptr ? sign_of((line->*enclosed).over(root.near)) : std::nullopt;
    return certain ? *certain : (exact().*asked).sign_at(root);
  };
  const int sign_d = sign(&OnLine::d, &Exact::d);
  if (sign_d <= 0) return sign_d == 0;
  return sign(&OnLine::p, &Exact::p) == -factor_of(sheet) * sign(&OnLine::r, &Exact::r);
}

}  // namespace halfspace
