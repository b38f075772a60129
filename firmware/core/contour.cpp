#include "firmware/core/contour.hpp"

namespace halfspace {

bool shade_by_contours(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  return sphere_contour(job, y, x0, x1) || straight_contour(job, y, x0, x1) || general_contour(job, y, x0, x1);
}

}  // namespace halfspace
