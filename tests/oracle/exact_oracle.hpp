// exact_oracle.hpp - every dot of an integer scene, decided by exact arithmetic alone.
// Truth   host/flatten/integer_scene.hpp and design.md, section 5. Nothing is shared with resolver or core.
// Method  Dot by dot and body by body: the surface points of each opaque half-space (at most two on a ray) at
// which
//         all other half-spaces of the body hold; the nearest wins, the first on a tie. A ball filter
//         (ball.hpp) answers most questions; GMP the rest, or all of them when `filter` is off.
// Cost    About 1 us for each dot and body.
#pragma once

#include <cstdint>
#include <vector>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::oracle {

struct Options {
  bool filter = true;        // off: GMP decides everything, some fifty times slower
  bool trust_boxes = false;  // skip a body outside its own box: only where another test vouches for the boxes
};

struct Statistics {
  std::uint64_t dots = 0;
  std::uint64_t questions = 0;    // signs asked for
  std::uint64_t exact = 0;        // of these, answered by GMP
  std::uint64_t outside_box = 0;  // visible dots outside the box of the body they show: must stay 0
};

struct Dot {
  int level = -1;  // 0 .. levels - 1; -1: background, and so the rest
  int body = -1;
  int half_space = -1;
  int sheet = -1;  // 0: the front or only one, 1: the back one

  friend bool operator==(const Dot&, const Dot&) = default;
};

// Scan lines y0 .. y1 - 1 of the page, row by row, width dots each.
std::vector<Dot> explain(const IntegerScene& scene, int y0, int y1, const Options& options = {},
                         Statistics* statistics = nullptr);

// The levels alone: -1 is background.
std::vector<std::int16_t> draw(const IntegerScene& scene, int y0, int y1, const Options& options = {},
                               Statistics* statistics = nullptr);

}  // namespace halfspace::oracle
