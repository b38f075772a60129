// row_painter.hpp - spans of one level become one scan line of a band: stipple words, or levels.
// Owner   The row's words are lent for the painter's life. A gray row keeps one byte a dot in them.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/stipple.hpp"

namespace halfspace {

// Words a row needs.
constexpr std::size_t row_words(const Page& page) {
  return page.format == DotFormat::bilevel ? (static_cast<std::size_t>(page.width) + 31) / 32
                                           : (static_cast<std::size_t>(page.width) + 3) / 4;
}

class RowPainter {
 public:
  RowPainter(const Page& page, std::span<std::uint32_t> words, std::span<const PatternRow> patterns)
      : page_(page), words_(words), patterns_(patterns) {}

  // Starts scan line y with background.
  void begin(std::int32_t y) {
    y_ = y;
    fill(0, page_.width - 1, page_.background);
  }
  // Dots x0 .. x1, 0 <= x0 <= x1 < width, take a level.
  void fill(std::int32_t x0, std::int32_t x1, std::int32_t level) {
    if (page_.format == DotFormat::bilevel) {
      BilevelRow(words_).fill(x0, x1, patterns_[static_cast<std::size_t>(level * cell_side + y_ % cell_side)]);
    } else {
      auto* dots = reinterpret_cast<std::uint8_t*>(words_.data());
      for (std::int32_t x = x0; x <= x1; ++x) dots[x] = static_cast<std::uint8_t>(level);
    }
  }
  // The finished line as band bytes; bytes.size() is the page's row_bytes().
  void copy_to(std::span<std::uint8_t> bytes) const {
    if (page_.format == DotFormat::bilevel) {
      BilevelRow(words_).copy_to(bytes, page_.width);
    } else {
      const auto* dots = reinterpret_cast<const std::uint8_t*>(words_.data());
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = dots[i];
    }
  }

 private:
  const Page& page_;
  std::span<std::uint32_t> words_;
  std::span<const PatternRow> patterns_;
  std::int32_t y_ = 0;
};

}  // namespace halfspace
