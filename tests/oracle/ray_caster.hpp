// ray_caster.hpp - the true scene along the ray of any page point, in doubles (quick) or at 256 bits (T = Real).
// Frame   (x, y) in dots, y down; z in dots: along the view's normal for a parallel view, and for a perspective one
//         z = -s f^2 / w with s dots for a unit, f the distance of vrp and w that of the point, both from the eye
//         along the normal. So rays are parallel to z, and what shows has z < 0.
// Forms   A half-space is moved into this frame by its matrix, at 256 bits, before anything is rounded to T.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "tests/oracle/true_scene.hpp"

namespace halfspace::oracle {

// Dots for a unit of the view plane, and the point of the plane, from vrp, in the page's middle.
struct Fit {
  Real scale = 1, u = 0, v = 0;
};

// Where a half-space's surface lies, and what it is.
template <typename T>
struct CastSurface {
  bool is_quadric = false, complement = false, transparent = false;
  std::array<T, 4> plane{}, world_plane{};
  std::array<std::array<T, 4>, 4> quadric{}, world_quadric{};
  T bend{};  // of the second order, at most, per dot squared
};

template <typename T>
using PagePoint = std::array<T, 3>;

// The highest level times the intensity, where the normal is not known: a range.
template <typename T>
struct Shade {
  T least{}, most{};
};

// Dots. The promise ends this far before vrp (docs/flatten.md): closer to the eye than a 2^20th of the window's distance.
inline constexpr int deepest = 1 << 20;

template <typename T>
class RayCaster {
 public:
  RayCaster(const TrueScene& scene, const Fit& fit, int width, int height, int levels);

  // Each body's half-spaces in this frame.
  [[nodiscard]] const std::vector<std::vector<CastSurface<T>>>& bodies() const { return bodies_; }

  // Of the nearest face; nothing for background.
  [[nodiscard]] std::optional<T> shade(const T& x, const T& y) const;

  // Whether some scene whose surfaces lie within `bound` dots of the true ones may show that level (-1:
  // background) on this ray, give or take half a level.
  [[nodiscard]] bool may_show(const T& x, const T& y, int level, const T& bound) const;

 private:
  struct Roots {
    int count = 0;
    std::array<T, 2> z;  // ascending
  };

  // A surface point, and how far along the ray it moves when its surface moves by the bound.
  struct Hit {
    T least, most;
    bool certain = true;
    Shade<T> shade;
  };

  using Surface = CastSurface<T>;
  using Body = std::vector<Surface>;

  static T convert(const Real& r) {
    if constexpr (std::is_same_v<T, Real>) {
      return r;
    } else {
      return r.to_double();
    }
  }
  static T at_least_zero(T t) { return t < T(0) ? T(0) : t; }

  void set_frame(const TrueView& view, const Fit& fit, int width, int height);
  Surface moved(const TrueHalfSpace& h) const;
  static Roots roots(const Surface& s, const T& x, const T& y, const T& shift);
  static T value(const Surface& s, const PagePoint<T>& p);
  static T slope(const Surface& s, const PagePoint<T>& p);
  [[nodiscard]] bool before_eye(const T& z) const { return perspective_ && !(z < T(0)); }
  [[nodiscard]] bool inside_window(const T& x, const T& y, const T& margin) const;
  [[nodiscard]] T intensity(const Surface& s, const PagePoint<T>& p) const;
  [[nodiscard]] std::optional<Hit> hit(const Body& body, const Surface& s, const PagePoint<T>& p, const T& bound) const;
  void add_hits(const Body& body, const T& x, const T& y, const T& bound, std::vector<Hit>& hits) const;

  bool perspective_ = false;
  Matrix4 exact_frame_;  // (x, y, z, 1) times this is the homogeneous world point
  std::array<std::array<T, 4>, 4> frame_;
  std::array<T, 4> window_;  // x0, y0, x1, y1 in dots
  std::vector<Body> bodies_;
  std::array<T, 3> light_;
  T ambient_, parallel_, top_;
};

template <typename T>
RayCaster<T>::RayCaster(const TrueScene& scene, const Fit& fit, int width, int height, int levels)
    : perspective_(scene.view.perspective),
      ambient_(convert(scene.light.ambient)),
      parallel_(convert(scene.light.parallel)),
      top_(levels - 1) {
  set_frame(scene.view, fit, width, height);
  for (int i = 0; i < 3; ++i) light_[i] = convert(scene.light.direction[i]);
  for (const TrueBody& body : scene.bodies) {
    Body& to = bodies_.emplace_back();
    for (const TrueHalfSpace& h : body) to.push_back(moved(h));
  }
}

template <typename T>
void RayCaster<T>::set_frame(const TrueView& view, const Fit& fit, int width, int height) {
  const Real half_x = Real(width) / Real(2), half_y = Real(height) / Real(2);
  Real along = 0;  // of the ray, or of vrp from the eye, on the normal
  for (int i = 0; i < 3; ++i) {
    along += view.normal[i] * (view.perspective ? view.vrp[i] - view.eye[i] : view.ray[i]);
  }
  for (int i = 0; i < 3; ++i) {
    exact_frame_[0][i] = view.right[i] / fit.scale;
    exact_frame_[1][i] = -view.up[i] / fit.scale;
    exact_frame_[2][i] = (view.perspective ? -view.eye[i] : view.ray[i]) / (fit.scale * along);
    exact_frame_[3][i] = view.vrp[i] + (fit.u - half_x / fit.scale) * view.right[i] +
                         (fit.v + half_y / fit.scale) * view.up[i] - (view.perspective ? view.eye[i] : Real(0));
  }
  exact_frame_[2][3] = view.perspective ? Real(-1) / (fit.scale * along) : Real(0);
  exact_frame_[3][3] = view.perspective ? 0 : 1;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) frame_[i][j] = convert(exact_frame_[i][j]);
  }

  const Real far = 1e9;
  const Real reach_x = view.half_width ? *view.half_width * fit.scale : far;
  const Real reach_y = view.half_height ? *view.half_height * fit.scale : far;
  const Real centre_x = half_x - fit.u * fit.scale, centre_y = half_y + fit.v * fit.scale;
  window_ = {convert(centre_x - reach_x), convert(centre_y - reach_y), convert(centre_x + reach_x),
             convert(centre_y + reach_y)};
}

// Entries that are zero but for rounding (of 256 bits) become zero: they decide whether z^2 and z occur at all.
inline void clear_noise(Matrix4& m) {
  Real largest = 0;
  for (const Vector4& row : m) {
    for (const Real& n : row) largest = std::max(largest, abs(n));
  }
  for (Vector4& row : m) {
    for (Real& n : row) n = abs(n) < largest * Real(0x1p-200) ? Real(0) : n;
  }
}

// A half-space has either form; the other one is zero.
template <typename T>
CastSurface<T> RayCaster<T>::moved(const TrueHalfSpace& h) const {
  Matrix4 half, quadric, plane;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      plane[0][i] += exact_frame_[i][j] * h.plane[j];
      for (int k = 0; k < 4; ++k) half[i][j] += exact_frame_[i][k] * h.quadric[k][j];
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) quadric[i][j] += half[i][k] * exact_frame_[j][k];
    }
  }
  clear_noise(quadric);
  clear_noise(plane);

  Surface s{h.is_quadric, h.complement, h.transparent, {}, {}, {}, {}, {}};
  Real bend = 0;
  for (int i = 0; i < 4; ++i) {
    s.plane[i] = convert(plane[0][i]);
    s.world_plane[i] = convert(h.plane[i]);
    for (int j = 0; j < 4; ++j) {
      s.quadric[i][j] = convert(quadric[i][j]);
      s.world_quadric[i][j] = convert(h.quadric[i][j]);
      if (i < 3 && j < 3) bend += quadric[i][j] * quadric[i][j];
    }
  }
  s.bend = convert(sqrt(bend));
  return s;
}

// Where value + shift = 0 on the ray.
template <typename T>
auto RayCaster<T>::roots(const Surface& s, const T& x, const T& y, const T& shift) -> Roots {
  using std::sqrt;
  if (!s.is_quadric) {
    if (s.plane[2] == T(0)) return {};
    return {1, {-(s.plane[0] * x + s.plane[1] * y + s.plane[3] + shift) / s.plane[2], T(0)}};
  }
  const auto& q = s.quadric;
  const T& a = q[2][2];
  const T b = q[2][0] * x + q[2][1] * y + q[2][3];
  const T c = (q[0][0] * x + T(2) * (q[0][1] * y + q[0][3])) * x + (q[1][1] * y + T(2) * q[1][3]) * y + q[3][3] + shift;
  if (a == T(0)) {
    if (b == T(0)) return {};
    return {1, {-c / (T(2) * b), T(0)}};
  }
  const T disc = b * b - a * c;
  if (disc < T(0)) return {};
  const T sum = b < T(0) ? -b + sqrt(disc) : -b - sqrt(disc);  // no cancellation
  if (sum == T(0)) return {1, {T(0), T(0)}};
  const T one = sum / a, other = c / sum;
  return {2, {std::min(one, other), std::max(one, other)}};
}

template <typename T>
T RayCaster<T>::value(const Surface& s, const PagePoint<T>& p) {
  const std::array<T, 4> h = {p[0], p[1], p[2], T(1)};
  T sum = 0;
  for (int i = 0; i < 4; ++i) {
    T row = s.is_quadric ? T(0) : s.plane[i];
    if (s.is_quadric) {
      for (int j = 0; j < 4; ++j) row += s.quadric[i][j] * h[j];
    }
    sum += row * h[i];
  }
  return s.complement ? T(-sum) : sum;
}

// The length of the gradient, per dot.
template <typename T>
T RayCaster<T>::slope(const Surface& s, const PagePoint<T>& p) {
  using std::sqrt;
  T sum = 0;
  for (int i = 0; i < 3; ++i) {
    T g = s.plane[i];
    if (s.is_quadric)
      g = T(2) * (s.quadric[i][0] * p[0] + s.quadric[i][1] * p[1] + s.quadric[i][2] * p[2] + s.quadric[i][3]);
    sum += g * g;
  }
  return sqrt(sum);
}

template <typename T>
bool RayCaster<T>::inside_window(const T& x, const T& y, const T& margin) const {
  return x >= window_[0] - margin && y >= window_[1] - margin && x <= window_[2] + margin && y <= window_[3] + margin;
}

template <typename T>
T RayCaster<T>::intensity(const Surface& s, const PagePoint<T>& p) const {
  using std::sqrt;
  std::array<T, 4> world{};
  for (int j = 0; j < 4; ++j) world[j] = p[0] * frame_[0][j] + p[1] * frame_[1][j] + p[2] * frame_[2][j] + frame_[3][j];
  T along = 0, length = 0;
  for (int i = 0; i < 3; ++i) {
    T n = s.world_plane[i];
    if (s.is_quadric) {
      n = 0;
      for (int j = 0; j < 4; ++j) n += s.world_quadric[i][j] * world[j];
    }
    along += n * light_[i];
    length += n * n;
  }
  if (s.complement) along = -along;
  T sum = ambient_;
  if (along > T(0)) sum += parallel_ * along / sqrt(length);
  return std::min(sum, T(1));
}

template <typename T>
std::optional<T> RayCaster<T>::shade(const T& x, const T& y) const {
  if (!inside_window(x, y, T(0))) return std::nullopt;
  const Surface* best = nullptr;
  PagePoint<T> nearest{};
  for (const Body& body : bodies_) {
    for (const Surface& s : body) {
      if (s.transparent) continue;
      const Roots r = roots(s, x, y, T(0));
      for (int i = 0; i < r.count; ++i) {
        if (before_eye(r.z[i]) || (best != nullptr && r.z[i] >= nearest[2])) continue;
        const PagePoint<T> p = {x, y, r.z[i]};
        const auto holds = [&](const Surface& other) { return &other == &s || value(other, p) <= T(0); };
        if (!std::all_of(body.begin(), body.end(), holds)) continue;
        best = &s;
        nearest = p;
      }
    }
  }
  if (best == nullptr) return std::nullopt;
  return top_ * intensity(*best, nearest);
}

// What a surface point counts for when its own surface may move by the bound, and the others, seen from it, by
// twice that; nothing where even so it is no face.
template <typename T>
auto RayCaster<T>::hit(const Body& body, const Surface& s, const PagePoint<T>& p, const T& bound) const
    -> std::optional<Hit> {
  using std::abs;
  Hit result{p[2], p[2], true, {}};
  const T steep = slope(s, p);
  const T moves = steep * bound + s.bend * bound * bound;
  for (const T& shift : {moves, T(-moves)}) {
    const Roots r = roots(s, p[0], p[1], shift);
    if (r.count == 0) {
      result.certain = false;
      continue;
    }
    // The root of the same sheet is the nearer one.
    const bool last = r.count == 2 && abs(r.z[1] - p[2]) < abs(r.z[0] - p[2]);
    result.least = std::min(result.least, r.z[last ? 1 : 0]);
    result.most = std::max(result.most, r.z[last ? 1 : 0]);
  }
  const T apart = T(2) * bound;
  for (const Surface& other : body) {
    if (&other == &s) continue;
    const T margin = slope(other, p) * apart + other.bend * apart * apart;
    const T v = value(other, p);
    if (v > margin) return std::nullopt;
    if (v > -margin) result.certain = false;
  }
  const bool next_to_the_eye = perspective_ && p[2] < T(-deepest);
  if (next_to_the_eye) result.certain = false;
  const bool normal_known = steep > T(8) * s.bend * bound && !next_to_the_eye;
  result.shade.least = top_ * (normal_known ? intensity(s, p) : std::min(ambient_, T(1)));
  result.shade.most = normal_known ? result.shade.least : T(top_ * std::min(T(ambient_ + parallel_), T(1)));
  return result;
}

template <typename T>
void RayCaster<T>::add_hits(const Body& body, const T& x, const T& y, const T& bound, std::vector<Hit>& hits) const {
  using std::abs;
  for (const Surface& s : body) {
    if (s.transparent) continue;
    Roots r = roots(s, x, y, T(0));
    const bool misses = r.count == 0 && s.is_quadric && !(s.quadric[2][2] == T(0));
    if (misses) {  // the ray passes the limb, perhaps within the bound: where it is nearest
      const auto& row = s.quadric[2];
      r = {1, {-(row[0] * x + row[1] * y + row[3]) / row[2], T(0)}};
    }
    for (int i = 0; i < r.count; ++i) {
      const PagePoint<T> p = {x, y, r.z[i]};
      if (misses) {
        const T moves = slope(s, p) * bound + s.bend * bound * bound;
        if (abs(value(s, p)) > moves) continue;
      }
      std::optional<Hit> found = hit(body, s, p, bound);
      if (!found || before_eye(found->least)) continue;
      // A surface beside the horizon may lie before the eye plane or behind it.
      if (misses || before_eye(found->most)) found->certain = false;
      hits.push_back(*found);
    }
  }
}

template <typename T>
bool RayCaster<T>::may_show(const T& x, const T& y, int level, const T& bound) const {
  if (level < 0 && !inside_window(x, y, -bound)) return true;
  if (level >= 0 && !inside_window(x, y, bound)) return false;
  std::vector<Hit> hits;
  for (const Body& body : bodies_) add_hits(body, x, y, bound, hits);
  std::optional<T> limit;  // no face behind it shows
  for (const Hit& h : hits) {
    if (h.certain && (!limit || h.most < *limit)) limit = h.most;
  }
  if (level < 0) return !limit;
  const T least = T(level) - T(0.5), most = T(level) + T(1.5);
  return std::any_of(hits.begin(), hits.end(), [&](const Hit& h) {
    return (!limit || h.least <= *limit) && h.shade.most >= least && h.shade.least <= most;
  });
}

}  // namespace halfspace::oracle
