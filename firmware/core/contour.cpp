#include "firmware/core/contour.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

ContourKind kind_of(const ShadeJob& job) {
  if (job.face.kind != FaceKind::root) {
    return has_polynomial_normal(job.face, job.lighting) ? ContourKind::general : ContourKind::none;
  }
  return has_constant_normal(job.face.surface) ? ContourKind::sphere : ContourKind::curved;
}

ContourKind straight_or_general(const ShadeJob& job) {
  if (has_wide_coefficients(job.face)) return ContourKind::none;
  if (!has_straight_contours(job.face)) return ContourKind::general;
  if (job.contours->block.empty()) ++job.counters.crowded_faces;
  return ContourKind::straight;
}

// Instructions of a Cortex-M3, or tenths of a nanosecond of an x86-64, which multiplies 64 bits at once (docs/contours.md). A span of n dots with
// r levels met from dot to dot takes  span + dot n + run min(r, n) + step r,  `span` beyond that of the way dot by dot.
struct Way {
  std::int64_t span, dot, run, step;

  [[nodiscard]] constexpr std::int64_t cost(std::int64_t n, std::int64_t r) const {
    return span + dot * n + run * std::min(r, n) + step * r;
  }
};
struct Ways {
  Way dot_by_dot, general, sphere;
};
constexpr Ways ways = limb_bits == 32 ? Ways{{0, 330, 55, 35}, {-3500, 30, 70, 95}, {-10200, 0, 0, 80}}
                                      : Ways{{0, 85, 70, 0}, {1000, 0, 0, 260}, {-1000, 0, 0, 50}};

// Whether contours are cheaper. The last span tells r / n, as far as each level is met twice; before there is one, it is met once.
bool is_sparse(const ShadeJob& job, std::uint32_t dots, const Way& way) {
  const FaceContours& face = *job.contours;
  const auto levels = static_cast<std::uint32_t>(job.table.top_level - job.table.ambient_level);
  const std::uint32_t steps = face.dots == 0 ? levels : std::min(dots * face.steps / face.dots, 2 * levels);
  return way.cost(dots, steps) < ways.dot_by_dot.cost(dots, steps);
}

// Of a face with straight contours.
bool has_corner(const ShadeJob& job, std::int32_t y, std::int32_t x) {
  if (job.contours->kind != ContourKind::straight) return false;
  std::int32_t& line = job.contours->corner_line;
  if (line == unknown_line) line = corner_line_of(job.face, x, y);
  return line == y || line == all_lines;
}

bool shade_by(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  FaceContours& face = *job.contours;
  const auto dots = static_cast<std::uint32_t>(x1 - x0 + 1);
  const auto pays = [&](const Way& way) { return shader == Shader::contour || is_sparse(job, dots, way); };
  if (face.kind == ContourKind::unknown) face.kind = kind_of(job);
  if (face.kind == ContourKind::none) return false;
  if (face.kind == ContourKind::sphere) {
    if (!pays(ways.sphere)) return false;
    if (face.sphere.fraction == 0 && !make_sphere(job, face.sphere)) face.kind = ContourKind::curved;
    if (face.kind == ContourKind::sphere && sphere_contour(job, y, x0, x1)) return true;
  }
  if (face.kind == ContourKind::curved) {
    if (!pays(ways.general) && !is_survey_due(job, dots)) {
      face.straight.waited += dots;
      return false;
    }
    face.kind = straight_or_general(job);
  }
  if (face.kind == ContourKind::none) return false;
  if (face.kind == ContourKind::straight && straight_contour(job, y, x0, x1)) return true;
  return pays(ways.general) && !has_corner(job, y, x0) && general_contour(job, y, x0, x1);
}

bool shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const bool done = shade_by(job, shader, y, x0, x1);
  if (done) job.counters.contour_dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
