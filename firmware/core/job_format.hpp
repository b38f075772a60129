// job_format.hpp - the words of a job, shared by the core, which reads it, and the host, which writes it.
// Bytes   docs/job-format.md draws them. A job is a header, then records sorted by the scan line they enter
// on. Numbers "varint": 7 bits a byte, least significant first, zigzag for signed values. "wide": one byte of
// length n,
//         then n bytes of two's complement, least significant first.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/page.hpp"

namespace halfspace {

inline constexpr std::array<std::uint8_t, 4> job_magic{'H', 'S', 'J', '3'};

// Every record starts with its type and the lines since the previous record's entry.
enum class Record : std::uint8_t { end, plane_face, root_face, rational_face, arc, cell, span, window };

// How an arc's crossing follows from the sign of its form, and the width of its registers.
enum class ArcKind : std::uint8_t {
  line64,
  line128,
  line256,
  conic64,
  conic128,
  conic256,
  radical128,
  radical256,
  radical384,
  quartic128,
  quartic256,
  quartic384
};
inline constexpr int arc_kinds = 12;

// Which root of the form an arc follows; see host/resolve/resolved_scene.hpp. A conic of first order in x is
// `single`.
enum class ArcBranch : std::uint8_t { single, left, right };

// A separator (host/resolve/resolved_scene.hpp) in 2^-16 dot of the local frame, and its step a line: at most 2^47, so that
// after a page's 2^15 lines it is still below 2^63.
inline constexpr int separator_fraction = 16;
inline constexpr std::int64_t largest_separator = std::int64_t{1} << 47;

enum class Screen : std::uint8_t { clustered, bayer, blue_noise };
// isqrt, jordan and contour give the same dots; automatic takes the cheaper of contour and isqrt.
enum class Shader : std::uint8_t { isqrt, jordan, stride, contour, automatic };

inline constexpr std::uint16_t no_slot = 0xffff;

// A local frame's x and y origin, in page dots: near the page, so that local coordinates stay under 2^17.
inline constexpr std::int32_t largest_origin = 1 << 16;

// The lighting of design section 5 as integers: intensity = (ambient + parallel * max(0, cos)) / unit,
// with N = matrix * (homogeneous page-frame gradient). A perspective matrix holds the eye's distance in dots, hence its range.
// unit <= 2^16.
inline constexpr std::int32_t largest_matrix = 1 << 24;
inline constexpr std::int32_t largest_light = 1 << 15;
struct Lighting {
  std::array<std::array<std::int32_t, 4>, 3> matrix{};
  std::array<std::int32_t, 3> light{};
  std::int32_t ambient = 0, parallel = 0, unit = 1;
};

// What a job needs of the machine that draws it; known before the first dot.
struct JobNeeds {
  std::int32_t faces = 0, arcs = 0, cells = 0;  // slots in use at once
  std::int32_t spans = 0;                       // pieces of the fullest scan line
  std::int32_t arc_bytes = 0;                   // the largest arc kind's registers
  std::int32_t exact_bits = 0;                  // of the widest form that exact arithmetic may meet
};

struct JobHeader {
  Page page;
  Screen screen = Screen::clustered;
  std::int32_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;  // scissor, inclusive
  std::uint32_t bound = 0;  // how far a silhouette may lie from the true one, in 2^-20 dot, rounded up
  Lighting lighting;
  JobNeeds needs;
};

}  // namespace halfspace
