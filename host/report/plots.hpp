// plots.hpp - a report's rows as SVG, by gnuplot.
//   error.svg       speed against wrong dots and against the levels' error, knot and gear, other programs beside
//   instructions.svg  the same with instructions a dot
//   resolution.svg  instructions against resolution, both axes logarithmic
#pragma once

#include <string>

#include "host/report/row.hpp"

namespace halfspace {

// Returns why there are none; empty: all is well.
[[nodiscard]] std::string write_plots(const Rows& rows, const std::string& folder);

}  // namespace halfspace
