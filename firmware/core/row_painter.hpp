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
  friend class RunPainter;
  const Page& page_;
  std::span<std::uint32_t> words_;
  std::span<const PatternRow> patterns_;
  std::int32_t y_ = 0;
};

// A span's runs of one level from left to right, cheaper than fills: the stipple word under way stays in a register, so that a
// change of level costs some dozen instructions and dots are stored 32 at a time. Keep it a local of the loop that feeds it.
// Order   Made with the span's first dot; change() with dots of the span that do not fall; end() once, with the last dot.
class RunPainter {
 public:
  RunPainter(const RowPainter& row, std::int32_t x0, std::int32_t level) : words_(row.words_.data()) {
    if (row.page_.format == DotFormat::gray) {
      x_ = x0;
      word_ = static_cast<std::uint32_t>(level);
      return;
    }
    patterns_ = row.patterns_.data() + row.y_ % cell_side;
    at_ = words_ + (x0 >> 5);
    word_ = pattern(level);
    open_ = merged(*at_, word_, x0);
  }
  // Dots from x on take the level.
  void change(std::int32_t x, std::int32_t level) {
    if (patterns_ == nullptr) return change_gray(x, level);
    flush(words_ + (x >> 5));
    word_ = pattern(level);
    open_ = merged(open_, word_, x);
  }
  void end(std::int32_t x1) {
    if (patterns_ == nullptr) return change_gray(x1 + 1, 0);
    std::uint32_t* last = words_ + (x1 >> 5);
    flush(last);
    const std::uint32_t beyond = 0x7fffffffU >> (x1 & 31);
    *last = (open_ & ~beyond) | (*last & beyond);
  }

 private:
  [[nodiscard]] std::uint32_t pattern(std::int32_t level) const {
    const std::uint32_t p = patterns_[level * cell_side];
    return p << 16 | p;
  }
  // `right` from dot x of the word on, `left` before.
  static std::uint32_t merged(std::uint32_t left, std::uint32_t right, std::int32_t x) {
    return left ^ ((left ^ right) & (0xffffffffU >> (x & 31)));
  }
  void flush(std::uint32_t* to) {
    if (at_ >= to) return;
    *at_++ = open_;
    open_ = word_;
    while (at_ < to) *at_++ = word_;
  }
  void change_gray(std::int32_t x, std::int32_t level) {
    auto* dots = reinterpret_cast<std::uint8_t*>(words_);
    for (; x_ < x; ++x_) dots[x_] = static_cast<std::uint8_t>(word_);
    word_ = static_cast<std::uint32_t>(level);
  }

  std::uint32_t* words_;
  const PatternRow* patterns_ = nullptr;  // of this scan line, a level `cell_side` apart; none: gray
  std::uint32_t* at_ = nullptr;           // the word under way
  std::uint32_t open_ = 0;                // its dots so far, and word_ from the last change on
  std::uint32_t word_ = 0;                // the level's pattern; gray: the level
  std::int32_t x_ = 0;                    // gray: the first dot not yet painted
};

}  // namespace halfspace
