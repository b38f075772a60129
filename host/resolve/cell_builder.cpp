#include "host/resolve/cell_builder.hpp"

#include <algorithm>

namespace halfspace {
namespace {

bool contains(const std::vector<ArcName>& names, const ArcName& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool fits(const NamedInterval& interval, const ArcName& left, const ArcName& right) {
  return contains(interval.left, left) && contains(interval.right, right);
}

// The cell that ends just above line y and whose arcs bound the interval.
std::vector<NamedCell>::iterator cell_above(std::vector<NamedCell>& cells, const NamedInterval& interval,
                                            std::int64_t y) {
  return std::find_if(cells.begin(), cells.end(),
                      [&](const NamedCell& cell) { return cell.y1 == y - 1 && fits(interval, cell.left, cell.right); });
}

}  // namespace

void CellBuilder::add(const ScanRow& row, std::vector<NamedInterval> intervals) {
  if (row.singular) {
    add_line(row.y0, std::move(intervals));
  } else {
    add_slab(row, intervals);
  }
}

void CellBuilder::finish() { flush_line(); }

void CellBuilder::add_slab(const ScanRow& row, const std::vector<NamedInterval>& intervals) {
  for (const NamedInterval& interval : intervals) {
    const auto above = cell_above(cells_, interval, row.y0);
    if (above != cells_.end()) {
      above->y1 = row.y1;
    } else if (!open_from_line_above(interval, row)) {
      cells_.push_back({interval.left.front(), interval.right.front(), row.y0, row.y1});
    }
  }
  flush_line();
}

void CellBuilder::add_line(std::int64_t y, std::vector<NamedInterval> intervals) {
  flush_line();
  line_y_ = y;
  for (NamedInterval& interval : intervals) {
    const auto above = cell_above(cells_, interval, y);
    if (above != cells_.end()) {
      above->y1 = y;
    } else {
      line_.push_back(std::move(interval));
    }
  }
}

bool CellBuilder::open_from_line_above(const NamedInterval& interval, const ScanRow& row) {
  const ArcName& left = interval.left.front();
  const ArcName& right = interval.right.front();
  const auto start =
      std::find_if(line_.begin(), line_.end(), [&](const NamedInterval& above) { return fits(above, left, right); });
  if (start == line_.end()) return false;
  line_.erase(start);
  cells_.push_back({left, right, line_y_, row.y1});
  return true;
}

void CellBuilder::flush_line() {
  for (const NamedInterval& interval : line_) {
    if (interval.x0 <= interval.x1) spans_.push_back({line_y_, interval.x0, interval.x1});
  }
  line_.clear();
}

}  // namespace halfspace
