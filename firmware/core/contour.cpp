#include "firmware/core/contour.hpp"

namespace halfspace {
namespace {

ContourKind kind_of(const ShadeJob& job) {
  if (job.face.kind != FaceKind::root) return ContourKind::none;
  if (has_sphere_contours(job)) return ContourKind::sphere;
  if (has_wide_coefficients(job.face)) return ContourKind::none;
  if (!has_straight_contours(job)) return ContourKind::general;
  if (job.contours->block.empty()) ++job.counters.crowded_faces;
  return ContourKind::straight;
}

// What a span by general contours costs more than dot by dot: so much itself and a run, and so much less a dot. Only the proportions
// count.
struct Costs {
  std::uint32_t span, run, dot;
};
// Instructions of a Cortex-M3 and nanoseconds of an x86-64 (docs/contours.md), which multiplies 64 bits at once: there a root at every
// dot costs less beside all the rest.
constexpr Costs costs = limb_bits == 32 ? Costs{200, 11, 33} : Costs{60, 4, 2};

// Whether that is cheaper. The last span tells the runs a dot; before there is one, each level is met once.
bool is_sparse(const ShadeJob& job, std::uint32_t dots) {
  const FaceContours& face = *job.contours;
  const auto levels = static_cast<std::uint32_t>(job.table.top_level - job.table.ambient_level);
  std::uint32_t runs = face.dots == 0 ? levels : dots * face.runs / face.dots;
  if (face.by_dots) runs += runs / 4;  // one can stand for several levels that change between two dots
  return costs.run * runs + costs.span < costs.dot * dots;
}

bool shade_by(const ShadeJob& job, bool general, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  switch (job.contours->kind) {
    case ContourKind::none:
      return false;
    case ContourKind::sphere:
      return sphere_contour(job, y, x0, x1) || (general && general_contour(job, y, x0, x1));
    case ContourKind::straight:
      return straight_contour(job, y, x0, x1) ||
             (general && !is_kinked(job.face, y) && general_contour(job, y, x0, x1));
    default:
      return general && general_contour(job, y, x0, x1);
  }
}

bool shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (job.contours->kind == ContourKind::unknown) job.contours->kind = kind_of(job);
  const bool general = shader == Shader::contour || is_sparse(job, static_cast<std::uint32_t>(x1 - x0 + 1));
  const bool done = shade_by(job, general, y, x0, x1);
  job.contours->by_dots = !done;
  if (done) job.counters.contour_dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
