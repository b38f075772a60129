#include "firmware/core/engine.hpp"

namespace halfspace {

const Modules all_modules = {
    {&line_arc_64, &line_arc_128, &line_arc_256, &conic_arc_64, &conic_arc_128, &conic_arc_256, &radical_arc_128,
     &radical_arc_256, &radical_arc_384, &quartic_arc_128, &quartic_arc_256, &quartic_arc_384},
    {&exact_384, &exact_768, &exact_1152},
    &root_faces,
    &rational_faces,
    &all_contours};

}  // namespace halfspace
