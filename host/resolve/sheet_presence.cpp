#include "host/resolve/sheet_presence.hpp"

#include <algorithm>

#include "host/resolve/sheet_form.hpp"

namespace halfspace {
namespace {

// Keeps every product in the enclosures below 2^300: of degree four, and coefficients at most 1.
bool is_small(const Interval& x) { return -0x1p70 < x.low && x.high < 0x1p70; }

}  // namespace

bool SheetPresence::may_show(const IntervalPoint& point) const {
  if (!is_small(point.x) || !is_small(point.y)) return true;
  return enclosed_.shows_over({point.x.low, point.y.low, point.x.high, point.y.high}) != Verdict::nowhere;
}

PresenceOnLine::PresenceOnLine(const SheetPresence& presence, std::int64_t y)
    : presence_(presence), y_(y), enclosed_(presence.enclosed_.on_line(static_cast<double>(y))) {}

bool PresenceOnLine::shows_at(const RowPoint& x) const {
  if (!is_small(x.near())) return shows_exactly(x.exact(), nullptr);
  const Verdict verdict = enclosed_.shows_over(x.near());
  return verdict == Verdict::unsure ? shows_exactly(x.exact(), &x.near()) : verdict == Verdict::everywhere;
}

// `near`: a place whose enclosures settle most of it.
bool PresenceOnLine::shows_exactly(const LineRoot& x, const Interval* near) const {
  const Sheets& sheets = presence_.sheets_;
  const mpz_class y = static_cast<long>(y_);
  if (near == nullptr || !enclosed_.surely_exists(*near)) {
    if (sheets.shape == SheetShape::two_sheets && sign_at(restricted(sheets.d, y), x) < 0) return false;
    if (sheets.shape == SheetShape::rational && sign_at(restricted(sheets.surface.b, y), x) == 0) return false;
  }
  for (std::size_t i = 0; i < sheets.constraints.size(); ++i) {
    if (near != nullptr && enclosed_.surely_holds(i, *near)) continue;
    const Constraint& k = sheets.constraints[i];
    if (k.surface.sense * ValueOnLine(sheets, k, y).sign(presence_.sheet_, x) > 0) return false;
  }
  return true;
}

}  // namespace halfspace
