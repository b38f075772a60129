// critical_marks.hpp - the scan lines on or between which a face's boundary changes its structure.
// That is where two of its curves meet, or one turns, or holds a whole line, or goes to infinity: at points of the face alone,
// for what happens off the face leaves its outline as it is (docs/resolve.md).
// Exact  Intervals find the points, drop those at which the face cannot show, and place the rest between two lines; only what
//        lies too close to a line of dots for them is left to root_marks.hpp. A mark too many costs time, never a dot.
#pragma once

#include <vector>

#include "host/resolve/root_marks.hpp"
#include "host/resolve/sheet_presence.hpp"

namespace halfspace {

// `sheets`: those whose outlines the curves are; none: every point counts, on a face or not. What befalls a quartic counts
// everywhere, since its roots are known by their number on a sheet (scan_rows.hpp). Sorted, none twice, for lines y0 .. y1, the table's.
void find_critical_marks(const BoundingCurves& bounds, const std::vector<SheetPresence>& sheets, std::int64_t y0,
                         std::int64_t y1, std::vector<Mark>& marks);

}  // namespace halfspace
