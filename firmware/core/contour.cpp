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
  return is_surely_curved(job.face) ? ContourKind::general : ContourKind::almost_ruled;
}

ContourKind straight_or_general(const ShadeJob& job) {
  if (!has_straight_contours(job)) return ContourKind::general;
  if (job.contours->block.empty()) ++job.counters.crowded_faces;
  job.contours->kinked_line = kinked_line_of(job.face);
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

// To find out whether a face is ruled costs as much as some 70 dots: so it has to have ten times as many, or a span which shows that it
// will.
bool is_small_yet(FaceContours& face, std::uint32_t dots) {
  constexpr std::uint32_t least = 700;
  face.waited += dots;
  return face.waited < least && dots * dots < least;
}

bool is_kinked(const FaceContours& face, std::int32_t y) {
  return face.kinked_line == y || face.kinked_line == all_lines;
}

bool shade_by_general(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (shader != Shader::contour && !is_sparse(job, static_cast<std::uint32_t>(x1 - x0 + 1))) return false;
  return general_contour(job, y, x0, x1);
}

bool shade_by(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  switch (job.contours->kind) {
    case ContourKind::none:
    case ContourKind::almost_ruled:
      return false;
    case ContourKind::sphere:
      return sphere_contour(job, y, x0, x1) || shade_by_general(job, shader, y, x0, x1);
    case ContourKind::straight:
      return straight_contour(job, y, x0, x1) ||
             (!is_kinked(*job.contours, y) && shade_by_general(job, shader, y, x0, x1));
    default:
      return shade_by_general(job, shader, y, x0, x1);
  }
}

// As far as that pays.
void find_kind(const ShadeJob& job, Shader shader, std::uint32_t dots) {
  FaceContours& face = *job.contours;
  if (face.kind == ContourKind::unknown) face.kind = kind_of(job);
  if (face.kind == ContourKind::almost_ruled && (shader == Shader::contour || !is_small_yet(face, dots))) {
    face.kind = straight_or_general(job);
  }
}

bool shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const auto dots = static_cast<std::uint32_t>(x1 - x0 + 1);
  if (job.contours->kind <= ContourKind::almost_ruled) find_kind(job, shader, dots);
  const bool done = shade_by(job, shader, y, x0, x1);
  if (done) job.counters.contour_dots += dots;
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
