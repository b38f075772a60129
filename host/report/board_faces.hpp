// board_faces.hpp - one face of each kind, alone on a page just large enough: what shaders are compared on.
// Size    `radius` dots: of the sphere and the cylinder, half the height of the others' cuts; the longest half axis of the ellipsoid.
// Light   One parallel light of intensity 1 and no ambient one, so that faces take on every level. A view is how the face is turned.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace halfspace {

struct BoardFace {
  const char* name;
  const char* quadric;  // of radius 1, its axis y
  const char* ends;     // planes that cut it: definitions
  const char* in_body;  // and their use
  double aim;           // instructions a dot on a Cortex-M3 at radius 500 and 65 levels, at most
};

inline constexpr std::array board_faces{
    BoardFace{"sphere", "1 1 1 0 0 0 0 0 0 -1", "", "", 7},
    BoardFace{"cylinder", "1 0 1 0 0 0 0 0 0 -.5", "plane t <0 1 0 -1>; plane b <0 -1 0 -1>;", "t b", 15},
    BoardFace{"cone", "1 -.36 1 0 0 0 0 -.36 0 -.36", "plane t <0 1 0 -1>; plane b <0 -1 0 -1>;", "t b", 15},
    BoardFace{"ellipsoid", "1 2.25 9 0 0 0 0 0 0 -1", "", "", 45},
    BoardFace{"paraboloid", "1.2 0 1 0 0 0 0 -.5 0 -.3", "plane t <0 1 0 -1>;", "t", 45},
    BoardFace{"hyperboloid, one sheet", "1 -.64 1.4 0 0 0 0 0 0 -.09", "plane t <0 1 0 -1>; plane b <0 -1 0 -1>;",
              "t b", 45},
    BoardFace{"hyperboloid, two sheets", "1 -.64 1.4 0 0 0 0 0 0 .09", "plane t <0 1 0 -1>; plane b <0 -1 0 -1>;",
              "t b", 45},
};

struct BoardView {
  const char* name;
  const char* turn;
  const char* light;
};

inline constexpr std::array board_views{
    BoardView{"tilted", "=rx 35 =rz 25", "-.5 .9 -.8"},
    BoardView{"steep", "=rx 70 =rz -40", ".6 .3 -.9"},
    BoardView{"grazing light", "=rx 35 =rz 25", ".9 .3 -.1"},
};

[[nodiscard]] std::string board_text(const BoardFace& face, const BoardView& view, std::int32_t radius);

}  // namespace halfspace
