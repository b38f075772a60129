#include "firmware/core/contour.hpp"

namespace halfspace {
namespace {

bool shade(const ShadeJob& job, Shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const bool done =
      sphere_contour(job, y, x0, x1) || straight_contour(job, y, x0, x1) || general_contour(job, y, x0, x1);
  if (done) job.counters.contour_dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
