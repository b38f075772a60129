// shade.hpp - the levels of one face along one visible span, exact at every dot.
//
//   On a scan line  N = d * normal = u(x) + v s(x):  u linear in x (quadratic on a rational face), v
//   constant, s(x) = sqrt(D(x)).  The level is the largest k with  L >= t_k |N|,  L = light . N,  t_k as in
//   LevelTable.
// Filter  u, D in 64-bit additive registers scaled so that N stays under 2^30; s by integer square root, or
// by Jordan's
//         incremental conic. L^2 - t_k^2 |N|^2 decides when it exceeds its error bound; else exact.hpp
//         decides.
// Bound   With n dots in the span: rounding of D's registers is at most n^2/2 + n + 1, so s is off by at most
// n + 3
//         units (sqrt(D + e) - sqrt(D) <= sqrt(e)); N and L follow linearly. See docs/core.md.
// Cost    Per dot 2 additions for D, 4 for u, 4 products for v s, 4 squares and, as a rule, two comparisons
// of levels. Source  Ressler 1985, (6.8), 6.3, 6.4; Jordan et al. 1973 for the incremental conic; exact
// levels are ours.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/depth.hpp"
#include "firmware/core/face.hpp"
#include "firmware/core/row_painter.hpp"

namespace halfspace {

// squares[k] = (t_k |light| / 2^light_bits)^2 in 0.32 fixed point: what level k asks of (L / |N|)^2.
struct LevelTable {
  std::int32_t levels = 2;
  std::int32_t ambient_level = 0;    // every dot reaches it
  std::int32_t top_level = 0;        // no dot exceeds it
  std::int32_t light_bits = 0;       // |light| < 2^light_bits
  std::span<std::uint32_t> squares;  // one for every level
};

// Fills the table; `squares` must hold `levels` entries.
[[nodiscard]] LevelTable make_levels(const Lighting& lighting, std::int32_t levels, std::span<std::uint32_t> squares);

// Shades dots x0 .. x1 of scan line y, where `face` (root or rational) is visible.
void shade_span(const ActiveFace& face, const Lighting& lighting, const LevelTable& table, Shader shader,
                std::int32_t y, std::int32_t x0, std::int32_t x1, RowPainter& painter, Counters& counters);

}  // namespace halfspace
