#include "host/resolve/sheet_on_line.hpp"

namespace halfspace {

LinePolynomial restricted(const Curve& p, const mpz_class& y) {
  const auto& q = p.q;
  return {q[0], q[1] * y + q[3], (q[2] * y + q[4]) * y + q[5]};
}

SheetOnLine::SheetOnLine(const Sheets& sheets, const mpz_class& y)
    : shape_(sheets.shape),
      d_(restricted(sheets.d, y)),
      b_(restricted(sheets.surface.b, y)),
      c_(restricted(sheets.surface.c, y)) {
  const bool rational = shape_ == SheetShape::rational;
  for (const Constraint& k : sheets.constraints) {
    constraints_.push_back({k.surface.sense, restricted(rational ? k.surface.c : k.p, y),
                            restricted(rational ? k.surface.b : k.r, y), k.surface.a});
  }
}

bool SheetOnLine::shows_at(const LineRoot& x, Sheet sheet) const {
  const LinePoint point(x);
  switch (shape_) {
    case SheetShape::two_sheets:
      return shows_on_two_sheets(point, sheet == Sheet::front ? -1 : 1);
    case SheetShape::flat:
      return shows_on_flat(point);
    case SheetShape::rational:
      return shows_on_rational(point);
    case SheetShape::none:
      break;
  }
  return false;
}

bool SheetOnLine::shows_on_two_sheets(const LinePoint& x, int t) const {
  const Surd d = x.quadratic(d_);
  if (x.sign(d) < 0) return false;
  for (const ConstraintOnLine& k : constraints_) {
    Surd r = x.linear(k.r);
    if (t < 0) r = {-r.u, -r.v};
    if (k.sense * x.sign(x.quadratic(k.p), r, d) > 0) return false;
  }
  return true;
}

bool SheetOnLine::shows_on_flat(const LinePoint& x) const {
  for (const ConstraintOnLine& k : constraints_) {
    if (k.sense * x.sign(x.quadratic(k.p)) > 0) return false;
  }
  return true;
}

// a' c^2 - b' b c + c' b^2, each term multiplied by r^4.
bool SheetOnLine::shows_on_rational(const LinePoint& x) const {
  const Surd b = x.linear(b_);
  if (x.sign(b) == 0) return false;
  const Surd c = x.quadratic(c_);
  const Surd bb = x.times(b, b);
  const Surd cc = x.times(c, c);
  for (const ConstraintOnLine& k : constraints_) {
    const Surd mixed = x.times(x.times(x.linear(k.r), b), c);
    const Surd last = x.times(x.quadratic(k.p), bb);
    const Surd value{k.a * cc.u - mixed.u + last.u, k.a * cc.v - mixed.v + last.v};
    if (k.sense * x.sign(value) > 0) return false;
  }
  return true;
}

}  // namespace halfspace
