// face_cells.hpp - the cells of the one or two faces of a half-space: rows, intervals, cells, in that order.
#pragma once

#include <vector>

#include "host/resolve/arc_table.hpp"
#include "host/resolve/cell_builder.hpp"
#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

struct FaceCells {
  Sheet sheet = Sheet::only;
  std::vector<NamedCell> cells;
  std::vector<DotSpan> spans;
};

// Front before back. Of sheets that rays only leave by, what can win a tie (exit_sheets.hpp).
[[nodiscard]] std::vector<FaceCells> face_cells(const Sheets& sheets, const Extent& extent, const HiddenExits& exits,
                                                QuarticTable& table, ArcTable& arcs);

}  // namespace halfspace
