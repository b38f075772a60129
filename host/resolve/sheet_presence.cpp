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

int PresenceOnLine::hider_at(const RowPoint& x) const {
  if (!is_small(x.near())) return exact_hider(x.exact(), nullptr);
  switch (enclosed_.shows_over(x.near())) {
    case Verdict::nowhere:
      return enclosed_.last_hider();
    case Verdict::everywhere:
      return nothing_hides;
    default:
      return exact_hider(x.exact(), &x.near());
  }
}

// `near`: a place whose enclosures settle most of it.
int PresenceOnLine::exact_hider(const LineRoot& x, const Interval* near) const {
  const Sheets& sheets = presence_.sheets_;
  if (near == nullptr || !enclosed_.surely_exists(*near)) {
    if (sheets.shape == SheetShape::two_sheets && sign_at(restricted(sheets.d, y_), x) < 0) return sheet_hides;
    if (sheets.shape == SheetShape::rational && sign_at(restricted(sheets.surface.b, y_), x) == 0) return sheet_hides;
  }
  for (std::size_t i = 0; i < sheets.constraints.size(); ++i) {
    if (near != nullptr && enclosed_.surely_holds(i, *near)) continue;
    const Constraint& k = sheets.constraints[i];
    if (k.surface.sense * ValueOnLine(sheets, k, y_).sign(presence_.sheet_, x) > 0) return static_cast<int>(i);
  }
  return nothing_hides;
}

}  // namespace halfspace
