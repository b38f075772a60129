#include "host/resolve/cell_builder.hpp"

#include <algorithm>

namespace halfspace {
namespace {

bool contains(const ShortList<ArcName>& names, const ArcName& name) {
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

void CellBuilder::clear() {
  cells_.clear();
  spans_.clear();
  line_.clear();
}

void CellBuilder::begin_row(const ScanRow& row) {
  row_ = row;
  if (!row.singular) return;
  flush_line();
  line_y_ = row.y0;
}

void CellBuilder::add(NamedInterval&& interval) {
  const auto above = cell_above(cells_, interval, row_.y0);
  if (above != cells_.end()) {
    above->y1 = row_.y1;
  } else if (row_.singular) {
    line_.push_back(std::move(interval));
  } else if (!open_from_line_above(interval)) {
    cells_.push_back({interval.left.front(), interval.right.front(), row_.y0, row_.y1});
  }
}

void CellBuilder::end_row() {
  if (!row_.singular) flush_line();
}

void CellBuilder::finish() { flush_line(); }

bool CellBuilder::open_from_line_above(const NamedInterval& interval) {
  const ArcName& left = interval.left.front();
  const ArcName& right = interval.right.front();
  const auto start =
      std::find_if(line_.begin(), line_.end(), [&](const NamedInterval& above) { return fits(above, left, right); });
  if (start == line_.end()) return false;
  line_.erase(start);
  cells_.push_back({left, right, line_y_, row_.y1});
  return true;
}

void CellBuilder::flush_line() {
  for (const NamedInterval& interval : line_) {
    if (interval.x0 <= interval.x1) spans_.push_back({line_y_, interval.x0, interval.x1});
  }
  line_.clear();
}

}  // namespace halfspace
