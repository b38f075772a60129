#include "tests/oracle/solid_extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/oracle/parabolas.hpp"
#include "tests/oracle/ray_caster.hpp"

namespace halfspace::oracle {
namespace {

using Form = std::array<std::array<double, 4>, 4>;  // value = p form p^T, p = (x, y, z, 1) in the box's frame
using Solid = std::vector<Form>;

// The view frame is `middle` + `half` p, p in the box's frame, where the box is [-1, 1] along each axis; or 0, of which half the
// largest side is the unit.
struct BoxFrame {
  std::array<Real, 3> middle, half;
  std::array<double, 3> end{1, 1, 1};

  explicit BoxFrame(const PictureExtent& extent) {
    for (int i = 0; i < 3; ++i) {
      middle[i] = (Real(extent.low[i]) + Real(extent.high[i])) / Real(2);
      half[i] = (Real(extent.high[i]) - Real(extent.low[i])) / Real(2);
    }
    const Real largest = std::max({half[0], half[1], half[2]});
    for (int i = 0; i < 3; ++i) {
      if (!(half[i] == Real(0))) continue;
      end[i] = 0;
      half[i] = largest == Real(0) ? Real(1) : largest;
    }
  }

  [[nodiscard]] Matrix4 to_view() const {
    Matrix4 m;
    for (int i = 0; i < 3; ++i) {
      m[i][i] = half[i];
      m[3][i] = middle[i];
    }
    m[3][3] = 1;
    return m;
  }
};

Matrix4 matrix_of(const CastSurface<Real>& surface) {
  if (surface.is_quadric) return surface.quadric;
  Matrix4 m;
  for (int i = 0; i < 4; ++i) {
    m[i][3] += surface.plane[i] / Real(2);
    m[3][i] += surface.plane[i] / Real(2);
  }
  return m;
}

// With a largest coefficient of 1, negative inside.
Form form_of(const CastSurface<Real>& surface, const Matrix4& to_view) {
  const Matrix4 q = matrix_of(surface);
  Matrix4 moved;
  Real largest = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        for (int l = 0; l < 4; ++l) moved[i][j] += to_view[i][k] * q[k][l] * to_view[j][l];
      }
      largest = std::max(largest, abs(moved[i][j]));
    }
  }
  if (largest == Real(0)) largest = 1;
  if (surface.complement) largest = -largest;
  Form form;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) form[i][j] = (moved[i][j] / largest).to_double();
  }
  return form;
}

std::vector<Solid> solids_of(const TrueScene& scene, const BoxFrame& frame) {
  const Matrix4 to_view = frame.to_view();
  CastSurface<Real> before_eye;  // z <= 0
  before_eye.plane = {0, 0, 1, 0};
  // A page of no size at one dot a unit is the view frame.
  const RayCaster<Real> caster(scene, Fit{}, 0, 0, 2);
  std::vector<Solid> solids;
  for (const auto& body : caster.bodies()) {
    Solid& solid = solids.emplace_back();
    for (std::size_t i = 0; i + scene.clipping_planes < body.size(); ++i) solid.push_back(form_of(body[i], to_view));
    if (scene.view.perspective) solid.push_back(form_of(before_eye, to_view));
  }
  return solids;
}

// Along the rays, of the line where axis `axis` is `at` and the page's other one `across`.
double depth_of_line(const Solid& solid, int axis, double at, double across) {
  std::vector<Parabola> parabolas;
  const double x = axis == 0 ? at : across, y = axis == 0 ? across : at;
  for (const Form& f : solid) {
    parabolas.push_back({f[2][2], 2 * (f[2][0] * x + f[2][1] * y + f[2][3]),
                         (f[0][0] * x + 2 * (f[0][1] * y + f[0][3])) * x + (f[1][1] * y + 2 * f[1][3]) * y + f[3][3]});
  }
  return least_of_largest(parabolas);
}

// The most that the best point of the section leaves a half-space by; negative where it has an inside.
double depth_of_section(const Solid& solid, int axis, double at, int lines) {
  constexpr double reach = 1.25;
  const double step = reach / lines;
  std::vector<double> depths(static_cast<std::size_t>(2 * lines + 1));
  for (int i = -lines; i <= lines; ++i) depths[i + lines] = depth_of_line(solid, axis, at, step * i);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 2 * lines; ++i) {
    const bool is_minimum = (i == 0 || depths[i - 1] >= depths[i]) && (i == 2 * lines || depths[i + 1] >= depths[i]);
    if (!is_minimum) continue;
    double depth = depths[i], place = step * (i - lines);
    for (int halvings = 1; halvings <= 46; ++halvings) {
      const double width = std::ldexp(step, -halvings);
      for (const double across : {place - width, place + width}) {
        const double other = depth_of_line(solid, axis, at, across);
        if (other >= depth) continue;
        depth = other;
        place = across;
      }
    }
    least = std::min(least, depth);
  }
  return least;
}

bool side_holds(const std::vector<Solid>& solids, int axis, int side, double end) {
  const auto depth_at = [&](double at, int lines) {
    double least = std::numeric_limits<double>::infinity();
    for (const Solid& solid : solids) least = std::min(least, depth_of_section(solid, axis, side * at, lines));
    return least;
  };
  constexpr int coarse = 200, fine = 5000;  // a tip may lie beside a lesser minimum, between two lines
  if (depth_at(end, coarse) > touching && depth_at(end, fine) > touching) return false;
  static constexpr double beyond[] = {1e-4, 1e-3, 0.01, 0.1, 0.5, 2, 8};
  return std::none_of(std::begin(beyond), std::end(beyond),
                      [&](double d) { return depth_at(end + d, coarse) < -touching; });
}

}  // namespace

bool is_extent_of_solids(const TrueScene& scene, const PictureExtent& extent) {
  const BoxFrame frame(extent);
  const std::vector<Solid> solids = solids_of(scene, frame);
  const std::array<bool, 2> given = {scene.view.half_width.has_value(), scene.view.half_height.has_value()};
  for (const int axis : {0, 1}) {
    if (given[axis]) continue;
    for (const int side : {-1, 1}) {
      if (!side_holds(solids, axis, side, frame.end[axis])) return false;
    }
  }
  return true;
}

}  // namespace halfspace::oracle
