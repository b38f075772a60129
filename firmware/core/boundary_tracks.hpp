// boundary_tracks.hpp - boundaries between levels followed from scan line to scan line: where the path of one is known (track_fit.hpp) most
// lines of a strip need no chord for it.
//   A path tells where a piece that is proven monotone passes the level, if it lies in the piece: there is one such place.
// Memory  4 bytes a boundary, in the face's block: a level has one that rises and one that falls, from left to right. Whatever has no path is
//         found by chords.
//
//           31  27 26     17 16      3 2    0
//           | ddx |   dx    |    x    | error |      on line v of the strip, from its middle, the path is at x + v (dx + v ddx)
//
//         in units that the strip has for each (track_strip.hpp), from the block's middle. What rounding them takes is in the error, one of
//         eight. The least ddx tells that there is no path.
// Source  Ours.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/general_contour.hpp"
#include "firmware/core/track_fit.hpp"

namespace halfspace {

// What the numbers of paths make on one line, 2^-16 dot.
struct PathLine {
  std::int32_t middle = 0, x = 0, dx = 0, ddx = 0;

  PathLine() = default;
  // On line v of a strip, counted from its middle.
  PathLine(const TrackUnits& unit, std::int32_t from, std::int32_t v)
      : middle(from), x(unit.x), dx(v * unit.dx), ddx(v * v * unit.ddx) {}
  [[nodiscard]] std::int32_t x_of(std::uint32_t path) const {
    return middle + x * x_part(path) + dx * dx_part(path) + ddx * ddx_part(path);
  }

  static std::int32_t x_part(std::uint32_t path) { return static_cast<std::int32_t>(path << 15) >> 18; }
  static std::int32_t dx_part(std::uint32_t path) { return static_cast<std::int32_t>(path << 5) >> 22; }
  static std::int32_t ddx_part(std::uint32_t path) { return static_cast<std::int32_t>(path) >> 27; }
};

class BoundaryTracks {
 public:
  // Of a face on line y, where its forms hold; nothing is tracked in an empty block.
  BoundaryTracks(GeneralContours& face, std::span<std::uint32_t> block, std::int32_t y);

  [[nodiscard]] bool any() const { return levels_ != 0; }
  using Slot = std::uint32_t*;
  [[nodiscard]] Slot slot_of(std::int32_t k, bool rising) const { return words_ + (rising ? k : levels_ + k); }
  [[nodiscard]] static bool is_path(std::uint32_t word) { return PathLine::ddx_part(word) != no_path; }
  [[nodiscard]] static std::int32_t error_of(std::uint32_t path) { return grades[path & 7] << 9; }
  // Where paths are on the line, on the page.
  [[nodiscard]] const PathLine& line() const { return line_; }
  // Seeks a path for a boundary found at `at` on the line, right of the block's middle in 2^-16 dot.
  void begin(std::int32_t k, bool rising, std::int32_t at) {
    if (levels_ == 0 || lines_left_ < fewest_lines) return;
    const Slot slot = slot_of(k, rising);
    if (*slot == empty) seek(slot, k, rising, at);
  }

 private:
  static constexpr std::int32_t no_path = -16;  // ddx; the rest of the word: strips to pass until another try
  static constexpr std::uint32_t empty = 1U << 31, rests = 2;
  static constexpr std::uint8_t grades[8] = {2, 3, 4, 5, 7, 10, 20, 62};  // errors, 2^-7 dot
  static constexpr std::int32_t fewest_lines = 4;

  [[gnu::noinline]] void seek(Slot slot, std::int32_t k, bool rising, std::int32_t at);
  [[gnu::noinline]] void start_strip(std::int32_t y);
  void renew(Slot slot, std::int32_t k, bool rising, const TrackCurve& ahead);
  // Whether one was found; the slot is taken in any case.
  bool fit(Slot slot, std::int32_t k, bool rising, TrackCurve& curve);
  bool keep(Slot slot, bool rising, const TrackCurve& curve, std::int32_t error);

  GeneralContours& face_;
  std::uint32_t* words_;
  std::int32_t levels_;          // that have slots, rising ones and then falling ones; 0: none
  std::int32_t v_ = 0;           // the line, from the strip's middle
  std::int32_t lines_left_ = 0;  // of the strip
  PathLine line_;
};

}  // namespace halfspace
