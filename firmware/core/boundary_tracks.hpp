// boundary_tracks.hpp - boundaries between levels followed from scan line to scan line: where the path of one is known (track_fit.hpp) most
// lines of a strip need no chord for it.
//   A path tells where a piece that is proven monotone passes the level, if it lies in the piece: there is one such place.
// Memory  8 bytes a boundary, in the face's block: a level has one that rises and one that falls, from left to right. Whatever has no path is found
//         by chords.
// Source  Ours.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/general_contour.hpp"
#include "firmware/core/track_fit.hpp"

namespace halfspace {

class BoundaryTracks {
 public:
  // Of a face on line y, where its forms hold; nothing is tracked in an empty block.
  BoundaryTracks(GeneralContours& face, std::span<std::uint32_t> block, std::int32_t y);

  [[nodiscard]] bool any() const { return levels_ != 0; }
  // A slot is two words. The first: x on the strip's middle line, on the page in 2^-16 dot; its last 7 bits are the error in 2^-6 dot (5) and the
  // state (2). The second, in 2^-16 dot from line to line: dx (20 bits), the last of which are also the first of ddx (16).
  using Slot = std::uint32_t*;
  static constexpr std::int32_t slot_words = 2;
  [[nodiscard]] Slot slot_of(std::int32_t k, bool rising) const {
    return words_ + slot_words * (rising ? k : levels_ + k);
  }
  [[nodiscard]] bool may_have_path(std::int32_t k, bool rising) const {
    const std::uint32_t state = *slot_of(k, rising) & state_mask;
    return state == old || state == fresh;
  }
  // Whether it has a path, maybe found now from that on the last strip.
  [[nodiscard, gnu::always_inline]] bool has_path(Slot slot, std::int32_t k, bool rising) {
    const std::uint32_t state = slot[0] & state_mask;
    return state == fresh || (state == old && renew(slot, k, rising));
  }
  // x on line v of the strip, counted from its middle; and its error.
  [[nodiscard]] static std::int32_t x_of(std::uint32_t place, std::uint32_t shape, std::int32_t v) {
    return static_cast<std::int32_t>(place) +
           v * ((static_cast<std::int32_t>(shape) >> 12) + v * static_cast<std::int16_t>(shape));
  }
  [[nodiscard]] static std::int32_t error_of(std::uint32_t place) {
    return static_cast<std::int32_t>((place & error_mask) << 8);
  }
  // The line's v.
  [[nodiscard]] std::int32_t line() const { return v_; }
  // Seeks a path for a boundary found at `at` on the line, right of the block's middle in 2^-16 dot.
  void begin(std::int32_t k, bool rising, std::int32_t at) {
    if (levels_ == 0 || lines_left_ < fewest_lines) return;
    const Slot slot = slot_of(k, rising);
    if ((slot[0] & state_mask) == empty) seek(slot, k, rising, at);
  }

 private:
  // `fresh`: of this strip; `old`: of the last one.
  static constexpr std::uint32_t empty = 0, old = 1, fresh = 2, failed = 3, state_mask = 3;
  static constexpr std::uint32_t error_mask = 31 << 2;
  static constexpr std::int32_t fewest_lines = 4;

  [[gnu::noinline]] bool renew(Slot slot, std::int32_t k, bool rising);
  [[gnu::noinline]] void seek(Slot slot, std::int32_t k, bool rising, std::int32_t at);
  void start_strip(std::int32_t y);
  // Whether one was found; the slot is taken in any case.
  bool fit(Slot slot, std::int32_t k, bool rising, TrackCurve guess);
  bool keep(Slot slot, bool rising, const TrackCurve& curve, std::int32_t error);

  GeneralContours& face_;
  std::uint32_t* words_;
  std::int32_t levels_ = 0;      // that have slots, rising ones and then falling ones; 0: none
  std::int32_t v_ = 0;           // the line, from the strip's middle
  std::int32_t middle_ = 0;      // the block's, 16 bits of fraction
  std::int32_t lines_left_ = 0;  // of the strip
};

}  // namespace halfspace
