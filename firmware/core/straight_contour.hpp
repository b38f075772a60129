// straight_contour.hpp - contours of cylinders and cones: rulings, straight lines through one point of the page (the apex's image,
// or a direction). Where levels change across the rulings is found once for all lines (cross_arc.hpp, ruling_survey.cpp), as
// fractions p of the way from one ruling A of the face to another, B; on line y the change is at
//   x = xA(y) + p (xB(y) - xA(y)),    xA and xB linear in y.
// A is the face's limb, or a ruling as far left of the span as the next lines will need; so is B on the right. A face need not be
// ruled exactly: how far it is from that is part of the error of p.
// Entry    32 bits: p, rounded down (24), and the level right of it (8), in ascending order. The change lies within entry_width
//          units of p. From entry to entry the level changes by one, and in the interval is one of both; or it is told twice:
//          then it may be any in the second's interval, as at a ridge.
// Units    lines 2^-34 dot; p 2^-24, so that on 1000 dots a dot is asked for its level once in some 1,500 changes.
// Source   Ours; margins in docs/contours.md.
#pragma once

#include <cstddef>
#include <cstdint>

namespace halfspace {

// What spans so far would have saved by a way that is not begun.
struct Chance {
  std::int64_t missed = 0;
  std::int32_t spans = 0;

  void add(std::int32_t gain) {
    missed += gain;
    ++spans;
  }
  // Whether as much on each of so many lines to come is worth what it takes to begin.
  [[nodiscard]] bool pays(std::int32_t lines, std::int32_t start) const {
    return missed * lines >= std::int64_t{start} * spans;
  }
};

struct StraightContours {
  std::int64_t left = 0, left_slope = 0;    // xA of `line`, on the page, and its change from line to line
  std::int64_t width = 0, width_slope = 0;  // xB - xA
  std::int64_t missed = 0;  // what spans would have saved since the last survey, and a quarter of what they did by it
  Chance begun;             // of the first
  std::int32_t line = 0;
  std::int32_t entries = 0;  // at the start of the face's block; none: not known
  std::int32_t entry_width = 0;
  std::uint16_t failures = 0;
  bool tried = false;
};

// What a span would save by straight contours, and what it takes to survey them; in one unit (contour.cpp).
struct SurveyChance {
  std::int32_t gain, cost;
};
// Of a span that no survey serves.
[[nodiscard]] bool is_survey_due(StraightContours& face, std::int32_t lines, const SurveyChance& chance);

inline constexpr int line_bits = 34;
inline constexpr int entry_level_bits = 8;
// Lines from the surveyed one, up or down, that a survey holds for; and towards the apex three quarters of the way.
inline constexpr std::int32_t survey_lines = 512;

}  // namespace halfspace
