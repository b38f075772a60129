#include "firmware/core/contour.hpp"

namespace halfspace {
namespace {

ContourKind kind_of(const ShadeJob& job) {
  if (job.face.kind != FaceKind::root) return ContourKind::none;
  if (has_sphere_contours(job)) return ContourKind::sphere;
  if (!has_straight_contours(job)) return ContourKind::general;
  if (!job.contours->block.empty()) return ContourKind::straight;
  ++job.counters.crowded_faces;
  return ContourKind::general;
}

bool shade_by(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  switch (job.contours->kind) {
    case ContourKind::none:
      return false;
    case ContourKind::sphere:
      return sphere_contour(job, y, x0, x1) || general_contour(job, y, x0, x1);
    case ContourKind::straight:
      return straight_contour(job, y, x0, x1) || general_contour(job, y, x0, x1);
    default:
      return general_contour(job, y, x0, x1);
  }
}

bool shade(const ShadeJob& job, Shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (job.contours->kind == ContourKind::unknown) job.contours->kind = kind_of(job);
  const bool done = shade_by(job, y, x0, x1);
  if (done) job.counters.contour_dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
