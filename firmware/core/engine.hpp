// engine.hpp - a job in, bands out: the core's one loop over the scan lines.
//
//   job bytes -> records entering on this line -> arcs stepped -> cells' dots -> visible spans -> levels ->
//   band
//
// Memory  All of it is lent by the caller and carved once, after the header: fixed pools, no heap. A job that
// does not
//         fit is refused before the first dot, with what it needs and what there is.
// Errors  Returned as a status; after any but `ok` the page is incomplete.
// Cost    A line costs its arcs' sideways movement, its cells and its shaded dots; nothing depends on the
// scene's size. Source  Ressler 1985, chapters 5 and 6: edge start list, active edge list, face stacks; here
// cells replace the stacks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/core/arc.hpp"
#include "firmware/core/contour.hpp"
#include "firmware/core/depth.hpp"
#include "firmware/core/exact.hpp"
#include "firmware/core/job_reader.hpp"
#include "firmware/core/shade.hpp"

namespace halfspace {

// What a firmware can do: a null entry is left out of the program.
struct Modules {
  std::array<const ArcModule*, arc_kinds> arcs{};        // by ArcKind
  std::array<const ExactModule*, exact_widths> exact{};  // narrow to wide
  const FaceModule* root = nullptr;                      // quadrics with z^2
  const FaceModule* rational = nullptr;                  // quadrics without
  const ContourModule* contours = nullptr;               // left out: every face goes dot by dot, with the same picture
};
extern const Modules all_modules;

inline constexpr std::int32_t default_stride = 8;

struct DrawOptions {
  Shader shader = Shader::automatic;
  std::int32_t stride =
      default_stride;           // of Shader::stride: at most so many dots from one level to the next, at least 1
  std::int32_t band_rows = 16;  // preferred; fewer where memory is short
  bool measure = false;         // visibility only: no shading, no bands; for the host's sweep in advance
};

enum class DrawStatus : std::uint8_t {
  ok,
  not_a_job,       // magic, version or header
  bad_record,      // a record is malformed or the job ends early
  missing_module,  // the job needs an arc kind, a face kind or a width this firmware leaves out
  does_not_fit,    // memory: see need and have, in bytes
  too_many_spans,  // a scan line has more spans than the header says: need is at least have + 1
  stopped,         // the band sink refused a band
};

struct DrawResult {
  DrawStatus status = DrawStatus::ok;
  std::int64_t need = 0, have = 0;
  std::int32_t line = 0;        // the scan line reached
  std::int32_t peak_spans = 0;  // of the fullest line
  std::int32_t band_rows = 0;   // as used
  Counters counters;
};

// Bytes of memory that a job needs with bands of `band_rows` lines.
[[nodiscard]] std::size_t memory_needed(const JobHeader& header, std::int32_t band_rows);
// The same with room for the contours of every face. Any memory in between serves as many faces as it holds.
[[nodiscard]] std::size_t memory_wanted(const JobHeader& header, std::int32_t band_rows);

// Draws the job whose header `in` has just delivered. `memory` must be aligned to 8 bytes.
[[nodiscard]] DrawResult draw(JobReader& in, const JobHeader& header, BandSink& sink, std::span<std::byte> memory,
                              const DrawOptions& options, const Modules& modules);

// The same from a job's first byte.
[[nodiscard]] DrawResult draw(ByteSource& job, BandSink& sink, std::span<std::byte> memory, const DrawOptions& options,
                              const Modules& modules);

}  // namespace halfspace
