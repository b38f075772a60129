// face_cells.hpp - the cells of the one or two faces of a half-space: rows, intervals, cells, in that order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/resolve/arc_table.hpp"
#include "host/resolve/cell_builder.hpp"
#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/sheet.hpp"
#include "host/resolve/sheet_presence.hpp"

namespace halfspace {

struct FaceCells {
  std::uint32_t half_space = 0;
  Sheet sheet = Sheet::only;
  std::vector<NamedCell> cells;
  std::vector<DotSpan> spans;
};

// Finds the faces of one half-space after another, in memory that serves all of them.
class FaceFinder {
 public:
  // Front before back. Of sheets that rays only leave by, what can win a tie (exit_sheets.hpp). `arcs` keeps pointers to the curves that are
  // returned.
  [[nodiscard]] BoundingCurves append_faces(const Sheets& sheets, const DotExtent& extent, const HiddenExits& exits,
                                            QuarticTable& table, ArcTable& arcs, std::vector<FaceCells>& faces);

 private:
  std::vector<SheetPresence> presences_;  // of the sheets that may have a face
  std::array<CellBuilder, 2> builders_;   // and theirs
  std::vector<std::uint32_t> names_;
  std::vector<Mark> marks_;
  std::vector<ScanRow> rows_;
  RowRoots roots_;
};

}  // namespace halfspace
