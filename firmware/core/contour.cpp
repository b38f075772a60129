#include "firmware/core/contour.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

ContourKind kind_of(const ShadeJob& job) {
  if (job.face.kind != FaceKind::root) {
    return has_polynomial_normal(job.face, job.lighting) ? ContourKind::general : ContourKind::curved;
  }
  if (has_wide_coefficients(job.face)) return ContourKind::none;
  return has_constant_normal(job.face.surface) ? ContourKind::sphere : ContourKind::curved;
}

ContourKind straight_or_general(const ShadeJob& job) {
  if (!has_straight_contours(job.face)) return ContourKind::general;
  if (job.contours->block.empty()) ++job.counters.crowded_faces;
  return ContourKind::straight;
}

// Instructions of a Cortex-M3, or ticks of an x86-64, which multiplies 64 bits at once (docs/contours.md). A span of n dots with r levels
// met from dot to dot takes
//   span + first min(n, 16) + dot n + chord min(r, n / 4, 16) + run min(r, n) + crowd max(r - n, 0)
struct Way {
  std::int32_t span, first, dot, chord, run, crowd;

  [[nodiscard]] constexpr std::int32_t cost(std::int32_t n, std::int32_t r) const {
    const std::int32_t chords = std::min(r, std::min<std::int32_t>(n / 4, 16));
    return span + first * std::min<std::int32_t>(n, 16) + dot * n + chord * chords + run * std::min(r, n) +
           crowd * std::max<std::int32_t>(r - n, 0);
  }
};
struct Ways {
  Way dot_by_dot, general, sphere, straight;
  std::int32_t general_start, sphere_start;  // once a face
  std::int32_t survey, survey_level;         // and of straight contours, so much a level besides
  std::int32_t skip;                         // of an entry of straight contours that does not show
  std::int32_t step;                         // of general contours
};
constexpr Ways cortex_m3{{5200, 0, 285, 0, 200, 23},
                         {700, 170, 10, 250, 100, 13},
                         {650, 0, 0, 0, 110, 110},
                         {400, 0, 0, 0, 44, 44},
                         12000,
                         15500,
                         50000,
                         1520,
                         12,
                         230};
constexpr Ways x86_64{{150, 29, 18, 0, 25, 3},
                      {450, 0, 3, 90, 45, 2},
                      {140, 0, 0, 0, 18, 18},
                      {80, 0, 0, 0, 5, 5},
                      1000,
                      1500,
                      4600,
                      350,
                      2,
                      45};
constexpr const Ways& ways = limb_bits == 32 ? cortex_m3 : x86_64;

// Levels that n dots of the face meet, at the last span's rate, as far as each is met twice; before there is one, each is met once.
std::int32_t levels_met(const ShadeJob& job, std::int32_t n) {
  const FaceContours& face = *job.contours;
  const auto levels = static_cast<std::uint32_t>(job.table.top_level - job.table.ambient_level);
  if (n > 1 && face.gaps == 0) return static_cast<std::int32_t>(levels);
  const auto gaps = static_cast<std::uint32_t>(n - 1);
  return static_cast<std::int32_t>(std::min(gaps * face.steps / std::max<std::uint32_t>(face.gaps, 1), 2 * levels));
}

std::int32_t dot_by_dot_cost(Shader shader, std::int32_t n, std::int32_t r) {
  return shader == Shader::contour ? std::numeric_limits<std::int32_t>::max() : ways.dot_by_dot.cost(n, r);
}

struct Costs {
  std::int32_t r;  // levels met
  std::int32_t dot_by_dot, general, straight;

  Costs(const ShadeJob& job, Shader shader, std::int32_t n) : r(levels_met(job, n)) {
    dot_by_dot = dot_by_dot_cost(shader, n, r);
    const std::int32_t edges = job.painter.edges_of(r);          // the only levels that are looked for
    general = ways.general.cost(n, std::min(r, 7 * edges / 4));  // by chords instead of tracks they take 7/4 as much
    general += job.contours->dear;
    straight = ways.straight.cost(n, edges) + ways.skip * r;
  }
};

// Whether to begin with a way that saves so much on this span of the face and takes `start` once: if as much as on all its spans
// would be saved on the lines that it has left.
bool is_begun(FaceContours& face, std::int32_t lines, std::int32_t gain, std::int32_t start) {
  face.begun.add(std::max<std::int32_t>(gain, 0));
  return gain > 0 && face.begun.pays(lines, start);
}

// Of a face with straight contours.
bool has_corner(const ShadeJob& job, std::int32_t y, std::int32_t x) {
  if (job.contours->kind != ContourKind::straight) return false;
  std::int32_t& line = job.contours->corner_line;
  if (line == unknown_line) line = corner_line_of(job.face, x, y);
  return line == y || line == all_lines;
}

// How many lines to come a span of n dots tells of: a narrow one of few.
std::int32_t lines_told(const ShadeJob& job, std::int32_t y, std::int32_t n) {
  return std::min(lines_left(job.face, y), 4 * n);
}

// A sphere's contours cost less than other ones of its levels would. False: it goes dot by dot, unless it is no longer a sphere.
bool shade_sphere(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  FaceContours& face = *job.contours;
  const std::int32_t n = x1 - x0 + 1;
  const std::int32_t r = levels_met(job, n);
  const std::int32_t gain = dot_by_dot_cost(shader, n, r) - ways.sphere.cost(n, job.painter.edges_of(r));
  if (gain <= 0) return false;
  if (face.sphere.fraction == 0) {
    if (!is_begun(face, lines_told(job, y, n), gain, ways.sphere_start)) return false;
    if (!make_sphere(job, face.sphere)) face.kind = ContourKind::curved;
  }
  return face.kind == ContourKind::sphere && sphere_contour(job, y, x0, x1);
}

constexpr std::int32_t chosen_lines = 8;

// By the way that was the cheapest a few lines above: of those whose set-up is done.
bool shade_as_chosen(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (job.contours->kind == ContourKind::sphere) return sphere_contour(job, y, x0, x1);
  return straight_contour(job, y, x0, x1);
}

bool shade_by(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  FaceContours& face = *job.contours;
  if (face.kind == ContourKind::unknown) face.kind = kind_of(job);
  if (face.kind == ContourKind::none) return false;
  if (y < face.chosen_until && shade_as_chosen(job, y, x0, x1)) return true;
  if (face.kind == ContourKind::sphere) {
    const bool done = shade_sphere(job, shader, y, x0, x1);
    if (done) face.chosen_until = y + chosen_lines;
    if (done || face.kind == ContourKind::sphere) return done;
  }
  face.dear -= face.dear / 4;
  const std::int32_t n = x1 - x0 + 1;
  const std::int32_t lines = lines_told(job, y, n);
  const Costs costs(job, shader, n);
  bool pays = costs.general < costs.dot_by_dot;
  if (face.general.bars.error == 0) {
    pays = is_begun(face, lines, costs.dot_by_dot - costs.general, ways.general_start);
  }
  const SurveyChance survey{std::max<std::int32_t>(std::min(costs.general, costs.dot_by_dot) - costs.straight, 0),
                            ways.survey + ways.survey_level * std::min(2 * costs.r + 8, job.table.levels)};
  const bool by_rulings = survey.gain > 0 && face.kind != ContourKind::general;
  if (by_rulings && face.kind == ContourKind::straight && straight_contour(job, y, x0, x1)) {
    face.straight.missed += chosen_lines * survey.gain / 2;
    face.chosen_until = y + chosen_lines;
    return true;
  }
  const bool due = by_rulings && is_survey_due(face.straight, lines, survey);
  if (face.kind == ContourKind::curved) {
    if (!pays && !due) return false;
    face.kind = straight_or_general(job);
  }
  if (due && face.kind == ContourKind::straight && surveyed_contour(job, y, x0, x1)) return true;
  if (!pays || has_corner(job, y, x0) || !general_contour(job, y, x0, x1)) return false;
  // Where it is dear, as near an apex, it is for some lines.
  face.dear = ways.general.span + ways.step * face.general.steps - (costs.general - face.dear);
  return true;
}

bool shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const bool done = shade_by(job, shader, y, x0, x1);
  if (done) job.counters.contour_dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

}  // namespace

const ContourModule all_contours{&shade};

}  // namespace halfspace
