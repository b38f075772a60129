// integer_scene.hpp - the scene as integers: from here on every dot is a mathematical fact.
//
// Page frame   x right, y down, z into the scene, all in dots; the ray of dot (i, j) is the line
//              (x, y) = (i + 1/2, j + 1/2), parallel to z. Smaller z is nearer.
// Local frame  Each body has an integer origin (ox, oy, oz). Local integer coordinates (x, y) name the CENTRE of dot
//              (ox + x, oy + y); local z = page z - oz. So a half-space is evaluated at integers only, and two
//              bodies' frames differ by an integer translation.
// Truth        The nearest face and the level of every dot are defined by these integers alone (tests/oracle).
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/diagnostic.hpp"

namespace halfspace {

enum class HalfSpaceKind : std::uint8_t { plane, quadric };

// plane    value = c0 x + c1 y + c2 z + c3
// quadric  value = c0 x^2 + c1 y^2 + c2 z^2 + 2 c3 xy + 2 c4 yz + 2 c5 xz + 2 c6 x + 2 c7 y + 2 c8 z + c9
//          (A B C D E F G H J K of Ressler 2.2), in the body's local frame.
// The half-space is value <= 0, or value >= 0 when `complement`. Its face is value = 0 where all the other
// half-spaces of the body hold; a transparent one has no face.
struct IntegerHalfSpace {
  HalfSpaceKind kind = HalfSpaceKind::plane;
  std::array<mpz_class, 10> c;
  bool complement = false;
  bool transparent = false;
  double bound = 0;  // dots: how far the surface may lie from the true one within the body's extent
  std::string name;
  SourcePosition position;
};

struct IntegerBody {
  std::string name;
  SourcePosition position;
  std::array<std::int64_t, 3> origin{};       // dots
  std::vector<IntegerHalfSpace> half_spaces;  // in the order of the body statement, clipping planes last
  // A box (page frame, dots; inclusive) around the body, or the scissor: where an oracle need not look. It is no part of the truth: which
  // dots show a face is decided by the half-spaces alone.
  std::int32_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};

// Intensity at a face point with outward world normal n:  (ambient + parallel * max(0, cos)) / unit, where
//   N = M g, g = (gx, gy, gz, gw) the homogeneous gradient of value (half of it for a quadric) in the dot-centre frame
//     (dot (i, j) at x = i, y = j; page z) with w = 1: gx, gy, gz are those of the local frame, gw(page) = gw(local) - (ox gx + oy gy + oz gz);
//     plane: g(local) = (c0, c1, c2, c3); quadric: gx = c0 x + c3 y + c5 z + c6, gy = c3 x + c1 y + c4 z + c7,
//     gz = c5 x + c4 y + c2 z + c8, gw = c6 x + c7 y + c8 z + c9 with x, y, z local;
//   cos = s (light . N) / (|light| |N|), s = -1 for a complement, else +1; where N = 0 cos counts as 0.
// Level k of N levels: the largest k <= levels - 1 with (levels - 1) * intensity >= k.
struct IntegerLighting {
  std::array<std::array<std::int64_t, 4>, 3> normal_matrix{};  // M: at most 2^24 in size, 2^15 without perspective
  std::array<std::int64_t, 3> light{};                         // at most 2^15 in size, not all zero
  std::int64_t ambient = 0, parallel = 0, unit = 1;            // 0 <= ambient, parallel <= unit <= 2^16
};

// Dots that bodies may show on: inclusive; everything outside is background (a window's letterbox).
struct Scissor {
  std::int32_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};

// The box of all solids in the view frame (right, down, into the scene; in world units), to which a window without both
// half-sizes is fitted.
struct PictureExtent {
  std::array<double, 3> low{}, high{};
};

struct IntegerScene {
  std::int32_t width = 0, height = 0;  // dots, 1 .. 32767
  std::int32_t levels = 2;             // 2 .. 256
  Scissor scissor;
  IntegerLighting lighting;
  std::vector<IntegerBody> bodies;      // flattened order: the first wins a tie
  double bound = 0;                     // dots: the largest of the half-spaces' bounds
  std::optional<PictureExtent> extent;  // where the view needs one and there are solids; no part of the truth
};

// Ties: of faces at the least depth the first body wins, then its first half-space, then the front sheet.
// A surface that contains the whole ray of a dot is not hit there.

}  // namespace halfspace
