// cell_builder.hpp - joins the intervals of successive rows into cells, arcs named but not yet stored.
// A slab's interval continues the cell above it when both sides have the same names. On a singular line an interval continues
// the cell above when each side's root carries that cell's name; else it opens the cell below that fits it so; else it is a
// span of its own, in dots.
#pragma once

#include <vector>

#include "host/resolve/arc_table.hpp"
#include "host/resolve/scan_rows.hpp"

namespace halfspace {

struct NamedCell {
  ArcName left, right;
  std::int64_t y0 = 0, y1 = -1;  // local lines
};

struct DotSpan {
  std::int64_t y = 0, x0 = 0, x1 = -1;  // local
};

// One interval of a row: all names of each side's root, and its dots.
struct NamedInterval {
  std::vector<ArcName> left, right;  // in a slab exactly one each
  std::int64_t x0 = 0, x1 = -1;      // singular lines only
};

class CellBuilder {
 public:
  // Rows from top to bottom, without gaps.
  void add(const ScanRow& row, std::vector<NamedInterval> intervals);
  void finish();

  [[nodiscard]] const std::vector<NamedCell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<DotSpan>& spans() const { return spans_; }

 private:
  void add_slab(const ScanRow& row, const std::vector<NamedInterval>& intervals);
  void add_line(std::int64_t y, std::vector<NamedInterval> intervals);
  bool open_from_line_above(const NamedInterval& interval, const ScanRow& row);
  void flush_line();

  std::vector<NamedCell> cells_;
  std::vector<DotSpan> spans_;
  std::vector<NamedInterval> line_;  // of the singular line just above, not yet in a cell
  std::int64_t line_y_ = 0;
};

}  // namespace halfspace
