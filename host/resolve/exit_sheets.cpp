#include "host/resolve/exit_sheets.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// The sign that decides the value at both ends of a ray: of z^2, or of z for a plane.
int leading_sign(const IntegerHalfSpace& h) { return sgn(h.c[2]) * (h.complement ? -1 : 1); }

// Does the half-space fail at the viewer's end (z towards minus infinity) of every ray?
bool fails_in_front(const IntegerHalfSpace& h) {
  return h.kind == HalfSpaceKind::plane ? leading_sign(h) < 0 : leading_sign(h) > 0;
}

// Is every point of the scan line on the curve?
bool holds_line(const Curve& curve, std::int64_t line) {
  const auto& q = curve.q;
  if (sgn(q[0]) != 0 || (sgn(q[1]) == 0 && sgn(q[3]) != 0)) return false;
  const mpz_class y = static_cast<long>(line);
  return q[1] * y + q[3] == 0 && (q[2] * y + q[4]) * y + q[5] == 0;
}

}  // namespace

bool rays_start_outside(const IntegerBody& body) {
  const auto& all = body.half_spaces;
  return std::none_of(all.begin(), all.end(), [](const IntegerHalfSpace& h) { return h.transparent; }) &&
         std::any_of(all.begin(), all.end(), fails_in_front);
}

HiddenExits hidden_exits(const IntegerBody& body, const Sheets& sheets) {
  const IntegerHalfSpace& h = body.half_spaces[sheets.half_space];
  if (sheets.constraints.size() + 1 != body.half_spaces.size() || has_zero_constraint(sheets)) return {};
  const bool positive = leading_sign(h) > 0;
  if (sheets.shape == SheetShape::flat) return {h.kind == HalfSpaceKind::plane && positive, false};
  if (sheets.shape != SheetShape::two_sheets) return {};
  // A quadric with a positive z^2 holds between its sheets: rays enter at the front and leave at the back.
  return {!positive, positive};
}

bool has_rivals(const Sheets& sheets) {
  return std::any_of(sheets.constraints.begin(), sheets.constraints.end(), [&sheets](const Constraint& k) {
    return k.half_space > sheets.half_space && (sheets.shape != SheetShape::flat || !is_constant(k.p));
  });
}

RowIntervals rival_points(const Sheets& sheets, const BoundingCurves& bounds, Sheet sheet,
                          const std::vector<RowRoot>& roots, std::int64_t y, const RowIntervals& intervals) {
  const auto holds = [y](const TracedCurve& traced) { return traced.later && holds_line(traced.curve, y); };
  if (std::any_of(bounds.curves.begin(), bounds.curves.end(), holds)) return intervals;
  const auto is_rival = [&](const RowRoot& root) {
    return std::any_of(root.curves.begin(), root.curves.end(),
                       [&](const CurveBranch& b) { return bounds.curves[b.curve].later; }) ||
           std::any_of(root.quartics.begin(), root.quartics.end(), [&](const QuarticBranch& b) {
             return b.sheet == sheet && sheets.constraints[b.constraint].half_space > sheets.half_space;
           });
  };
  RowIntervals points;
  for (const RowInterval& interval : intervals) {
    const int first = interval.left == unbounded ? 0 : interval.left;
    const int last = interval.right == unbounded ? static_cast<int>(roots.size()) - 1 : interval.right;
    for (int i = first; i <= last; ++i) {
      if (is_rival(roots[static_cast<std::size_t>(i)])) points.push_back({i, i, false, false});
    }
  }
  return points;
}

}  // namespace halfspace
