// row_painter.hpp - spans of one level become one scan line of a band: words of stipple, or of levels.
// Row     Words of 32 bits, the leftmost dot in the most significant ones: 32 dots of a bilevel page, 4 of a gray one. So both are painted
//         alike: a level has a pattern of 16 bits that repeats along the line. They are stored as a band's bytes.
// Owner   The row's words are lent for the painter's life.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>

#include "firmware/core/page.hpp"
#include "firmware/core/stipple.hpp"

namespace halfspace {

// Words a row needs.
constexpr std::size_t row_words(const Page& page) {
  return page.format == DotFormat::bilevel ? (static_cast<std::size_t>(page.width) + 31) / 32
                                           : (static_cast<std::size_t>(page.width) + 3) / 4;
}

// A word as it is stored, its most significant byte first, and back.
constexpr std::uint32_t stored_word(std::uint32_t word) {
  if constexpr (std::endian::native == std::endian::big) return word;
  return word << 24 | (word & 0xff00U) << 8 | (word >> 8 & 0xff00U) | word >> 24;
}

class RowPainter {
 public:
  // `patterns` of make_patterns(), `edges` of find_edges(); a gray page needs neither. Without edges all levels count as different.
  RowPainter(const Page& page, std::span<std::uint32_t> words, std::span<const PatternRow> patterns,
             std::span<const std::uint32_t> edges = {});

  // Starts scan line y with background.
  void begin(std::int32_t y);
  // Dots x0 .. x1, 0 <= x0 <= x1 < width, take a level.
  void fill(std::int32_t x0, std::int32_t x1, std::int32_t level);
  // The finished line as band bytes; bytes.size() is the page's row_bytes().
  void copy_to(std::span<std::uint8_t> bytes) const;

  [[nodiscard]] bool is_bilevel() const { return page_.format == DotFormat::bilevel; }
  // Of the current line: what a level looks like, and where that changes.
  [[nodiscard]] const PatternRow* looks() const { return line_; }  // by level
  [[nodiscard]] LevelEdges edges() const { return LevelEdges(line_edges_); }
  // About as many of so many neighbouring levels look other than the level below.
  [[nodiscard]] std::int32_t edges_of(std::int32_t levels) const { return levels * edge_share_ >> share_bits; }
  // And the reverse.
  [[nodiscard]] std::int32_t levels_of(std::int32_t edges) const { return edges * edge_gap_ >> share_bits; }

 private:
  template <class DotBits>
  friend class Runs;
  const Page& page_;
  std::span<std::uint32_t> words_;
  std::span<const PatternRow> patterns_;
  std::span<const std::uint32_t> edges_;
  const PatternRow* line_ = nullptr;  // by level, of the current line
  const std::uint32_t* line_edges_ = all_edges.data();
  static constexpr int share_bits = 8;
  std::int32_t edge_share_ = 1 << share_bits;  // of levels in the mean of all lines
  std::int32_t edge_gap_ = 1 << share_bits;    // levels from one to the next, likewise
};

// A span's runs of one level from left to right, cheaper than fills: the word under way stays in a register, so that a change of level
// costs a dozen instructions and dots are stored a word at a time. Keep it a local of the loop that feeds it.
// Order   Made with the span's first dot; change() with dots of the span that do not fall; end() once, with the last dot.
template <class DotBits>  // log2 of a dot's bits, if it is known when compiled
class Runs {
 public:
  Runs(const RowPainter& row, std::int32_t x0, std::int32_t level) : line_(row.line_) {
    if constexpr (std::is_same_v<DotBits, int>) dot_bits_ = row.is_bilevel() ? 0 : 3;
    const std::uint32_t at = static_cast<std::uint32_t>(x0) << dot_bits_;
    to_ = row.words_.data() + at / 32;
    base_ = at & ~31U;
    open_ = stored_word(*to_);
    paint(at - base_, level);
  }
  // Dots from x on take the level.
  void change(std::int32_t x, std::int32_t level) { paint(reach(x), level); }
  void end(std::int32_t x1) {
    const std::uint32_t beyond = 0xffffffffU >> (1U << dot_bits_) >> reach(x1);
    *to_ = stored_word((open_ & ~beyond) | (stored_word(*to_) & beyond));
  }

 private:
  // The first bit of dot x in the word under way; the words before it are stored.
  std::uint32_t reach(std::int32_t x) {
    std::uint32_t bit = (static_cast<std::uint32_t>(x) << dot_bits_) - base_;
    if (bit < 32) return bit;
    if (static_cast<std::int32_t>(bit) < 0) return 0;  // only where a job lies
    base_ += bit & ~31U;
    *to_++ = stored_word(open_);
    for (; bit >= 64; bit -= 32) *to_++ = stored_word(word_);
    open_ = word_;
    return bit - 32;
  }
  void paint(std::uint32_t bit, std::int32_t level) {
    word_ = line_[level] * 0x10001U;
    open_ ^= (open_ ^ word_) & (0xffffffffU >> bit);
  }

  const PatternRow* line_;  // by level
  [[no_unique_address]] DotBits dot_bits_{};
  std::uint32_t* to_;       // the word under way
  std::uint32_t base_;      // its first bit in the row
  std::uint32_t open_;      // its dots so far, and word_ from the last change on
  std::uint32_t word_ = 0;  // the level's pattern
};
using RunPainter = Runs<int>;
using BilevelRuns = Runs<std::integral_constant<int, 0>>;

}  // namespace halfspace
