#include "host/resolve/sheet_presence.hpp"

#include <algorithm>

#include "host/resolve/sheet_form.hpp"

namespace halfspace {
namespace {

// Keeps every product in the enclosures below 2^300: of degree four, and coefficients at most 1.
bool is_small(const Interval& x) { return -0x1p70 < x.low && x.high < 0x1p70; }

}  // namespace

bool SheetPresence::shows_at(const RowPoint& x, std::int64_t y) const {
  if (!is_small(x.near())) return shows_exactly(x.exact(), y, nullptr);
  const auto line = static_cast<double>(y);
  const Box box{x.near().low, line, x.near().high, line};
  const Verdict verdict = enclosed_.shows_over(box);
  return verdict == Verdict::unsure ? shows_exactly(x.exact(), y, &box) : verdict == Verdict::everywhere;
}

bool SheetPresence::may_show(const IntervalPoint& point) const {
  if (!is_small(point.x) || !is_small(point.y)) return true;
  return enclosed_.shows_over({point.x.low, point.y.low, point.x.high, point.y.high}) != Verdict::nowhere;
}

// `box`: a place whose enclosures settle most of it.
bool SheetPresence::shows_exactly(const LineRoot& x, std::int64_t line, const Box* box) const {
  const mpz_class y = static_cast<long>(line);
  if (box == nullptr || !enclosed_.surely_exists(*box)) {
    if (sheets_.shape == SheetShape::two_sheets && sign_at(restricted(sheets_.d, y), x) < 0) return false;
    if (sheets_.shape == SheetShape::rational && sign_at(restricted(sheets_.surface.b, y), x) == 0) return false;
  }
  for (std::size_t i = 0; i < sheets_.constraints.size(); ++i) {
    if (box != nullptr && enclosed_.surely_holds(i, *box)) continue;
    const Constraint& k = sheets_.constraints[i];
    if (k.surface.sense * ValueOnLine(sheets_, k, y).sign(sheet_, x) > 0) return false;
  }
  return true;
}

}  // namespace halfspace
