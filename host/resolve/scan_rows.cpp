#include "host/resolve/scan_rows.hpp"

#include <algorithm>

#include "host/resolve/sheet_form.hpp"

namespace halfspace {
namespace {

// The sign of the coefficient of x on line y.
int sign_of_slope(const Curve& curve, std::int64_t y) {
  if (sgn(curve.q[1]) == 0) return sgn(curve.q[3]);
  return sgn(mpz_class(curve.q[1] * static_cast<long>(y) + curve.q[3]));
}

// The names of a curve's root number `root` of `count` on line y.
std::vector<CurveBranch> branches_at(const TracedCurve& traced, std::uint32_t index, std::int64_t y, std::size_t root,
                                     std::size_t count) {
  if (sgn(traced.curve.q[0]) == 0) return {{index, Branch::single, sign_of_slope(traced.curve, y) < 0}};
  if (count == 1) return {{index, Branch::left, false}, {index, Branch::right, false}};
  return {{index, root == 0 ? Branch::left : Branch::right, false}};
}

// The roots of one quartic, ascending, each under its names on the sheets where it is a root of a constraint.
std::vector<RowRoot> roots_of_quartic(const Sheets& sheets, const TracedQuartic& traced, std::uint32_t index,
                                      std::int64_t y, QuarticTable& table) {
  std::vector<RowRoot> named;
  for (const LineRoot& x : table.roots(traced.curve, y)) named.push_back({RowPoint(LineRoot(x)), {}, {}});
  if (named.empty()) return named;
  for (const std::uint32_t constraint : traced.constraints) {
    const ValueOnLine value(sheets, sheets.constraints[constraint], static_cast<long>(y));
    for (const Sheet sheet : sheets_in(sheets)) {
      std::uint32_t rank = 0;
      for (RowRoot& root : named) {
        if (value.vanishes(sheet, root.x.exact())) root.quartics.push_back({index, constraint, sheet, rank++});
      }
    }
  }
  return named;
}

void insert_root(RowRoot&& root, std::vector<RowRoot>& roots) {
  auto at = roots.begin();
  int order = -1;
  while (at != roots.end() && (order = compare(root.x, at->x)) > 0) ++at;
  if (at != roots.end() && order == 0) {
    at->curves.insert(at->curves.end(), root.curves.begin(), root.curves.end());
    at->quartics.insert(at->quartics.end(), root.quartics.begin(), root.quartics.end());
  } else {
    roots.insert(at, std::move(root));
  }
}

}  // namespace

std::vector<ScanRow> scan_rows(const std::vector<Mark>& marks, std::int64_t y0, std::int64_t y1) {
  std::vector<ScanRow> rows;
  std::int64_t next = y0;
  const auto slab_up_to = [&](std::int64_t last) {
    if (next <= last) rows.push_back({next, last, false});
    next = last + 1;
  };
  for (const Mark mark : marks) {
    if (mark % 2 != 0) {
      slab_up_to((mark - 1) / 2);
    } else {
      slab_up_to(mark / 2 - 1);
      rows.push_back({mark / 2, mark / 2, true});
      next = mark / 2 + 1;
    }
  }
  slab_up_to(y1);
  return rows;
}

std::vector<RowRoot> roots_on_line(const Sheets& sheets, const BoundingCurves& bounds, std::int64_t y,
                                   QuarticTable& table) {
  std::vector<RowRoot> roots;
  roots.reserve(2 * bounds.curves.size() + 4 * bounds.quartics.size());
  std::vector<RowPoint> points;
  points.reserve(2);
  for (std::uint32_t i = 0; i < bounds.curves.size(); ++i) {
    const TracedCurve& traced = bounds.curves[i];
    points.clear();
    append_roots_on_row(traced.curve, traced.enclosed, y, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      insert_root({std::move(points[k]), branches_at(traced, i, y, k, points.size()), {}}, roots);
    }
  }
  for (std::uint32_t i = 0; i < bounds.quartics.size(); ++i) {
    for (RowRoot& root : roots_of_quartic(sheets, bounds.quartics[i], i, y, table)) insert_root(std::move(root), roots);
  }
  return roots;
}

}  // namespace halfspace
