// picture_error.hpp - how far a picture's levels lie from the exact ones.
// Units   levels; dots.
// Outline A dot that shows a face where there is none, or none where there is one, errs by its distance to the nearest dot that
//         truly is of the kind drawn; beyond `farthest_outline` it counts as that.
// Levels  Compared where both pictures show a face.
#pragma once

#include <cstdint>
#include <span>

namespace halfspace {

inline constexpr int farthest_outline = 64;

struct PictureError {
  std::uint64_t shaded = 0;                  // dots that truly show a face
  std::uint64_t wrong = 0;                   // dots of another level, outline included
  std::uint64_t wrong_outline = 0;           // dots of the wrong kind
  double level_mean = 0, level_max = 0;      // of all shaded dots
  double outline_mean = 0, outline_max = 0;  // of the dots of the wrong kind
};

// Row by row, -1 is background; both of the same size.
[[nodiscard]] PictureError picture_error(std::span<const std::int16_t> drawn, std::span<const std::int16_t> truth,
                                         std::int32_t width);

}  // namespace halfspace
