// exit_sheets.hpp - the sheets on which rays leave a body, and what can still be seen of them.
// A ray that enters an opaque solid before it leaves it meets an entry first. So the dot of an exit shows another face, unless
// entry and exit are one point: then the exit is on the surface of an entry half-space too, and wins the tie only if it comes
// first in the body. What is left of an exit sheet are therefore its points on the curves of later half-spaces.
// Costs nothing in truth: no dot changes (tests/resolve, tests/render); it saves the core most of its depth comparisons.
#pragma once

#include <vector>

#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"
#include "host/resolve/row_intervals.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

// Every half-space is opaque, and one of them keeps the body away from the viewer's end of every ray.
[[nodiscard]] bool rays_start_outside(const IntegerBody& body);

// Which sheets rays only leave by, with no other half-space's surface along them.
struct HiddenExits {
  bool front = false;  // or the only sheet
  bool back = false;
};

// For a body whose rays start outside.
[[nodiscard]] HiddenExits hidden_exits(const IntegerBody& body, const Sheets& sheets);

// May anything of an exit sheet win a tie?
[[nodiscard]] bool has_rivals(const Sheets& sheets);

// What is left of an exit sheet's intervals on scan line y, where it may win a tie: the roots on curves of later half-spaces, as
// intervals of one point; everything where such a curve holds the whole line.
[[nodiscard]] RowIntervals rival_points(const Sheets& sheets, const BoundingCurves& bounds, Sheet sheet,
                                        const std::vector<RowRoot>& roots, std::int64_t y,
                                        const RowIntervals& intervals);

}  // namespace halfspace
