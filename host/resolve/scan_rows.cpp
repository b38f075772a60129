#include "host/resolve/scan_rows.hpp"

#include <algorithm>

namespace halfspace {
namespace {

std::vector<Mark> critical_marks(const std::vector<Curve>& curves, std::int64_t y0, std::int64_t y1) {
  std::vector<Mark> marks;
  const auto add = [&](const Polynomial& p) {
    const std::vector<Mark> found = root_marks(p, y0, y1);
    marks.insert(marks.end(), found.begin(), found.end());
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    add(turning_lines(curves[i]));
    for (std::size_t j = 0; j < i; ++j) add(meeting_lines(curves[i], curves[j]));
  }
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

// The roots of one curve, ascending, each under the names of its branches.
std::vector<RowRoot> roots_of_curve(const Curve& curve, std::uint32_t index, std::int64_t y) {
  const LinePolynomial f = restricted(curve, static_cast<long>(y));
  std::vector<RowRoot> named;
  for (LineRoot& x : real_roots(f)) named.push_back({std::move(x), {}});
  if (named.empty()) return named;
  if (sgn(f.c2) == 0) {
    named.front().curves = {{index, Branch::single, sgn(f.c1) < 0}};
  } else if (named.size() == 1) {
    named.front().curves = {{index, Branch::left, false}, {index, Branch::right, false}};
  } else {
    named[0].curves = {{index, Branch::left, false}};
    named[1].curves = {{index, Branch::right, false}};
  }
  return named;
}

void insert_root(RowRoot&& root, std::vector<RowRoot>& roots) {
  auto at = roots.begin();
  int order = -1;
  while (at != roots.end() && (order = compare(root.x, at->x)) > 0) ++at;
  if (at != roots.end() && order == 0) {
    at->curves.insert(at->curves.end(), root.curves.begin(), root.curves.end());
  } else {
    roots.insert(at, std::move(root));
  }
}

}  // namespace

std::vector<ScanRow> scan_rows(const std::vector<Curve>& curves, std::int64_t y0, std::int64_t y1) {
  std::vector<ScanRow> rows;
  std::int64_t next = y0;
  const auto slab_up_to = [&](std::int64_t last) {
    if (next <= last) rows.push_back({next, last, false});
    next = last + 1;
  };
  for (const Mark mark : critical_marks(curves, y0, y1)) {
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

std::vector<RowRoot> roots_on_line(const std::vector<Curve>& curves, std::int64_t y) {
  std::vector<RowRoot> roots;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    for (RowRoot& root : roots_of_curve(curves[i], i, y)) insert_root(std::move(root), roots);
  }
  return roots;
}

}  // namespace halfspace
