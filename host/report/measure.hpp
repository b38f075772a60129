// measure.hpp - rows of our own: a subject drawn by every listed shader, timed, and compared with the exact oracle.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/report/row.hpp"

namespace halfspace {

struct MeasureOptions {
  int runs = 5;            // the median counts
  bool from_text = false;  // time reading, flattening, resolving and the job too
};

// The exact level of every dot of some lines.
struct Truth {
  std::vector<std::int32_t> lines;
  std::vector<std::int16_t> levels;
};
// Of a page with more than `most_dots` only lines at equal distances. `trust_boxes`: bodies are skipped outside their boxes, which
// tests vouch for in the scenes of the gallery, but not in hard cases.
[[nodiscard]] Truth true_levels(const IntegerScene& scene, std::uint64_t most_dots, bool trust_boxes);

// The same lines of a whole picture.
[[nodiscard]] std::vector<std::int16_t> pick_lines(const std::vector<std::int16_t>& levels, const Truth& truth,
                                                   std::int32_t width);

// One row a shader, without instructions.
[[nodiscard]] Rows measure(const Subject& subject, const Truth& truth, const MeasureOptions& options);

// Adds instructions: `rows` are those of the subjects, one after the other. Returns why there are none.
std::string add_instructions(std::span<const Subject> subjects, std::span<Row> rows);

}  // namespace halfspace
