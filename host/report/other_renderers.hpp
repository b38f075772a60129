// other_renderers.hpp - the same scene by POV-Ray or by Raster3D: the time it takes and the picture it gives.
// Light   Both are asked for our formula: ambient plus parallel light times cosine, no shadows, no highlight.
// Levels  floor((levels - 1) * intensity). POV-Ray's picture is linear, 16 bits; Raster3D's is the root of the intensity in 8
//         bits, so that the middle of its step is taken.
// Time    Processor time of the whole program, net of a page without bodies: reading the scene and drawing it. POV-Ray writes
//         no file; Raster3D, which must, writes samples as they are (its AVS format) or, as it does when asked for nothing, a
//         PNG, whose compression is most of its time. Neither is halftoned.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/molecule.hpp"

namespace halfspace {

struct OtherPicture {
  std::string renderer;
  double seconds = 0;                // net of the empty page
  std::vector<std::int16_t> levels;  // -1: no face (black: the scenes have ambient light)
};

struct OtherRequest {
  std::int32_t width = 0, height = 0, levels = 2;
  int runs = 3;  // the median counts
};

enum class Raster3dFile { samples, png };

// The scene file as tools/uq_to_pov.py writes it, with a bounding box for every body. Nothing, and `why`: the program is missing
// or fails.
[[nodiscard]] std::optional<OtherPicture> draw_by_povray(const std::string& scene_path, const OtherRequest& request,
                                                         std::string& why);
[[nodiscard]] std::optional<OtherPicture> draw_by_raster3d(const Molecule& molecule, const OtherRequest& request,
                                                           Raster3dFile file, std::string& why);

}  // namespace halfspace
