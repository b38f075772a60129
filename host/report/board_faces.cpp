#include "host/report/board_faces.hpp"

#include <fmt/format.h>

namespace halfspace {

// One unit of the window is a dot, and the centre lies off the dots' own.
std::string board_text(const BoardFace& face, const BoardView& view, std::int32_t radius) {
  return fmt::format(
      "definition face; quadric q <{}>; {} body (q {}); enddef;\n"
      "instance (face =sa {} {} =tx .3125 =ty .4375);\n"
      "light 1 {};\nview dop 0 0 -1 whw {} whh {};\n",
      face.quadric, face.ends, face.in_body, radius, view.turn, view.light, radius + 3, radius + 3);
}

}  // namespace halfspace
