#include "host/resolve/face_cells.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "host/resolve/critical_marks.hpp"
#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/row_intervals.hpp"

namespace halfspace {
namespace {

// The curves of a half-space's sheets and their names in the body.
struct FaceCurves {
  const BoundingCurves& bounds;
  std::vector<std::uint32_t>& names;                       // of the curves
  std::map<std::array<std::uint32_t, 3>, ArcName> guided;  // of the quartics, by quartic, constraint and sheet
  std::uint32_t pole = no_arc;
};

std::array<std::uint32_t, 3> key_of(std::uint32_t quartic, std::uint32_t constraint, Sheet sheet) {
  return {quartic, constraint, static_cast<std::uint32_t>(sheet)};
}

void name_quartic(const Sheets& sheets, std::uint32_t quartic, FaceCurves& face, ArcTable& arcs) {
  const TracedQuartic& traced = face.bounds.quartics[quartic];
  for (std::size_t i = 0; i < traced.constraints.size(); ++i) {
    const std::uint32_t constraint = traced.constraints[i];
    for (const Sheet sheet : sheets_in(sheets)) {
      const std::uint32_t guide = arcs.add_guide({&sheets, constraint, sheet, traced.curve, traced.others[i]});
      face.guided.emplace(key_of(quartic, constraint, sheet), ArcName{guide, Branch::single, false, 0, true, 0});
    }
  }
}

FaceCurves face_curves(const Sheets& sheets, const BoundingCurves& bounds, ArcTable& arcs,
                       std::vector<std::uint32_t>& names) {
  FaceCurves face{bounds, names, {}};
  names.clear();
  if (sheets.shape == SheetShape::rational && !is_constant(sheets.surface.b)) face.pole = 0;
  for (const TracedCurve& traced : face.bounds.curves) face.names.push_back(arcs.curve_index(traced.curve));
  for (std::uint32_t i = 0; i < face.bounds.quartics.size(); ++i) name_quartic(sheets, i, face, arcs);
  return face;
}

// A sheet that may have a face.
struct Open {
  Sheet sheet = Sheet::only;
  bool is_exit = false;
};

// A pole bounds a cell from outside. On dots its line's value v is an integer, so v > 0 is v - 1 >= 0: the arc v - 1 = 0 is closed.
ArcName beside_pole(ArcName pole, bool left_side) {
  pole.shift = left_side ? -1 : 1;
  return pole;
}

ShortList<ArcName> names_at(const FaceCurves& face, Sheet sheet, const RowRoot& root, bool open, bool left_side) {
  ShortList<ArcName> names;
  for (const CurveBranch& through : root.curves) {
    const ArcName name{face.names[through.curve], through.branch, through.negated, 0, false, 0};
    if (!open) names.push_back(name);
    if (open && through.curve == face.pole) names.push_back(beside_pole(name, left_side));
  }
  for (const QuarticBranch& through : root.quartics) {
    if (open || through.sheet != sheet) continue;
    ArcName name = face.guided.at(key_of(through.quartic, through.constraint, sheet));
    name.rank = through.rank;
    names.push_back(name);
  }
  return names;
}

std::int64_t clamped(const mpz_class& x, const DotExtent& extent) {
  if (x < static_cast<long>(extent.x0)) return extent.x0;
  return x > static_cast<long>(extent.x1) ? extent.x1 : x.get_si();
}

// The dots of an interval within the extent; x0 > x1 when there is none.
void set_dots(const RowInterval& interval, const std::vector<RowRoot>& roots, const DotExtent& extent,
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

NamedInterval named(const RowInterval& interval, const FaceCurves& face, Sheet sheet, const std::vector<RowRoot>& roots,
                    bool in_dots, const DotExtent& extent) {
  const auto names = [&](int root, bool open, bool left_side) {
    if (root == unbounded) return ShortList{ArcName{}};
    return names_at(face, sheet, roots[static_cast<std::size_t>(root)], open, left_side);
  };
  NamedInterval named{names(interval.left, interval.left_open, true),
                      names(interval.right, interval.right_open, false)};
  if (in_dots) set_dots(interval, roots, extent, named);
  return named;
}

}  // namespace

BoundingCurves FaceFinder::append_faces(const Sheets& sheets, const DotExtent& extent, const HiddenExits& exits,
                                        QuarticTable& table, ArcTable& arcs, std::vector<FaceCells>& faces) {
  presences_.clear();
  std::array<Open, 2> open;
  std::size_t count = 0;
  for (const Sheet sheet : sheets_in(sheets)) {
    const bool is_exit = sheet == Sheet::back ? exits.back : exits.front;
    if (is_exit && !has_rivals(sheets)) continue;
    presences_.emplace_back(sheets, sheet);
    builders_[count].clear();
    open[count++] = {sheet, is_exit};
  }
  if (count == 0) return {};
  BoundingCurves bounds = bounding_curves(sheets, table);
  const FaceCurves face = face_curves(sheets, bounds, arcs, names_);
  find_critical_marks(bounds, presences_, extent.y0, extent.y1, marks_);
  find_scan_rows(marks_, extent.y0, extent.y1, rows_);
  roots_.set_face(sheets, bounds);
  for (const ScanRow& row : rows_) {
    const std::vector<RowRoot>& roots = roots_.on_line(row.y0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto [sheet, is_exit] = open[i];
      auto intervals = row_intervals(roots, bounds, PresenceOnLine(presences_[i], row.y0), face.pole);
      if (is_exit) intervals = rival_points(sheets, bounds, sheet, roots, row.y0, intervals);
      builders_[i].begin_row(row);
      for (const RowInterval& interval : intervals) {
        builders_[i].add(named(interval, face, sheet, roots, row.singular, extent));
      }
      builders_[i].end_row();
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    builders_[i].finish();
    faces.push_back({sheets.half_space, open[i].sheet, builders_[i].cells(), builders_[i].spans()});
  }
  return bounds;
}

}  // namespace halfspace
