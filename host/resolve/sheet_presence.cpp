#include "host/resolve/sheet_presence.hpp"

#include <algorithm>

#include "host/resolve/sheet_form.hpp"

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
  return shows_exactly(x.exact(), static_cast<long>(y));
}

bool SheetPresence::may_show(const IntervalPoint& point) const {
  if (!is_small(point.x) || !is_small(point.y)) return true;
  return enclosed_.shows_over({point.x.low, point.y.low, point.x.high, point.y.high}) != Verdict::nowhere;
}

bool SheetPresence::shows_exactly(const LineRoot& x, const mpz_class& y) const {
  if (sheets_.shape == SheetShape::two_sheets && sign_at(restricted(sheets_.d, y), x) < 0) return false;
  if (sheets_.shape == SheetShape::rational && sign_at(restricted(sheets_.surface.b, y), x) == 0) return false;
  return std::none_of(sheets_.constraints.begin(), sheets_.constraints.end(), [&](const Constraint& k) {
    return k.surface.sense * ValueOnLine(sheets_, k, y).sign(sheet_, x) > 0;
  });
}

}  // namespace halfspace
