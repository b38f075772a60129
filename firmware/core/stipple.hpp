// stipple.hpp - halftone: which dots of a 16 x 16 cell are inked at a level.
// Density  At level k of N exactly round(256 (N - 1 - k) / (N - 1)) dots of the cell are inked (halves round
// up). Screens  clustered: two dots a cell of 8 x 8 growing at 45 degrees, for devices that gain (laser,
// electrostatic);
//          bayer: ordered dispersion [Bayer 73]; blue_noise: void and cluster [Ulichney 93], for displays and
//          ink-jet.
// Memory   34 bytes a level for the patterns of a page and their edges; the rank tables are constants.
#pragma once

#include <array>
#include <bit>
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

// rows[y % 16 * levels + k]: the pattern of level k on scan line y. `rows` must hold levels * 16 entries.
void make_patterns(Screen screen, std::int32_t levels, std::span<PatternRow> rows);

// Where a line's pattern changes as levels rise: bit k % 32 of word k / 32 is set where level k looks other than level k - 1. So are bits 0
// and `levels`, where a search ends. On a line of the clustered screen at 65 levels that is one level in eight: between the others there
// is no boundary to find.
class LevelEdges {
 public:
  explicit LevelEdges(const std::uint32_t* words) : words_(words) {}

  // The first at or above level k, 0 <= k <= levels; the last at or below.
  [[nodiscard]] std::int32_t from(std::int32_t k) const {
    const std::uint32_t* at = words_ + (static_cast<std::uint32_t>(k) >> 5);
    std::uint32_t bits = *at & 0xffffffffU << (k & 31);
    while (bits == 0) bits = *++at;
    return static_cast<std::int32_t>(at - words_) * 32 + std::countr_zero(bits);
  }
  [[nodiscard]] std::int32_t to(std::int32_t k) const {
    const std::uint32_t* at = words_ + (static_cast<std::uint32_t>(k) >> 5);
    std::uint32_t bits = *at & 0xffffffffU >> (~k & 31);
    while (bits == 0) bits = *--at;
    return static_cast<std::int32_t>(at - words_) * 32 + 31 - std::countl_zero(bits | 1);  // without a test for 0
  }

 private:
  const std::uint32_t* words_;
};

// Words of a line's edges; edges[y % 16 * edge_words(levels)]: those of scan line y.
constexpr std::size_t edge_words(std::int32_t levels) { return static_cast<std::size_t>(levels) / 32 + 1; }
void find_edges(std::int32_t levels, std::span<const PatternRow> rows, std::span<std::uint32_t> edges);

// Of a page on which every level looks other than the next.
inline constexpr std::array<std::uint32_t, edge_words(256)> all_edges = [] {
  std::array<std::uint32_t, edge_words(256)> words{};
  words.fill(0xffffffffU);
  return words;
}();

// The patterns of a page whose dots have levels themselves, of 8 bits.
inline constexpr std::array<PatternRow, 256> tones = [] {
  std::array<PatternRow, 256> table{};
  for (unsigned k = 0; k < 256; ++k) table[k] = static_cast<PatternRow>(0x101 * k);
  return table;
}();

// The rank of a dot in its cell, 0 .. 255: inked at level k when rank < inked_dots(k).
[[nodiscard]] std::uint8_t screen_rank(Screen screen, std::int32_t x, std::int32_t y);

}  // namespace halfspace
