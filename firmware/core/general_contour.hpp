// general_contour.hpp - what a face keeps for general_contour: nothing that any dot depends on but forms and bars.
#pragma once

#include <cstdint>

#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/section_forms.hpp"
#include "firmware/core/track_strip.hpp"

namespace halfspace {

// Bars of levels, T_k: they go up evenly. 31 bits of fraction.
struct LevelBars {
  std::uint32_t top = 0, step = 0;
  std::int32_t top_level = 0;
  std::int32_t error = 0;  // in 2^-30; 0: nothing is known yet

  [[nodiscard]] static LevelBars of(const LevelTable& table, const Lighting& lighting);
  [[nodiscard]] std::uint32_t at(std::int32_t k) const {
    return top - static_cast<std::uint32_t>(top_level - k) * step;
  }
};

struct GeneralContours {
  union {
    SectionForms forms{};
    QuotientForms quotient;
  };
  bool is_quotient = false;  // z: then the latter
  // The forms of another of its spans are in the face's block; those or these are by z.
  bool has_other = false, other_is_by_depth = false;
  LevelBars bars;
  TrackStrip strip;
  std::int32_t ridge = 0;           // of the last line, on the page: where the next one's is sought
  std::int32_t unsure_courses = 0;  // on this block's lines so far
  std::int32_t vain_chords = 0;     // short spans, one after the other, that chords did not do
  std::int32_t steps = 0;           // that the last span took (docs/contours.md)
};

}  // namespace halfspace
