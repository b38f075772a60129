// sphere_contour.hpp - contours of a face on which |N| is constant: a sphere seen orthographically, also with dots that are not
// square. With xi dots right of the centre of line y's chord, eta its height above the sphere's middle and rho^2 = R^2 - eta^2
//   R L / (|l| |N|) = a xi + b sqrt(rho^2 - xi^2) + c eta,    (a, b, c) the unit vector to the light
// so with A = sqrt(a^2 + b^2) level k on a line is where (a xi + b sqrt(rho^2 - xi^2)) / A >= C = (t_k R - c eta) / A: the interval
//   (a C -+ |b| w) / A,    w = sqrt(rho^2 - C^2)
// or, with the light behind (b < 0), all but that interval. Nothing is kept from line to line.
// Units    "radial" 2^-f dot with 2^29 <= R 2^f < 2^30; "places" 2^-15 dot.
// Ranges   4 <= R <= 2^13 dots, A = 0 or >= 2^-10, more where a level is higher than R: what lies outside goes another way.
// Source   Ours; derivation and margins in docs/contours.md.
#pragma once

#include <cstdint>

namespace halfspace {

struct SphereContours {
  std::int64_t eta_slope, eta_at;        // eta = (slope (y - middle) + at) 2^-16, radial, y in the face's frame
  std::int64_t centre_slope, centre_at;  // the chord's centre, likewise
  // C = (bar_step k - lift_slope (y - middle) - bar_at) 2^-32, radial, modulo 2^32: |C| < 2^31 where a line may meet level k
  std::uint64_t bar_step = 0, lift_slope = 0, bar_at = 0;
  std::int64_t level_base;  // level = (base + slope v 2^-32) 2^-16, v = R L / (|l| |N|), radial
  std::uint32_t level_slope;
  std::int32_t radius;               // radial
  std::int32_t middle;               // the line nearest to the centre
  std::int32_t a, b, c;              // 2^30
  std::int32_t reach;                // A 2^30; 0: every line has one level
  std::int32_t alpha = 0, beta = 0;  // a / A and |b| / A, places a radial unit 2^32
  std::int32_t sure;                 // error of a crossing where w >= wide, in places
  std::int32_t sure_if_narrow;       // ... where w >= narrow
  std::int16_t level_error;          // of a level where the root is deep, in 2^-16: below 2^11
  std::uint8_t fraction = 0;         // f; 0: not made
  // L is that of a dot's column: of each level the face's block keeps the last column asked, from 1, and, in the lowest bit, its answer.
  bool is_upright = false;
};

}  // namespace halfspace
