#include "host/resolve/face_cells.hpp"

#include <algorithm>

#include "host/resolve/critical_marks.hpp"
#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/row_intervals.hpp"

namespace halfspace {
namespace {

// The curves of a half-space's sheets and their names in the body.
struct FaceCurves {
  std::vector<TracedCurve> curves;
  std::vector<std::uint32_t> names;
  std::uint32_t pole = no_arc;
  std::optional<DotRange> range;
};

Curve vertical_line(std::int64_t x) { return {{0, 0, 0, 1, 0, static_cast<long>(-x)}}; }

FaceCurves face_curves(const Sheets& sheets, const Extent& extent, ArcTable& arcs) {
  FaceCurves face;
  face.curves = bounding_curves(sheets);
  if (sheets.shape == SheetShape::rational && !is_constant(sheets.surface.b)) face.pole = 0;
  // Within the extent alone is an untraced constraint known to keep its sign, so cells must not reach across its sides.
  if (has_untraced_constraint(sheets)) {
    face.range = DotRange{RowPoint(static_cast<double>(extent.x0)), RowPoint(static_cast<double>(extent.x1))};
    trace(vertical_line(extent.x0), std::nullopt, false, face.curves);
    trace(vertical_line(extent.x1), std::nullopt, false, face.curves);
  }
  for (const TracedCurve& traced : face.curves) face.names.push_back(arcs.curve_index(traced.curve));
  return face;
}

// A pole bounds a cell from outside. On dots its line's value v is an integer, so v > 0 is v - 1 >= 0: the arc v - 1 = 0 is closed.
ArcName beside_pole(ArcName pole, bool left_side) {
  pole.shift = left_side ? -1 : 1;
  return pole;
}

std::vector<ArcName> names_at(const FaceCurves& face, const RowRoot& root, bool open, bool left_side) {
  std::vector<ArcName> names;
  for (const CurveBranch& through : root.curves) {
    const ArcName name{face.names[through.curve], through.branch, through.negated, 0};
    if (!open) names.push_back(name);
    if (open && through.curve == face.pole) names.push_back(beside_pole(name, left_side));
  }
  return names;
}

std::int64_t clamped(const mpz_class& x, const Extent& extent) {
  if (x < static_cast<long>(extent.x0)) return extent.x0;
  return x > static_cast<long>(extent.x1) ? extent.x1 : x.get_si();
}

// The dots of an interval within the extent; x0 > x1 when there is none.
void set_dots(const RowInterval& interval, const std::vector<RowRoot>& roots, const Extent& extent,
              NamedInterval& named) {
  named.x0 = extent.x0;
  named.x1 = extent.x1;
  if (interval.left != unbounded) {
    const LineRoot& x = roots[static_cast<std::size_t>(interval.left)].x.exact();
    const mpz_class first = interval.left_open ? mpz_class(floor_of(x) + 1) : ceiling_of(x);
    if (first > static_cast<long>(extent.x1)) named.x1 = extent.x0 - 1;
    named.x0 = clamped(first, extent);
  }
  if (interval.right != unbounded) {
    const LineRoot& x = roots[static_cast<std::size_t>(interval.right)].x.exact();
    const mpz_class last = interval.right_open ? mpz_class(ceiling_of(x) - 1) : floor_of(x);
    if (last < static_cast<long>(extent.x0)) {
      named.x1 = extent.x0 - 1;
    } else {
      named.x1 = std::min(named.x1, clamped(last, extent));
    }
  }
}

std::vector<NamedInterval> named_intervals(const FaceCurves& face, const std::vector<RowRoot>& roots,
                                           const std::vector<RowInterval>& intervals, bool in_dots,
                                           const Extent& extent) {
  std::vector<NamedInterval> named;
  for (const RowInterval& interval : intervals) {
    NamedInterval next;
    const auto names = [&](int root, bool open, bool left_side) {
      if (root == unbounded) return std::vector<ArcName>{ArcName{}};
      return names_at(face, roots[static_cast<std::size_t>(root)], open, left_side);
    };
    next.left = names(interval.left, interval.left_open, true);
    next.right = names(interval.right, interval.right_open, false);
    if (in_dots) set_dots(interval, roots, extent, next);
    named.push_back(std::move(next));
  }
  return named;
}

}  // namespace

std::vector<FaceCells> face_cells(const Sheets& sheets, const Extent& extent, const HiddenExits& exits,
                                  ArcTable& arcs) {
  if (sheets.shape == SheetShape::none) return {};
  const bool two = sheets.shape == SheetShape::two_sheets;
  const FaceCurves face = face_curves(sheets, extent, arcs);
  std::vector<FaceCells> faces;
  std::vector<SheetPresence> presences;
  std::vector<bool> hidden;
  for (const Sheet sheet : two ? std::vector{Sheet::front, Sheet::back} : std::vector{Sheet::only}) {
    faces.push_back({sheet, {}, {}});
    presences.emplace_back(sheets, sheet);
    hidden.push_back(sheet == Sheet::back ? exits.back : exits.front);
  }
  std::vector<CellBuilder> builders(faces.size());
  const std::vector<Mark> marks = critical_marks(face.curves, presences, extent.y0, extent.y1);
  for (const ScanRow& row : scan_rows(marks, extent.y0, extent.y1)) {
    const std::vector<RowRoot> roots = roots_on_line(face.curves, row.y0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      auto intervals = row_intervals(roots, row.y0, presences[i], face.pole, face.range);
      if (hidden[i]) intervals = rival_points(face.curves, roots, row.y0, intervals);
      builders[i].add(row, named_intervals(face, roots, intervals, row.singular, extent));
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    builders[i].finish();
    faces[i].cells = builders[i].cells();
    faces[i].spans = builders[i].spans();
  }
  return faces;
}

}  // namespace halfspace
