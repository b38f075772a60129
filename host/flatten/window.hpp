// window.hpp - the view's window fitted into the device: view frame (world units) to page (dots).
//   page x = scale_x X + offset_x,   page y = scale_y Y + offset_y,   page z = scale_y Z
// One scale serves both axes after pixel aspect: scale_y = scale_x * (width / height of a dot).
#pragma once

#include <optional>

#include "host/flatten/extent.hpp"
#include "host/flatten/integer_scene.hpp"
#include "host/flatten/view.hpp"

namespace halfspace {

struct Device {
  std::int32_t width = 0, height = 0;  // dots
  Real aspect = 1;                     // width / height of a dot
};

struct PageMap {
  Real scale_x = 1, scale_y = 1;  // dots per world unit in the plane through vrp
  Real offset_x = 0, offset_y = 0;
  Scissor scissor;

  // Takes dot frame coordinates (page - 1/2 in x and y) to the view frame.
  [[nodiscard]] Matrix4 dot_to_view() const;
  [[nodiscard]] Box to_dots(const Box& view_box) const;
};

// A picture's extent is needed unless the view gives both half-sizes.
[[nodiscard]] inline bool needs_extent(const View& view) { return !view.half_width || !view.half_height; }

[[nodiscard]] PageMap fit_window(const View& view, const Device& device, const Box& extent);

}  // namespace halfspace
