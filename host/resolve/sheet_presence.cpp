#include "host/resolve/sheet_presence.hpp"

namespace halfspace {
namespace {

// Keeps every product in the enclosures finite.
bool is_small(const Interval& x) { return -0x1p40 < x.low && x.high < 0x1p40; }

}  // namespace

bool SheetPresence::shows_at(const RowPoint& x, std::int64_t y) const {
  if (is_small(x.near())) {
    const auto line = static_cast<double>(y);
    const Verdict verdict = enclosed_.shows_over({x.near().low, line, x.near().high, line});
    if (verdict != Verdict::unsure) return verdict == Verdict::everywhere;
  }
  return shows_exactly(LinePoint(x.exact()), static_cast<long>(y));
}

bool SheetPresence::may_show(const IntervalPoint& point) const {
  if (!is_small(point.x) || !is_small(point.y)) return true;
  return enclosed_.shows_over({point.x.low, point.y.low, point.x.high, point.y.high}) != Verdict::nowhere;
}

bool SheetPresence::shows_exactly(const LinePoint& x, const mpz_class& y) const {
  switch (sheets_.shape) {
    case SheetShape::two_sheets:
      return shows_on_two_sheets(x, y);
    case SheetShape::flat:
      return shows_on_flat(x, y);
    case SheetShape::rational:
      return shows_on_rational(x, y);
    case SheetShape::none:
      break;
  }
  return false;
}

bool SheetPresence::shows_on_two_sheets(const LinePoint& x, const mpz_class& y) const {
  const Surd d = x.quadratic(restricted(sheets_.d, y));
  if (x.sign(d) < 0) return false;
  for (const Constraint& k : sheets_.constraints) {
    Surd r = x.linear(restricted(k.r, y));
    if (sheet_ == Sheet::front) r = {-r.u, -r.v};
    if (k.surface.sense * x.sign(x.quadratic(restricted(k.p, y)), r, d) > 0) return false;
  }
  return true;
}

bool SheetPresence::shows_on_flat(const LinePoint& x, const mpz_class& y) const {
  for (const Constraint& k : sheets_.constraints) {
    if (k.surface.sense * x.sign(x.quadratic(restricted(k.p, y))) > 0) return false;
  }
  return true;
}

// a' c^2 - b' b c + c' b^2, each term multiplied by r^4.
bool SheetPresence::shows_on_rational(const LinePoint& x, const mpz_class& y) const {
  const Surd b = x.linear(restricted(sheets_.surface.b, y));
  if (x.sign(b) == 0) return false;
  const Surd c = x.quadratic(restricted(sheets_.surface.c, y));
  const Surd bb = x.times(b, b);
  const Surd cc = x.times(c, c);
  for (const Constraint& k : sheets_.constraints) {
    const Surd mixed = x.times(x.times(x.linear(restricted(k.surface.b, y)), b), c);
    const Surd last = x.times(x.quadratic(restricted(k.surface.c, y)), bb);
    const mpz_class& a = k.surface.a;
    const Surd value{a * cc.u - mixed.u + last.u, a * cc.v - mixed.v + last.v};
    if (k.surface.sense * x.sign(value) > 0) return false;
  }
  return true;
}

}  // namespace halfspace
