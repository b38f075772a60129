// shade.hpp - the levels of one face along one visible span, exact at every dot, or (stride.hpp) at some.
//   The level is the largest k with  L >= t_k |N|,  L = light . N, N the outward normal (any positive multiple of it).
//   A filter on 64-bit additive registers settles nearly all dots; exact.hpp settles the rest.
//   root_shade.cpp      faces with z^2: the depth by integer square root, or by Jordan's incremental conic
//   rational_shade.cpp  faces without z^2
// Source  Ressler 1985, (6.8), 6.3, 6.4; Jordan et al. 1973 for the incremental conic; exact levels are ours (docs/core.md).
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/depth.hpp"
#include "firmware/core/face.hpp"
#include "firmware/core/row_painter.hpp"

namespace halfspace {

// squares[k] = (t_k |light| / 2^light_bits)^2 in 0.32 fixed point, rounded down: what level k asks of
// (L / (|N| 2^light_bits))^2.
struct LevelTable {
  std::int32_t levels = 2;
  std::int32_t ambient_level = 0;    // every dot reaches it
  std::int32_t top_level = 0;        // no dot exceeds it
  std::int32_t light_bits = 0;       // |light| < 2^light_bits
  std::span<std::uint32_t> squares;  // one for every level
};

// Fills the table; `squares` must hold `levels` entries.
[[nodiscard]] LevelTable make_levels(const Lighting& lighting, std::int32_t levels, std::span<std::uint32_t> squares);

struct FaceContours;  // contour.hpp

// What a span's shading needs besides its dots.
struct ShadeJob {
  const ActiveFace& face;
  const Lighting& lighting;
  const LevelTable& table;
  const ExactModule& exact;
  RowPainter& painter;
  Counters& counters;
  std::int32_t stride = 1;               // the largest of Shader::stride
  FaceContours* contours = nullptr;      // of the face; none: no contours
  std::span<std::int32_t> scratch = {};  // one entry a level, free for the length of a span
};

// Shade dots x0 .. x1 of scan line y, where the face is visible.
void shade_root_span(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1);
void shade_rational_span(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1);

// A kind of curved face: what it computes once, before its first dot is shaded, and its shader. Linked only where a table of modules names it.
struct FaceModule {
  void (*enter)(ActiveFace& face, const Lighting& lighting);
  void (*shade)(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1);
};

extern const FaceModule root_faces, rational_faces;

}  // namespace halfspace
