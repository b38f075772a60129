// cell_builder.hpp - joins the intervals of successive rows into cells, arcs named but not yet stored.
// A slab's interval continues the cell above it when both sides have the same names. On a singular line an interval continues
// the cell above when each side's root carries that cell's name; else it opens the cell below that fits it so; else it is a
// span of its own, in dots.
#pragma once

#include <vector>

#include "host/resolve/arc_table.hpp"
#include "host/resolve/scan_rows.hpp"
#include "host/resolve/short_list.hpp"

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
  ShortList<ArcName> left, right;  // in a slab exactly one each
  std::int64_t x0 = 0, x1 = -1;    // singular lines only
};

class CellBuilder {
 public:
  // Forgets what it built, but keeps its memory.
  void clear();
  // Rows from top to bottom, without gaps; the intervals of each between its begin and its end.
  void begin_row(const ScanRow& row);
  void add(NamedInterval&& interval);
  void end_row();
  void finish();

  [[nodiscard]] const std::vector<NamedCell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<DotSpan>& spans() const { return spans_; }

 private:
  bool open_from_line_above(const NamedInterval& interval);
  void flush_line();

  ScanRow row_;
  std::vector<NamedCell> cells_;
  std::vector<DotSpan> spans_;
  std::vector<NamedInterval> line_;  // of the singular line just above, not yet in a cell
  std::int64_t line_y_ = 0;
};

}  // namespace halfspace
