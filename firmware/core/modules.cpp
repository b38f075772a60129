#include "firmware/core/engine.hpp"

namespace halfspace {

const ArcModule* const all_arc_modules[arc_kinds] = {&line_arc_64,  &line_arc_128,  &line_arc_256,
                                                     &conic_arc_64, &conic_arc_128, &conic_arc_256};

}  // namespace halfspace
