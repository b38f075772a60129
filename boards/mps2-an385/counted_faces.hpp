// counted_faces.hpp - the modules of a shader, with the instructions that its faces take counted apart from the rest.
// Counted  enter: what a curved face computes once; shade: its spans, the filling of the row included. The two reads of the
//          clock round each call are taken off.
#pragma once

#include <cstdint>

#include "boards/cortex_m/tick_clock.hpp"
#include "firmware/core/engine.hpp"

namespace halfspace::mps2 {

struct FaceCounts {
  std::uint64_t enter_ticks = 0, shade_ticks = 0;
  std::uint64_t dots = 0;  // of curved faces
};

// Modules that do what `of` does, and count. They stay until the next call.
[[nodiscard]] Modules counted(const Modules& of, const cortex_m::TickClock& clock);
[[nodiscard]] FaceCounts face_counts();

}  // namespace halfspace::mps2
