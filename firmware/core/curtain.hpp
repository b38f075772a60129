// curtain.hpp - what a strip of lines surely hides: faces that lie behind it rest until the next strip.
//
//             x ->  |        |        |        |        |       columns of 16 dots, strips of 17 lines: tiles
//             y     +--------+--------+--------+--------+
//             |  ...|.. a ___|________|___ a   |        |       a tile keeps the depth behind which nothing shows: the least
//             v     |    /   | a      | a  \ b | b  ... |       over the faces that cover all its dots of the farthest there
//                   +--------+--------+--------+--------+
//
//   Of 4000 atoms that fill a page seven deep, three in four lines of a cell lie behind the curtain, and cost nothing.
// Exact   A face rests where on each of its dots another is nearer by whole dots; the nearest of all rests nowhere.
// Arcs    A crossing's curvature keeps one sign (a line, or one branch of a conic), so between lines y, m and e, m in the middle, it lies
//         between the chords and what they are produced to: within the hull of its places there and of 2 m - y and 2 m - e.
// Memory  Four bytes a column, needed by every job: how many spans a line takes must not depend on what memory there is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "firmware/core/arc.hpp"
#include "firmware/core/depth_block.hpp"

namespace halfspace {

// Lines of a strip: its first, its last, and as many on either side of its middle.
inline constexpr std::int32_t strip_middle = strip_rows / 2;
inline constexpr std::int32_t strip_end = strip_rows - 1;
static_assert(strip_end == 2 * strip_middle);

// Dots between which an arc's crossing stays on a strip: root > low - 1, root <= high.
struct CrossingRange {
  std::int32_t low, high;
};

// From the first dots at or right of it on the strip's first, middle and last line, unless one of them is beyond x_min + 1 .. x_max, the
// scissor's end: then it may be anywhere.
[[nodiscard]] CrossingRange crossing_range(std::int32_t first, std::int32_t middle, std::int32_t last,
                                           std::int32_t x_min, std::int32_t x_max);

class Curtain {
 public:
  explicit Curtain(std::span<std::int32_t> columns) : columns_(columns) {}

  static constexpr std::size_t columns_of(std::int32_t width) {
    return static_cast<std::size_t>((width + column - 1) / column);
  }
  // A strip begins with nothing hidden.
  void open();
  // Dots x0 .. x1 of the strip's lines are covered by a face no nearer than `low`, and on dots a .. b no farther than high(a, b).
  template <class High>
  void cover(std::int32_t x0, std::int32_t x1, std::int32_t low, const High& high) {
    for (std::int32_t x = (x0 + column - 1) / column * column; x + column <= x1 + 1; x += column) {
      std::int32_t& depth = columns_[static_cast<std::size_t>(x / column)];
      if (low < depth) depth = std::min(depth, high(x, x + column - 1));
    }
  }
  // Whether on dots x0 .. x1 >= 0 nothing shows of a face no nearer than `low`, and on dots a .. b than nearest(a, b).
  template <class Nearest>
  [[nodiscard]] bool hides(std::int32_t x0, std::int32_t x1, std::int32_t low, const Nearest& nearest) const {
    for (std::int32_t x = x0 / column * column; x <= x1; x += column) {
      const std::int32_t depth = columns_[static_cast<std::size_t>(x / column)];
      if (depth >= low && depth >= nearest(std::max(x, x0), std::min(x + column - 1, x1))) return false;
    }
    return true;
  }

 private:
  static constexpr std::int32_t column = 16;  // dots

  std::span<std::int32_t> columns_;
};

}  // namespace halfspace
