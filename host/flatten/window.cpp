#include "host/flatten/window.hpp"

namespace halfspace {
namespace {

// The first and last dot of an axis whose centres lie within `half` of the page's middle, both ends included: 2^-60
// dot is the rounding of a border that runs through dot centres.
void clip_axis(std::int32_t dots, Real half, std::int32_t& first, std::int32_t& last) {
  const Real middle = (Real(dots) - 1) / 2;
  const Real reach = smaller(half + power_of_two(-60), dots);
  first = static_cast<std::int32_t>(larger(0, -floor_of(reach - middle)));
  last = static_cast<std::int32_t>(smaller(dots - 1, floor_of(middle + reach)));
}

// The scale that fits both sizes into the device; 1 dot for a picture without size.
Real fitting_scale(const Device& device, Real width, Real height) {
  const Real across = device.width * device.aspect;
  if (width == 0 && height == 0) return 1;
  if (width == 0) return device.height / height;
  if (height == 0) return across / width;
  return smaller(across / width, device.height / height);
}

}  // namespace

Matrix4 PageMap::dot_to_view() const {
  const Real half = Real(1) / 2;
  return {{{1 / scale_x, 0, 0, 0},
           {0, 1 / scale_y, 0, 0},
           {0, 0, 1 / scale_y, 0},
           {(half - offset_x) / scale_x, (half - offset_y) / scale_y, 0, 1}}};
}

Box PageMap::to_dots(const Box& view_box) const {
  const Real half = Real(1) / 2;
  const auto map = [&](const Vector3& p) {
    return Vector3{p[0] * scale_x + offset_x - half, p[1] * scale_y + offset_y - half, p[2] * scale_y};
  };
  return {map(view_box.low), map(view_box.high)};
}

PageMap fit_window(const View& view, const Device& device, const Box& extent) {
  PageMap map;
  Vector3 centre{};
  Real scale = 1;
  if (view.half_width && view.half_height) {
    scale = fitting_scale(device, 2 * *view.half_width, 2 * *view.half_height);
  } else if (view.half_width) {
    scale = fitting_scale(device, 2 * *view.half_width, 0);
    centre[1] = (extent.low[1] + extent.high[1]) / 2;
  } else if (view.half_height) {
    scale = fitting_scale(device, 0, 2 * *view.half_height);
    centre[0] = (extent.low[0] + extent.high[0]) / 2;
  } else {
    scale = fitting_scale(device, extent.high[0] - extent.low[0], extent.high[1] - extent.low[1]);
    centre = scaled(sum(extent.low, extent.high), Real(1) / 2);
  }
  map.scale_y = scale;
  map.scale_x = scale / device.aspect;
  map.offset_x = Real(device.width) / 2 - centre[0] * map.scale_x;
  map.offset_y = Real(device.height) / 2 - centre[1] * map.scale_y;
  map.scissor = {0, 0, device.width - 1, device.height - 1};
  if (view.half_width && view.half_height) {
    clip_axis(device.width, *view.half_width * map.scale_x, map.scissor.x0, map.scissor.x1);
    clip_axis(device.height, *view.half_height * map.scale_y, map.scissor.y0, map.scissor.y1);
  }
  return map;
}

}  // namespace halfspace
