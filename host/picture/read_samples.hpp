// read_samples.hpp - a picture file's first channel, as stored.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace halfspace {

struct Samples {
  std::int32_t width = 0, height = 0;
  std::uint16_t top = 0;              // of white: 255 or 65535
  std::vector<std::uint16_t> values;  // row by row
};

// Of pictures with 8 or 16 bits. Throws std::runtime_error with the file and what is wrong.
[[nodiscard]] Samples read_samples(const std::string& path);

}  // namespace halfspace
