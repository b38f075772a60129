// random_bodies.hpp - bodies with small integer coefficients, near-degenerate on purpose.
//   Planes go through the apex of a cone, through one line, through one point, touch a sphere, coincide.
//   Quadrics are signed sums of squares of integer linear forms: every kind, with its rank exact.
//   No two quadrics of a body meet, but for random_meeting_body: they are shells q and q + k, or spheres further apart than their radii.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/oracle/dice.hpp"

namespace halfspace::oracle {

using Point = std::array<std::int64_t, 3>;

// value <= 0 in the order of scene.hpp (4 coefficients of a plane, 10 of a quadric), or >= 0 for a
// complement.
struct RandomHalfSpace {
  bool quadric = false;
  std::array<std::int64_t, 10> c{};
  bool complement = false;
  bool transparent = false;
};

using RandomBody = std::vector<RandomHalfSpace>;  // 1 .. 8 half-spaces, at most three of them quadrics

struct BodyWish {
  Point centre{};
  std::int64_t span = 4;  // half the size of what shows, in units
  bool bounded = false;   // for pictures that are fitted to the page: opaque, and no thin quadric, either
};

RandomBody random_body(Dice& dice, const BodyWish& wish);

// Two to four quadrics that do meet, mostly within one that bounds them, and up to two planes. A bounded one has some room inside:
// what is no thicker than a number that is moved by 1e-8 shows nowhere on a picture that is fitted to it.
RandomBody random_meeting_body(Dice& dice, const BodyWish& wish);

// The body with one half-space turned round: it mates with the first along that face.
RandomBody mate_of(Dice& dice, RandomBody body);

}  // namespace halfspace::oracle
