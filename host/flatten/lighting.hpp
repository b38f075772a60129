// lighting.hpp - the light's vector, the normals' matrix and the intensities as the integers of IntegerLighting.
// Basis    Normals and the light are taken in the view's basis right, down, into: an orthographic view with square dots
//          has the identity for its matrix. In perspective the matrix's last column is an integer multiple of
//          (0, 0, 1), without rounding: the gradient's w is large far from the origin and cancels against the rest.
//          So its entries pass 2^15 where the eye is more than 2^15 dots from the page: up to 2^24, no further.
// Error    Entries are rounded at 2^-16 of the largest: at 256 levels, 0.02 of a level.
#pragma once

#include <array>
#include <optional>

#include "host/flatten/integer_scene.hpp"
#include "host/flatten/view.hpp"
#include "host/flatten/window.hpp"

namespace halfspace {

// Rows: how the normal's part along right, down and into follows from a gradient in the dot frame.
[[nodiscard]] std::array<Vector4, 3> normal_rows(const View& view, const PageMap& page);

[[nodiscard]] std::optional<IntegerLighting> light_scene(const Scene& scene, const View& view, const PageMap& page,
                                                         Diagnostics& diagnostics);

}  // namespace halfspace
