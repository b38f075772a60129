// straight_contour.hpp - contours of cylinders and cones: rulings, straight lines through one point of the page (the apex's image,
// or a direction). One line of the face is traced dot by dot; from then on every line has the same crossings, moved and scaled alike:
//   x(y) = x0 + slope (y - y0) + b (1 + spread (y - y0))
// for the crossing b dots right of the first traced dot x0 of line y0. spread is 0 where the rulings are parallel, else
// 1 / (y0 - apex y), and lines farther than half, or more than twice as far from the apex, are traced anew.
// A crossing is known to lie in an interval: at first between two dots. Where a dot of some line falls into it the dot is asked,
// and the interval shrinks: after n lines it is about 1/n dot, so that n lines ask some ln n dots a crossing.
// Entry    32 bits: the interval's left end b (24), its width as (4 + w1) 2^w2 (2 + 4), and how the level changes (2).
// Units    "parts" 2^-part_bits dot, such that a traced line fits 24 bits.
// Exact    Between two neighbouring dots of the traced line the intensity is proven monotone (ridge_form.hpp), or they bound a zone,
//          whose dots are all asked.
// Source   Ours; margins in docs/contours.md.
#pragma once

#include <cstdint>
#include <span>

namespace halfspace {

struct StraightContours {
  std::int64_t slope = 0;            // 2^-32
  std::int64_t spread = 0;           // 2^-46
  std::int32_t line = 0, first = 0;  // the traced line, and its first dot: page
  std::int32_t length = 0;           // its dots less one; 0: none traced yet
  std::int32_t level = 0;            // at its first dot
  std::int32_t entries = 0;          // at the start of the face's block
  std::uint32_t waited = 0;          // dots shaded otherwise since the last trace
  std::uint8_t part_bits = 0;
};

// Words of entries that a face can have; with more its contours are found otherwise.
constexpr std::size_t straight_block_words(std::int32_t levels) { return 2 * static_cast<std::size_t>(levels) + 16; }

}  // namespace halfspace
