// baselines.hpp - exact shaders that look at every dot, as good as could be made for a Cortex-M3: what contours are measured with.
//   A2  any face with z^2: a certified root at every dot (root32.hpp), the level by comparison with the two next to it
//   A4  spheres, the light before them: no root and no division. With L = l + m s, s = sqrt(D), and |N| the same everywhere, level k
//       is reached when m^2 D >= (T_k - l)^2 or l >= T_k; D and l go on by additions. Other faces are left to A2.
// Exact   Dots that the filters cannot tell are asked of the core (reaches_level.hpp): the picture is the core's own.
// Limits  Pages of at most 2048 dots a side. What is computed once for a face is kept for the last one only: made for pages of one face.
#pragma once

#include "firmware/core/shade.hpp"

namespace halfspace::mps2 {

inline constexpr std::int32_t largest_page = 2048;

// Before a page is drawn.
void set_page(const Page& page);

extern const FaceModule any_quadric_dots, sphere_dots;  // A2, A4

}  // namespace halfspace::mps2
