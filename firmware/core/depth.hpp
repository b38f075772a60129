// depth.hpp - which of two faces is nearer along a run of dots, mostly without visiting them.
//
//   Restricted to a scan line a face is a straight line or one branch of a conic in (x, z), so its curvature
//   keeps one sign. Between three equally spaced dots a, m, b a face therefore lies between two straight
//   lines:
//       over [a, m]:  from min / max(f(a), 2 f(m) - f(b)) at a to f(m) at m        (and mirrored over [m, b])
//   If these strips of two faces do not overlap, their order is settled for the whole half run; otherwise the
//   half is halved again, down to single dots, which are decided exactly (exact.hpp).
// Cost    Proportional to the number of crossings times the logarithm of the run, not to the run's length.
// Memory  A stack of 34 runs: a run of at most 2^15 dots is halved at most 15 times, each leaving at most two
// behind. Source  Ressler 1985, 5.5.1 compares depths where an edge enters; interpenetrating bodies are not
// in the paper.
#pragma once

#include <cstdint>

#include "firmware/core/exact.hpp"
#include "firmware/core/face.hpp"

namespace halfspace {

// What drawing a page cost; counted on every target, shown by --stats.
struct Counters {
  std::uint32_t depth_samples = 0;  // z of a face at a dot (table 7.2, note 5)
  std::uint32_t exact_depths = 0;   // ... settled by exact arithmetic
  std::uint32_t face_inserts = 0;   // cells merged into a scan line (note 6)
  std::uint32_t edge_swaps = 0;     // exchanges while sorting the active list (note 7)
  std::uint32_t spans = 0;          // runs of one face handed to the shader (note 8)
  std::uint32_t intensities = 0;    // levels decided at a dot of a quadric (note 9)
  std::uint32_t exact_levels = 0;   // ... settled by exact arithmetic
  std::uint32_t contour_dots = 0;   // shaded dots of quadrics that contours levelled, none by itself
  std::uint32_t curved_faces = 0;   // quadrics that entered
  std::uint32_t crowded_faces = 0;  // ... that found no room for contours and went dot by dot
  std::uint32_t level_spans = 0;    // runs of one level handed to the band
  std::uint32_t dots = 0;           // shaded dots (note 10)
  std::uint32_t lines = 0;          // scan lines swept
};

// z in page dots, fixed point with depth_fraction bits; the true value lies within `error` of `z`.
struct DepthSample {
  std::int64_t z = 0;
  std::int64_t error = 0;  // negative: not representable, ask exactly
};
inline constexpr int depth_fraction = 16;

[[nodiscard]] DepthSample sample_depth(const ActiveFace& face, std::int32_t x, std::int32_t y);

// The order of two faces along the run a .. b of scan line y: next() gives maximal-effort pieces from left to
// right.
class DepthOrder {
 public:
  DepthOrder(const ActiveFace& f, const ActiveFace& g, std::int32_t y, std::int32_t a, std::int32_t b,
             const ExactModule& exact, Counters& counters);

  // The next piece: dots up to and including `end`, and whether f (else g) is the one to show there.
  struct Piece {
    std::int32_t end;
    bool first;
  };
  [[nodiscard]] bool done() const { return depth_ == 0; }
  Piece next();

 private:
  struct Run {
    std::int16_t a, b;
    std::int8_t known;  // -1: f shows, +1: g shows, 0: not settled yet
  };
  void push(std::int32_t a, std::int32_t b, int known);
  bool halve(const Run& run, Piece& piece);
  bool split_planes(const Run& run, Piece& piece);
  [[nodiscard]] int winner(int sign) const;
  [[nodiscard]] DepthSample sample(const ActiveFace& face, std::int32_t x);
  [[nodiscard]] int order_at(std::int32_t x);

  const ActiveFace& f_;
  const ActiveFace& g_;
  std::int32_t y_;
  const ExactModule& exact_;
  Counters& counters_;
  Run stack_[34];
  int depth_ = 0;
};

}  // namespace halfspace
