// track_strip.hpp - what the tracks of a face's boundaries share (boundary_tracks.hpp): the face's forms about a strip of scan lines.
#pragma once

#include <cstdint>

#include "firmware/core/section_forms.hpp"

namespace halfspace {

// In units of 2^30, w going from -1 to 1 over the strip: v0 + v1 tau + 2 v2 tau^2 + w (y + xy tau) + w^2 yy, where
// tau = t 2^-half_bits has 31 bits of fraction.
struct StripQuadratic {
  std::int32_t v0 = 0, v1 = 0, v2 = 0, y = 0, xy = 0, yy = 0;
};
// v0 + v1 tau + w y
struct StripLinear {
  std::int32_t v0 = 0, v1 = 0, y = 0;
};

// x + slope w + bend w^2, in dots right of the block's middle, 16 bits of fraction.
struct TrackCurve {
  std::int32_t x = 0, slope = 0, bend = 0;
};

// What a path is kept in (boundary_tracks.hpp), 2^-16 dot: x has 14 bits, dx 10, ddx 5.
struct TrackUnits {
  std::int32_t x = 0, dx = 0, ddx = 0;
};

struct TrackStrip {
  StripQuadratic d, q;
  StripLinear r, l;                   // of l a quarter
  std::int32_t first = 0, end = 0;    // its lines, on the page
  std::int32_t middle = 0, half = 0;  // w = (y - middle) / half; 0: there was no strip yet
  std::int32_t from = 0;              // its block's middle, where paths count from
  TrackUnits unit;
  std::int32_t most_dx = 0, most_ddx = 0;  // of its paths so far: they make the next strip's units
  // From line to line, 2^-16 dot: of the last path found of a boundary that falls, and of one that rises. A guess at the next one's.
  struct Shape {
    std::int32_t dx = 0, ddx = 0;
    TrackCurve turn{};  // what the last one renewed has beside its old path: its neighbours turn alike
  } last[2];

  [[nodiscard]] bool holds(std::int32_t y) const { return first <= y && y < end; }
  // The next line begins a strip: the block is another.
  void drop() { end = first; }
  void meet(std::int32_t dx, std::int32_t ddx);
  // From line y of the forms' block on.
  void cover(const SectionForms& forms, std::int32_t y);
};

}  // namespace halfspace
