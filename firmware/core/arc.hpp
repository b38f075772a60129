// arc.hpp - one arc followed down the page: for each scan line, the first dots at and right of its crossing.
//
//     dots    .  .  .  .  .  .            at_or_right: the first dot x >= root
//     root            |                   right:       the first dot x >  root (differs only on an exact tie)
//
// Exact   Each is the dot where a monotone predicate of the registers' signs turns true; the roots themselves are never
//         computed, so two roots between the same pair of dots need no special case.
//           single  value > 0 right of the root           (the form is of first order in x, rising)
//           left    value < 0 or value' > 0 right of it   (value' = 2 A x + B y + D, A > 0)
//           right   value > 0 and value' > 0 right of it
//         Forms with more roots are sought between separators: guided_arc.hpp.
// Clamp   Crossings are sought in the scissor [x0, x1] only; beyond it they read x0 or x1 + 1.
// Cost    A line costs one step down and a step for every dot that the crossing moved.
// Source  Peredy 1991 (registers); Ressler 1985, 5.5.2 (tracing show-edges), made exact.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/job_reader.hpp"

namespace halfspace {

struct ArcCrossing {
  std::int16_t at_or_right = 0;  // page dots, scissor.x0 .. scissor.x1 + 1
  std::int16_t right = 0;
};

// What every arc record says before what its kind needs.
struct ArcStart {
  std::int32_t origin_x = 0, origin_y = 0;  // of the local frame: page = origin + local
  std::int32_t x = 0, y = 0;                // page: where to begin looking, the line it enters on
  std::int32_t y_last = 0;                  // page: its last line
  std::int32_t x_min = 0, x_max = 0;        // scissor
};

// The first dots at or right of a crossing on lines to come: halfway, at twice that, and on the last one.
using CrossingsAhead = std::array<std::int16_t, 3>;

// One kind of arc: a narrow program of its own, linked only where a table of kinds names it. `state` is
// `bytes` long and aligned to 8.
struct ArcModule {
  std::int32_t bytes;
  void (*load)(JobReader& in, const ArcStart& start, void* state);  // the rest of an arc record
  ArcCrossing (*settle)(void* state);                               // on the current line: sideways to the crossing
  ArcCrossing (*next)(void* state);                                 // on the next line
  void (*enter_window)(JobReader& in, void* state);  // the rest of a window record; null: the kind has none
  // Kinds whose crossing curves one way all along may rest (curtain.hpp); both null: to look ahead would cost what a rest saves.
  void (*jump_down)(void* state, std::int32_t lines);
  CrossingsAhead (*ahead)(const void* state, std::int32_t lines);  // what settle() will say on so many lines more
};

extern const ArcModule line_arc_64, line_arc_128, line_arc_256;
extern const ArcModule conic_arc_64, conic_arc_128, conic_arc_256;
extern const ArcModule radical_arc_128, radical_arc_256, radical_arc_384;
extern const ArcModule quartic_arc_128, quartic_arc_256, quartic_arc_384;

}  // namespace halfspace
