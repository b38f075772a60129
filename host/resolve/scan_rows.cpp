#include "host/resolve/scan_rows.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// The sign of the coefficient of x on line y.
int sign_of_slope(const Curve& curve, std::int64_t y) {
  if (sgn(curve.q[1]) == 0) return sgn(curve.q[3]);
  return sgn(mpz_class(curve.q[1] * static_cast<long>(y) + curve.q[3]));
}

// The names of a curve's root number `root` of `count` on line y.
ShortList<CurveBranch> branches_at(const TracedCurve& traced, std::uint32_t index, std::int64_t y, std::size_t root,
                                   std::size_t count) {
  if (sgn(traced.curve.q[0]) == 0) return {{index, Branch::single, sign_of_slope(traced.curve, y) < 0}};
  if (count == 1) return {{index, Branch::left, false}, {index, Branch::right, false}};
  return {{index, root == 0 ? Branch::left : Branch::right, false}};
}

}  // namespace

void find_scan_rows(const std::vector<Mark>& marks, std::int64_t y0, std::int64_t y1, std::vector<ScanRow>& rows) {
  rows.clear();
  rows.reserve(2 * marks.size() + 1);
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
}

void RowRoots::set_face(const Sheets& sheets, const BoundingCurves& bounds) {
  sheets_ = &sheets;
  bounds_ = &bounds;
  forms_.clear();
  roots_.reserve(2 * bounds.curves.size() + 4 * bounds.quartics.size());
  for (const TracedQuartic& traced : bounds.quartics) {
    std::vector<EnclosedForm>& forms = forms_.emplace_back();
    for (const std::uint32_t constraint : traced.constraints)
      forms.emplace_back(sheets, sheets.constraints[constraint]);
  }
}

const std::vector<RowRoot>& RowRoots::on_line(std::int64_t y) {
  roots_.clear();
  for (std::uint32_t i = 0; i < bounds_->curves.size(); ++i) add_curve(i, y);
  for (std::uint32_t i = 0; i < bounds_->quartics.size(); ++i) add_quartic(i, y);
  return roots_;
}

// Each root under the names of its branches.
void RowRoots::add_curve(std::uint32_t index, std::int64_t y) {
  const TracedCurve& traced = bounds_->curves[index];
  points_.clear();
  append_roots_on_row(traced.curve, traced.enclosed, y, points_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    insert({std::move(points_[i]), branches_at(traced, index, y, i, points_.size()), {}});
  }
}

// Each root under its names on the sheets where it is a root of a constraint.
void RowRoots::add_quartic(std::uint32_t index, std::int64_t y) {
  const TracedQuartic& traced = bounds_->quartics[index];
  std::vector<RowRoot> named;
  for (const LineRoot& x : traced.curve->roots(y)) named.push_back({RowPoint(LineRoot(x)), {}, {}});
  if (named.empty()) return;
  for (std::size_t i = 0; i < traced.constraints.size(); ++i) {
    const std::uint32_t constraint = traced.constraints[i];
    const ValueOnLine value(*sheets_, sheets_->constraints[constraint], y, &forms_[index][i]);
    for (const Sheet sheet : sheets_in(*sheets_)) {
      std::uint32_t rank = 0;
      for (RowRoot& root : named) {
        if (value.vanishes(sheet, root.x.exact())) root.quartics.push_back({index, constraint, sheet, rank++});
      }
    }
  }
  for (RowRoot& root : named) insert(std::move(root));
}

void RowRoots::insert(RowRoot&& root) {
  auto at = roots_.begin();
  int order = -1;
  while (at != roots_.end() && (order = compare(root.x, at->x)) > 0) ++at;
  if (at != roots_.end() && order == 0) {
    for (const CurveBranch& branch : root.curves) at->curves.push_back(branch);
    at->quartics.insert(at->quartics.end(), root.quartics.begin(), root.quartics.end());
  } else {
    roots_.insert(at, std::move(root));
  }
}

}  // namespace halfspace
