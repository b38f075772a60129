// report.hpp - `halfspace report`: speed against error, of every shader and of other programs, as tables and plots in a folder.
//   results.csv, cortex-m3.csv  every row
//   README.md                   the figures that matter, beside what was aimed at
//   *.svg                       plots, by gnuplot
// Needs   The sources it was built from: scenes, hard cases, the twin writer for POV-Ray, the board.
// Gaps    A program that is missing leaves its rows out; the report and standard error say so.
#pragma once

#include <string>

#include "host/report/plan.hpp"

namespace halfspace {

// Throws std::runtime_error with the file, what is wrong and what to do.
void write_report(const Plan& plan, const std::string& folder);

}  // namespace halfspace
