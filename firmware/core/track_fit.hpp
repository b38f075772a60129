// track_fit.hpp - the path of a boundary between two levels over a strip of scan lines, from a guess at it, with a proven error.
//   Let w go from -1 to 1 over the strip, X(w) be the guess, and xi dots beside it. There
//     D = d0 + d1 w + .. + d4 w^4 + xi (g0 + g1 w + g2 w^2) + xi^2 D_xx                          exactly; q, r and l likewise
//     S = a0 + a1 w + a2 w^2 + a3 w^3 + xi (e0 + e1 w),  a0 = sqrt(d0), and the rest such that S^2 has D's first terms
//   so that |s - S| = |S^2 - D| / (s + S), a polynomial of the terms left: no derivative need be bounded. So it is with |N| and
//   |N|^2 = q + r s, and
//     F = L - T |N| = F0 + F1 w + F2 w^2 + F3 w^3 + xi (G0 + G1 w) to within a known error; of F3 w^3 3/4 F3 w is taken, F3 / 4 left
//   is 0 near xi = -F / G: that is the guess corrected. What F is there and that error, over the least slope |G0| - |G1|, bound how far
//   off it is.
// Source  Ours.
#pragma once

#include <cstdint>

#include "firmware/core/track_strip.hpp"

namespace halfspace {

struct FittedTrack {
  TrackCurve curve;
  std::int32_t error;  // dots, 16 bits of fraction
  enum class State : std::uint8_t {
    failed,
    guess,
    sure
  } state;  // `guess`: nearer than the last one, worth another try
};

// Of the boundary whose bar is `bar` (off by bar_error in 2^-30), where F rises (sign 1) or falls (-1) from left to right.
[[nodiscard]] FittedTrack fit_track(const SectionForms& forms, const TrackStrip& strip, std::uint32_t bar,
                                    std::int32_t bar_error, int sign, const TrackCurve& guess);

}  // namespace halfspace
