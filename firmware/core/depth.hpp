// depth.hpp - which of two faces is nearer along a run of dots, mostly without visiting them.
//
//   Restricted to a scan line a face is a straight line or one branch of a conic in (x, z), so its curvature keeps one sign.
//   Between dots a < m < b a face therefore lies between two straight lines:
//       over [a, m]:  from f(a), or from the chord of [m, b] produced to a, to f(m) at m        (and mirrored over [m, b])
//   If these strips of two faces do not overlap, their order is settled for the whole half run; otherwise the half is halved
//   again, down to single dots, which are decided exactly (exact.hpp). Two sheets of one surface tie everywhere.
// Cost    Proportional to the number of crossings times the logarithm of the run, not to the run's length.
//   Where the order differs at a and b, the two dots m, m + 1 between which it changes are sought; then m is the middle and the other dot
//   of both lines. Two conics cross four times at most.
// Memory  A stack of 19 runs: one of at most 2^15 dots is halved at most 14 times, down to two dots, cut at a crossing four times, and
//         leaves one behind each time.
// Source  Ressler 1985, 5.5.1 compares depths where an edge enters; interpenetrating bodies are not in the paper.
#pragma once

#include <cstdint>

#include "firmware/core/depth_block.hpp"
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
  std::uint32_t level_steps = 0;    // levels between neighbouring dots, where a quadric goes dot by dot
  std::uint32_t dots = 0;           // shaded dots (note 10)
  std::uint32_t lines = 0;          // scan lines swept
};

// z in page dots, fixed point with depth_fraction bits; the true value lies within `error` of `z`.
struct DepthSample {
  std::int64_t z = 0;
  std::int64_t error = 0;  // negative: not representable, ask exactly
};

// A face on one line, where it exists. Planes and root faces need a block that holds it.
//   plane, root   z = (-b + sheet sqrt(D)) / c2 by the block's forms
//   rational      z = -c / (2 b), dot by dot
class DepthLine {
 public:
  DepthLine(const ActiveFace& face, std::int32_t y);
  [[nodiscard]] DepthSample at(std::int32_t x) const;

 private:
  const ActiveFace& face_;
  std::int32_t y_;                       // page, rational: local
  std::int64_t b_ = 0, d_ = 0, dx_ = 0;  // the block's forms at its first dot of the line
};

// Makes the face's block hold dots a .. b of line y. A rational face's bounds are from three samples and good for the line alone.
void bound_depth(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b, Counters& counters);

// The same, at the cost of a look where it does already.
[[nodiscard]] inline const DepthBlock& bounded(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b,
                                               Counters& counters) {
  if (!face.block.holds(y, a, b)) bound_depth(face, y, a, b, counters);
  return face.block;
}

// Two faces at a dot.
struct DepthPair {
  std::int32_t x = -1;
  DepthSample f, g;
};

// The dot of a .. b of line y from which on g is nearer where f is before, or f where g is, as the turn of their proof says, which holds them:
// a or b + 1 where one is on all. -1: it cannot be told.
[[nodiscard]] std::int32_t find_turn(const ActiveFace& f, const ActiveFace& g, DepthProof& proof, std::int32_t y,
                                     std::int32_t a, std::int32_t b, Counters& counters);

// The order of two faces, whose blocks hold the run, along the run a .. b of scan line y: next() gives maximal-effort pieces from left to
// right.
class DepthOrder {
 public:
  // `proof` is what is known of them; it takes where their order changes.
  DepthOrder(const ActiveFace& f, const ActiveFace& g, DepthProof& proof, std::int32_t y, std::int32_t a,
             std::int32_t b, const ExactModule& exact, Counters& counters);

  // The next piece: dots up to and including `end`, and whether f (else g) is the one to show there.
  struct Piece {
    std::int32_t end;
    bool first;
  };
  [[nodiscard]] bool done() const { return depth_ == 0; }
  Piece next();

 private:
  static constexpr int most_crossings = 4;  // of two conics

  struct Run {
    std::int16_t a, b;
    std::int8_t known;  // -1: f shows, +1: g shows, 0: not settled yet
  };
  enum class Step : std::uint8_t { settled, halved, none };

  void push(std::int32_t a, std::int32_t b, int known);
  [[nodiscard]] std::int32_t next_guess(const DepthPair& left, const DepthPair& right, int step) const;
  Step cross(const Run& run, Piece& piece);
  Step halve(const Run& run, Piece& piece);
  Step settle_by_ends(const Run& run, Piece& piece);
  [[nodiscard]] int winner(int sign) const;
  [[nodiscard]] int winner_at(std::int32_t x);
  [[nodiscard]] bool one_surface();
  [[nodiscard]] DepthPair sample(std::int32_t x);

  const ActiveFace& f_;
  const ActiveFace& g_;
  DepthProof& proof_;
  std::int32_t guess_;  // where the order changed on the last line that asked
  DepthLine f_line_, g_line_;
  std::int32_t y_;
  const ExactModule& exact_;
  Counters& counters_;
  DepthPair recent_[3];  // a halved run's: half of it asks for two of them again
  bool compared_ = false, one_surface_ = false;
  int crossings_ = most_crossings;  // that may still be sought
  Run stack_[15 + most_crossings];
  int depth_ = 0;
};

}  // namespace halfspace
