// pages.hpp - pages for driver tests: noise with runs in it, fed in bands of any height.
#pragma once

#include <algorithm>
#include <random>

#include "hal/raster_device.hpp"
#include "sim/sheet.hpp"

namespace halfspace {

// Half of the bytes repeat the one before them and one row in three the row above, so that runs and equal lines occur.
inline PaperSheet noise(std::int32_t width, std::int32_t height, DotFormat format, std::int32_t levels, unsigned seed) {
  std::mt19937 random(seed);
  PaperSheet sheet{.width = width, .height = height, .format = format, .levels = levels};
  for (std::int32_t y = 0; y < height; ++y) {
    const auto above = sheet.dots.end() - static_cast<std::ptrdiff_t>(y > 0 ? sheet.row_bytes() : 0);
    if (y > 0 && random() % 3 == 0) {
      const std::vector<std::uint8_t> copy(above, sheet.dots.end());
      sheet.dots.insert(sheet.dots.end(), copy.begin(), copy.end());
      continue;
    }
    const unsigned values = format == DotFormat::gray ? static_cast<unsigned>(levels) : 256U;
    for (std::size_t x = 0; x < sheet.row_bytes(); ++x) {
      const bool repeat = x > 0 && random() % 2 == 0;
      sheet.dots.push_back(repeat ? sheet.dots.back() : static_cast<std::uint8_t>(random() % values));
    }
    if (format == DotFormat::bilevel && width % 8 != 0) {
      sheet.dots.back() &= static_cast<std::uint8_t>(0xFF << (8 - width % 8));
    }
  }
  return sheet;
}

inline Page page_of(const PaperSheet& sheet, std::int32_t background = 0) {
  const std::int32_t levels = sheet.format == DotFormat::gray ? sheet.levels : 65;
  return {sheet.width, sheet.height, sheet.format, levels, background};
}

// The whole page, or up to the first error.
inline DeviceStatus draw(RasterDevice& device, const PaperSheet& sheet, std::int32_t band_rows) {
  DeviceStatus status = device.begin_page(page_of(sheet));
  for (std::int32_t y = 0; y < sheet.height && status == DeviceStatus::ok; y += band_rows) {
    const std::int32_t rows = std::min(band_rows, sheet.height - y);
    const std::size_t row_bytes = sheet.row_bytes();
    status = device.put_band(
        {y, rows,
         std::span(sheet.dots)
             .subspan(static_cast<std::size_t>(y) * row_bytes, static_cast<std::size_t>(rows) * row_bytes)});
  }
  return status == DeviceStatus::ok ? device.end_page() : status;
}

// The page as a device of whole lines receives it: blank on the right.
inline PaperSheet padded(const PaperSheet& sheet, std::int32_t width) {
  PaperSheet wide{.width = width, .height = sheet.height};
  wide.dots.resize(static_cast<std::size_t>(sheet.height) * wide.row_bytes());
  for (std::size_t y = 0; y < static_cast<std::size_t>(sheet.height); ++y) {
    std::copy_n(sheet.dots.begin() + static_cast<std::ptrdiff_t>(y * sheet.row_bytes()), sheet.row_bytes(),
                wide.dots.begin() + static_cast<std::ptrdiff_t>(y * wide.row_bytes()));
  }
  return wide;
}

}  // namespace halfspace
