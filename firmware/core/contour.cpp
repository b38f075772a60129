#include "firmware/core/contour.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

ContourKind kind_of(const ShadeJob& job) {
  if (job.face.kind != FaceKind::root) {
    return has_polynomial_normal(job.face, job.lighting) ? ContourKind::general : ContourKind::none;
  }
  if (has_sphere_contours(job)) return ContourKind::sphere;
  if (has_wide_coefficients(job.face)) return ContourKind::none;
  if (!has_straight_contours(job.face)) return ContourKind::general;
  if (job.contours->block.empty()) ++job.counters.crowded_faces;
  return ContourKind::straight;
}

// Instructions of a Cortex-M3 or tenths of a nanosecond of an x86-64, which multiplies 64 bits at once (docs/contours.md). A span of n dots with r
// levels met from dot to dot takes
//   dot n + run min(r, n)   dot by dot,   span + step r   more than that one's own set-up by general contours
struct Costs {
  std::uint32_t dot, run, span, step;
};
constexpr Costs costs = limb_bits == 32 ? Costs{330, 90, 2000, 200} : Costs{85, 70, 3000, 250};

// Whether general contours are cheaper. The last span tells r / n; before there is one, each level is met once.
bool is_sparse(const ShadeJob& job, std::uint32_t dots) {
  const FaceContours& face = *job.contours;
  const auto levels = static_cast<std::uint32_t>(job.table.top_level - job.table.ambient_level);
  const std::uint32_t steps = face.dots == 0 ? levels : dots * face.steps / face.dots;
  return costs.span + costs.step * steps < costs.dot * dots + costs.run * std::min(steps, dots);
}

// Of a face with straight contours.
bool has_corner(const ShadeJob& job, std::int32_t y, std::int32_t x) {
  if (job.contours->kind != ContourKind::straight) return false;
  std::int32_t& line = job.contours->corner_line;
  if (line == unknown_line) line = corner_line_of(job.face, x, y);
  return line == y || line == all_lines;
}

bool shade_by_general(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (shader != Shader::contour && !is_sparse(job, static_cast<std::uint32_t>(x1 - x0 + 1))) return false;
  return !has_corner(job, y, x0) && general_contour(job, y, x0, x1);
}

bool shade_by(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  switch (job.contours->kind) {
    case ContourKind::none:
      return false;
    case ContourKind::sphere:
      return sphere_contour(job, y, x0, x1) || shade_by_general(job, shader, y, x0, x1);
    case ContourKind::straight:
      return straight_contour(job, y, x0, x1) || shade_by_general(job, shader, y, x0, x1);
    default:
      return shade_by_general(job, shader, y, x0, x1);
  }
}

bool shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const auto dots = static_cast<std::uint32_t>(x1 - x0 + 1);
  if (job.contours->kind == ContourKind::unknown) job.contours->kind = kind_of(job);
  const bool done = shade_by(job, shader, y, x0, x1);
  if (done) job.counters.contour_dots += dots;
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
