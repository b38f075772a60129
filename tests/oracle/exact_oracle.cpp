#include "tests/oracle/exact_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tests/oracle/ball.hpp"
#include "tests/oracle/exact_root.hpp"

namespace halfspace::oracle {
namespace {

struct BallForm {
  Ball a, b, c;
};

// A half-space with what does not change from dot to dot.
struct Surface {
  const IntegerHalfSpace* exact = nullptr;
  std::array<Ball, 10> c;
  bool quadratic = false;         // z^2 occurs
  int turn = 1;                   // the sign of its coefficient
  std::optional<int> flat_level;  // of a plane, once known

  // On the current scan line a z^2 + 2 (b0 + b1 x) z + c0 + (c1 + c2 x) x.
  Ball a, b0, b1, c0, c1, c2;
};

struct Solid {
  const IntegerBody* exact = nullptr;
  std::vector<Surface> surfaces;
  std::vector<BallForm> forms;  // of the current dot
};

// A surface point on the current ray.
struct Hit {
  int body = 0;
  int half_space = 0;
  int sheet = 0;
  Ball z;  // local
  Ball depth;
  mutable std::optional<ExactRoot> root;
};

Surface make_surface(const IntegerHalfSpace& half_space) {
  Surface surface;
  surface.exact = &half_space;
  std::transform(half_space.c.begin(), half_space.c.end(), surface.c.begin(),
                 [](const mpz_class& n) { return Ball::of(n); });
  surface.quadratic = half_space.kind == HalfSpaceKind::quadric && sgn(half_space.c[2]) != 0;
  surface.turn = surface.quadratic ? sgn(half_space.c[2]) : 1;
  return surface;
}

void start_line(Surface& s, const Ball& y) {
  const Ball two{2, 0};
  if (s.exact->kind == HalfSpaceKind::plane) {
    s.b0 = s.c[2];
    s.c0 = two * (s.c[1] * y + s.c[3]);
    s.c1 = two * s.c[0];
    return;
  }
  s.a = s.c[2];
  s.b0 = s.c[4] * y + s.c[8];
  s.b1 = s.c[5];
  s.c0 = (s.c[1] * y + two * s.c[7]) * y + s.c[9];
  s.c1 = two * (s.c[3] * y + s.c[6]);
  s.c2 = s.c[0];
}

class Sweep {
 public:
  Sweep(const IntegerScene& scene, const Options& options, Statistics& statistics)
      : scene_(scene), options_(options), statistics_(statistics) {
    for (const IntegerBody& body : scene.bodies) {
      Solid& solid = solids_.emplace_back();
      solid.exact = &body;
      for (const IntegerHalfSpace& h : body.half_spaces) solid.surfaces.push_back(make_surface(h));
      solid.forms.resize(solid.surfaces.size());
    }
  }

  void start_line(int y) {
    y_ = y;
    for (Solid& solid : solids_) {
      const Ball local = Ball::of(y - solid.exact->origin[1]);
      for (Surface& surface : solid.surfaces) oracle::start_line(surface, local);
    }
  }

  Dot decide(int x) {
    ++statistics_.dots;
    x_ = x;
    std::optional<Hit> best;
    for (std::size_t body = 0; body < solids_.size(); ++body) {
      if (options_.trust_boxes && outside_box(*solids_[body].exact)) continue;
      meet(static_cast<int>(body), best);
    }
    if (!best) return {};
    if (outside_box(*solids_[best->body].exact)) ++statistics_.outside_box;
    return {level(*best), best->body, best->half_space, best->sheet};
  }

 private:
  [[nodiscard]] bool outside_box(const IntegerBody& body) const {
    return x_ < body.x0 || x_ > body.x1 || y_ < body.y0 || y_ > body.y1;
  }

  [[nodiscard]] std::int64_t local_x(int body) const { return x_ - solids_[body].exact->origin[0]; }
  [[nodiscard]] std::int64_t local_y(int body) const { return y_ - solids_[body].exact->origin[1]; }

  [[nodiscard]] ExactForm exact_form(int body, int half_space) const {
    return restrict_to_ray(*solids_[body].surfaces[half_space].exact, local_x(body), local_y(body));
  }

  const ExactRoot& exact_root(const Hit& hit) const {
    if (!hit.root) hit.root = root_of(exact_form(hit.body, hit.half_space), hit.sheet);
    return *hit.root;
  }

  // The sign that the filter is sure of, or else the exact one.
  template <typename Exact>
  int settle(const Ball& filter, const Exact& exact) {
    ++statistics_.questions;
    if (options_.filter) {
      if (const std::optional<int> sign = filter.sign()) return *sign;
    }
    ++statistics_.exact;
    return exact();
  }

  // The body's nearest point on this ray, if nearer than the best.
  void meet(int body, std::optional<Hit>& best) {
    Solid& solid = solids_[body];
    const Ball x = Ball::of(local_x(body));
    for (std::size_t i = 0; i < solid.surfaces.size(); ++i) {
      const Surface& s = solid.surfaces[i];
      solid.forms[i] = {s.a, s.b0 + s.b1 * x, s.c0 + (s.c1 + s.c2 * x) * x};
      if (options_.filter && never_holds(s, solid.forms[i])) return;
    }
    for (std::size_t i = 0; i < solid.surfaces.size(); ++i) {
      if (!solid.surfaces[i].exact->transparent) meet_surface(body, static_cast<int>(i), best);
    }
  }

  // Surely positive (negative for a complement) on the whole ray.
  static bool never_holds(const Surface& s, const BallForm& form) {
    if (!s.quadratic || (s.turn > 0) == s.exact->complement) return false;
    return (form.b * form.b - form.a * form.c).sign() == -1;
  }

  void meet_surface(int body, int half_space, std::optional<Hit>& best) {
    const Surface& s = solids_[body].surfaces[half_space];
    const auto& [a, b, c] = solids_[body].forms[half_space];
    Hit hit{body, half_space, 0, {}, {}, {}};
    if (!s.quadratic) {
      if (settle(b, [&] { return sgn(exact_form(body, half_space).b); }) == 0) return;
      hit.z = -c / (b + b);
      consider(hit, best);
      return;
    }
    const Ball disc = b * b - a * c;
    const int real = settle(disc, [&] { return sgn(discriminant(exact_form(body, half_space))); });
    if (real < 0) return;
    const Ball reach = real == 0 ? Ball{} : sqrt(disc);
    hit.z = (s.turn > 0 ? -b - reach : -b + reach) / a;
    consider(hit, best);
    if (real == 0) return;
    hit.sheet = 1;
    hit.root.reset();
    hit.z = (s.turn > 0 ? -b + reach : -b - reach) / a;
    consider(hit, best);
  }

  void consider(Hit& hit, std::optional<Hit>& best) {
    hit.depth = hit.z + Ball::of(solids_[hit.body].exact->origin[2]);
    if (options_.filter && best && (hit.depth - best->depth).sign() == 1) return;
    if (!all_others_hold(hit)) return;
    if (best && !nearer(hit, *best)) return;
    best = hit;
  }

  bool all_others_hold(const Hit& hit) {
    const Solid& solid = solids_[hit.body];
    for (int i = 0; i < static_cast<int>(solid.surfaces.size()); ++i) {
      if (i == hit.half_space) continue;
      const auto& [a, b, c] = solid.forms[i];
      const Ball value = (a * hit.z + b + b) * hit.z + c;
      const int sign = settle(value, [&] { return sign_at(exact_form(hit.body, i), exact_root(hit)); });
      if (solid.surfaces[i].exact->complement ? sign < 0 : sign > 0) return false;
    }
    return true;
  }

  bool nearer(const Hit& hit, const Hit& best) {
    return settle(hit.depth - best.depth, [&] {
             return compare_depths(exact_root(hit), solids_[hit.body].exact->origin[2], exact_root(best),
                                   solids_[best.body].exact->origin[2]);
           }) < 0;
  }

  int level(const Hit& hit) {
    Surface& surface = solids_[hit.body].surfaces[hit.half_space];
    if (surface.exact->kind == HalfSpaceKind::quadric) return level_between(hit, level_filter(hit));
    if (!surface.flat_level) surface.flat_level = level_between(hit, {0, scene_.levels - 1});
    return *surface.flat_level;
  }

  struct LevelRange {
    int least, most;
  };

  // The largest level of the range that the hit reaches; it reaches the least one.
  int level_between(const Hit& hit, LevelRange range) {
    ++statistics_.questions;
    if (range.least == range.most) return range.least;
    ++statistics_.exact;
    const Solid& solid = solids_[hit.body];
    while (range.least < range.most) {
      const int middle = (range.least + range.most + 1) / 2;
      const bool reached = reaches_level(scene_, *solid.exact, *solid.surfaces[hit.half_space].exact, local_x(hit.body),
                                         local_y(hit.body), exact_root(hit), middle);
      (reached ? range.least : range.most) = reached ? middle : middle - 1;
    }
    return range.least;
  }

  [[nodiscard]] LevelRange level_filter(const Hit& hit) const {
    const int top = scene_.levels - 1;
    if (!options_.filter) return {0, top};
    const IntegerLighting& lighting = scene_.lighting;
    const Ball cosine = cosine_at(hit);
    const Ball lit = Ball::of(lighting.parallel) * cosine;
    const Ball intensity = (Ball::of(lighting.ambient) + lit) / Ball::of(lighting.unit);
    const Ball value = Ball::of(std::int64_t{top}) * intensity;
    if (!(value.e < 1e6)) return {0, top};
    const auto dark = static_cast<int>(top * lighting.ambient / lighting.unit);
    const auto clamp = [&](double v) { return static_cast<int>(std::clamp(std::floor(v), double(dark), double(top))); };
    return {clamp(value.lower()), clamp(value.upper())};
  }

  [[nodiscard]] Ball cosine_at(const Hit& hit) const {
    const Solid& solid = solids_[hit.body];
    const Surface& s = solid.surfaces[hit.half_space];
    const auto& c = s.c;
    const Ball x = Ball::of(local_x(hit.body));
    const Ball y = Ball::of(local_y(hit.body));
    std::array<Ball, 4> g = {c[0] * x + c[3] * y + c[5] * hit.z + c[6], c[3] * x + c[1] * y + c[4] * hit.z + c[7],
                             c[5] * x + c[4] * y + c[2] * hit.z + c[8], c[6] * x + c[7] * y + c[8] * hit.z + c[9]};
    for (int i = 0; i < 3; ++i) g[3] = g[3] - Ball::of(solid.exact->origin[i]) * g[i];
    Ball along, normal_length, light_length;
    for (int row = 0; row < 3; ++row) {
      Ball n;
      for (int column = 0; column < 4; ++column) {
        n = n + Ball::of(scene_.lighting.normal_matrix[row][column]) * g[column];
      }
      const Ball light = Ball::of(scene_.lighting.light[row]);
      along = along + light * n;
      normal_length = normal_length + n * n;
      light_length = light_length + light * light;
    }
    if (s.exact->complement) along = -along;
    return along / sqrt(normal_length * light_length);
  }

  const IntegerScene& scene_;
  const Options& options_;
  Statistics& statistics_;
  std::vector<Solid> solids_;
  int x_ = 0, y_ = 0;
};

}  // namespace

std::vector<Dot> explain(const IntegerScene& scene, int y0, int y1, const Options& options, Statistics* statistics) {
  Statistics unwanted;
  Sweep sweep(scene, options, statistics != nullptr ? *statistics : unwanted);
  std::vector<Dot> dots(static_cast<std::size_t>(scene.width) * std::max(0, y1 - y0));
  const int left = std::max(0, scene.scissor.x0);
  const int right = std::min(scene.width - 1, scene.scissor.x1);
  for (int y = std::max(y0, scene.scissor.y0); y < y1 && y <= scene.scissor.y1; ++y) {
    sweep.start_line(y);
    Dot* row = dots.data() + static_cast<std::size_t>(y - y0) * scene.width;
    for (int x = left; x <= right; ++x) row[x] = sweep.decide(x);
  }
  return dots;
}

std::vector<std::int16_t> draw(const IntegerScene& scene, int y0, int y1, const Options& options,
                               Statistics* statistics) {
  const std::vector<Dot> dots = explain(scene, y0, y1, options, statistics);
  std::vector<std::int16_t> levels(dots.size());
  std::transform(dots.begin(), dots.end(), levels.begin(),
                 [](const Dot& dot) { return static_cast<std::int16_t>(dot.level); });
  return levels;
}

}  // namespace halfspace::oracle
