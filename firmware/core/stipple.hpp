// stipple.hpp - halftone: which dots of a 16 x 16 cell are inked at a level.
// Density  At level k of N exactly round(256 (N - 1 - k) / (N - 1)) dots of the cell are inked (halves round
// up). Screens  clustered: two dots a cell of 8 x 8 growing at 45 degrees, for devices that gain (laser,
// electrostatic);
//          bayer: ordered dispersion [Bayer 73]; blue_noise: void and cluster [Ulichney 93], for displays and
//          ink-jet.
// Memory   32 bytes a level for the patterns of a page; the rank tables are constants.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/job_format.hpp"

namespace halfspace {

inline constexpr std::int32_t cell_side = 16;
inline constexpr std::int32_t cell_dots = cell_side * cell_side;

// Dots of a cell inked at level k of `levels`.
constexpr std::int32_t inked_dots(std::int32_t k, std::int32_t levels) {
  return (2 * cell_dots * (levels - 1 - k) + (levels - 1)) / (2 * (levels - 1));
}

// One row of a cell as a pattern; bit 15 is the leftmost dot.
using PatternRow = std::uint16_t;

// rows[k * 16 + y % 16]: the pattern of level k on scan line y. `rows` must hold levels * 16 entries.
void make_patterns(Screen screen, std::int32_t levels, std::span<PatternRow> rows);

// The rank of a dot in its cell, 0 .. 255: inked at level k when rank < inked_dots(k).
[[nodiscard]] std::uint8_t screen_rank(Screen screen, std::int32_t x, std::int32_t y);

// One scan line of a bilevel band, filled 32 dots at a time; bit 31 of word 0 is dot 0.
class BilevelRow {
 public:
  explicit BilevelRow(std::span<std::uint32_t> words) : words_(words) {}
  // Dots x0 .. x1 take the pattern. Cost: a store for every 32 dots.
  void fill(std::int32_t x0, std::int32_t x1, PatternRow pattern);
  // The row's bytes, leftmost dot in the most significant bit; dots from `width` on are 0.
  void copy_to(std::span<std::uint8_t> bytes, std::int32_t width) const;

 private:
  std::span<std::uint32_t> words_;
};

}  // namespace halfspace
