// sheet.hpp - what a simulated device shows or has printed: dots laid out as in a band
// (firmware/core/page.hpp).
#pragma once

#include <vector>

#include "firmware/core/page.hpp"

namespace halfspace {

struct PaperSheet {
  std::int32_t width = 0;
  std::int32_t height = 0;
  DotFormat format = DotFormat::bilevel;
  std::int32_t levels = 2;              // of gray dots
  std::vector<std::uint8_t> dots = {};  // height rows; bilevel: 1 = ink

  [[nodiscard]] std::size_t row_bytes() const {
    return Page{.width = width, .height = height, .format = format}.row_bytes();
  }
  friend bool operator==(const PaperSheet&, const PaperSheet&) = default;
};

}  // namespace halfspace
