// board.hpp - instructions that faces take on an emulated Cortex-M3 (boards/mps2-an385), by every shader and by the baselines.
// Counted  `face`: what a curved face computes once and all of its spans, their filling included. `draw`: all of halfspace::draw,
//          net of the page without bodies. A shaded dot's share of each.
// Checked  The board's page has the bytes of the host's, drawn by the same shader (a baseline: exactly); else the row is left out.
#pragma once

#include <string>
#include <vector>

#include "host/report/plan.hpp"
#include "host/report/row.hpp"

namespace halfspace {

struct BoardRow {
  std::string face, view, shader;
  std::int32_t radius = 0, levels = 0;
  double aim = 0;  // instructions a dot at radius 500 and 65 levels
  std::uint64_t dots = 0;
  double face_instructions = 0, draw_instructions = 0;  // a dot
  PictureError error;
};

struct BoardFindings {
  std::vector<BoardRow> rows;
  std::vector<std::string> gaps;
};

[[nodiscard]] BoardFindings measure_board(const Plan& plan);

}  // namespace halfspace
