// picture.hpp - a finished page as a picture file.
//   .png .tif .pbm   one bit a dot for a bilevel picture, ink is black; .png and .tif: 8 bits for a gray one
//   .pgm .exr        gray; a bilevel picture holds 0 and 255 (0 and 1 in .exr)
// Density  Recorded in dots per inch where the format has a place for it: .png, .tif, .exr.
// Errors   Returned, each with a remedy. Nothing half-written is left: write_bytes.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/sheet.hpp"

namespace halfspace {

struct Picture {
  std::int32_t width = 0;
  std::int32_t height = 0;
  int bits = 1;                         // a dot; 1: 1 = ink, leftmost in the most significant bit; 8: 0 is black
  std::vector<std::uint8_t> dots = {};  // height rows of row_bytes()
  std::int32_t dpi = 0;

  [[nodiscard]] std::size_t row_bytes() const {
    return bits == 1 ? (static_cast<std::size_t>(width) + 7) / 8 : static_cast<std::size_t>(width);
  }
};

// Level k of N becomes round(255 k / (N - 1)), halves upwards.
[[nodiscard]] Picture to_picture(const PaperSheet& sheet, std::int32_t dpi);

// Whether the name ends as a picture's does.
[[nodiscard]] bool is_picture_name(const std::string& path);

[[nodiscard]] std::optional<std::string> write_picture(const Picture& picture, const std::string& path);

// As 8 bits a dot, whatever the file holds. nullopt: no picture, or not of one channel.
[[nodiscard]] std::optional<Picture> read_picture(const std::string& path);

}  // namespace halfspace
