// row_intervals.hpp - where a sheet shows on one scan line: maximal intervals between roots of the bounding curves.
//
//       o------|==========|----|=====o      Open cells between roots: one sample decides, since no sign changes inside.
//     cell 0  root 0    root 1 ...          A root joins a cell that shows beside it; one between cells that do not show is
//                                           decided at the root itself, exactly, and may be an interval of one point.
// A constraint that fails in a cell fails up to the next root on one of its curves, so that nothing in between is asked.
#pragma once

#include <vector>

#include "host/resolve/scan_rows.hpp"
#include "host/resolve/sheet_presence.hpp"

namespace halfspace {

inline constexpr int unbounded = -1;

struct RowInterval {
  int left = unbounded, right = unbounded;     // indices of roots
  bool left_open = false, right_open = false;  // the root itself does not show: only a rational sheet's poles
};

using RowIntervals = ShortList<RowInterval>;

// `bounds`: the curves of the roots. `pole`: the index of the curve on which a rational sheet does not exist, or no_arc.
[[nodiscard]] RowIntervals row_intervals(const std::vector<RowRoot>& roots, const BoundingCurves& bounds,
                                         const PresenceOnLine& presence, std::uint32_t pole);

}  // namespace halfspace
