#include "tests/oracle/promise_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace::oracle {
namespace {

// --- The extent of a picture, sampled from within; empty if nothing or no end was found.

struct Extent {
  double least[2] = {1e300, 1e300};  // u, v on the view plane
  double most[2] = {-1e300, -1e300};
  double least_at[2] = {}, most_at[2] = {};  // the other coordinate there

  [[nodiscard]] bool found() const { return least[0] <= most[0]; }
};

class ExtentSearch {
 public:
  // A page of no size at one dot a unit: x is u, and y is -v.
  explicit ExtentSearch(const TrueScene& scene) : caster_(scene, Fit{}, 0, 0, 2) {}

  Extent run() {
    double width = 0;
    for (double reach = 256; reach > 0.01 && !extent_.found(); reach /= 2) {
      net(reach, 97);
      width = reach / 32;
    }
    if (!extent_.found()) return extent_;
    for (int step = 0; step < 30; ++step, width /= 2) {
      for (const int axis : {0, 1}) {
        for (const int side : {-1, 1}) {
          if (!push_out(axis, side, width)) return {};
        }
      }
    }
    return extent_;
  }

 private:
  void probe(double u, double v) {
    if (!caster_.shade(u, -v)) return;
    const double p[2] = {u, v};
    for (int i = 0; i < 2; ++i) {
      if (p[i] < extent_.least[i]) {
        extent_.least[i] = p[i];
        extent_.least_at[i] = p[1 - i];
      }
      if (p[i] > extent_.most[i]) {
        extent_.most[i] = p[i];
        extent_.most_at[i] = p[1 - i];
      }
    }
  }

  void net(double reach, int count) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        probe(reach * (2 * (i + 0.5) / count - 1), reach * (2 * (j + 0.5) / count - 1));
      }
    }
  }

  // Strips of that width beyond one edge of the extent, as long as the edge moves. False: it seems to have no end.
  bool push_out(int axis, int side, double width) {
    const double& edge = side < 0 ? extent_.least[axis] : extent_.most[axis];
    const double& tip = side < 0 ? extent_.least_at[axis] : extent_.most_at[axis];
    for (int strip = 0; strip < 64; ++strip) {
      const double before = edge, middle = tip;
      const double from = extent_.least[1 - axis] - width;
      const double size = extent_.most[1 - axis] + width - from;
      for (int i = 1; i <= 4; ++i) {
        const double out = before + side * width * i / 4;
        for (int j = 0; j <= 64; ++j) probe_at(axis, out, from + size * j / 64);
        for (int j = -48; j <= 48; ++j) probe_at(axis, out, middle + width * j / 16);
      }
      if (edge == before) return true;
    }
    return false;
  }

  void probe_at(int axis, double out, double along) { axis == 0 ? probe(out, along) : probe(along, out); }

  RayCaster<double> caster_;
  Extent extent_;
};

// --- The check.

bool level_fits(const std::optional<double>& truth, int level) {
  if (!truth || level < 0) return !truth && level < 0;
  return *truth >= level - 0.5 && *truth <= level + 1.5;
}

bool found_nearby(const RayCaster<Real>& caster, double x, double y, int level, double bound) {
  constexpr double diagonal = 0.70710678118654746;  // a little inside the ring
  static constexpr double ring[8][2] = {{1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
                                        {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
  if (caster.may_show(x, y, level, bound)) return true;
  for (const double radius : {bound / 2, bound}) {
    for (const auto& [dx, dy] : ring) {
      if (caster.may_show(x + radius * dx, y + radius * dy, level, bound)) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Fit> fit_to_page(const TrueScene& scene, int width, int height) {
  const std::optional<Real>& half_width = scene.view.half_width;
  const std::optional<Real>& half_height = scene.view.half_height;
  Fit fit;
  if (half_width && half_height) {
    fit.scale = std::min(Real(width) / (Real(2) * *half_width), Real(height) / (Real(2) * *half_height));
    return fit;
  }
  const Extent extent = ExtentSearch(scene).run();
  if (!extent.found()) return std::nullopt;
  if (!half_width) fit.u = (extent.least[0] + extent.most[0]) / 2;
  if (!half_height) fit.v = (extent.least[1] + extent.most[1]) / 2;
  if (half_width) {
    fit.scale = Real(width) / (Real(2) * *half_width);
  } else if (half_height) {
    fit.scale = Real(height) / (Real(2) * *half_height);
  } else {
    fit.scale = std::min(width / (extent.most[0] - extent.least[0]), height / (extent.most[1] - extent.least[1]));
  }
  return fit;
}

PromiseReport check_promise(const Scene& scene, const IntegerScene& integers, const std::vector<std::int16_t>& levels,
                            const PromiseOptions& options) {
  const TrueScene truth = true_scene(scene, options.view);
  PromiseReport report;
  report.fitted = !truth.view.half_width || !truth.view.half_height;
  const std::optional<Fit> fit = fit_to_page(truth, integers.width, integers.height);
  if (!fit) return report;
  const RayCaster<double> quick(truth, *fit, integers.width, integers.height, integers.levels);
  const RayCaster<Real> sure(truth, *fit, integers.width, integers.height, integers.levels);
  const double bound =
      std::clamp(integers.bound, least_bound, most_bound) + options.slack + (report.fitted ? fit_slack : 0);

  for (int y = 0; y < integers.height; y += options.stride) {
    for (int x = 0; x < integers.width; x += options.stride) {
      ++report.dots;
      const int level = levels[static_cast<std::size_t>(y) * integers.width + x];
      const std::optional<double> centre = quick.shade(x + 0.5, y + 0.5);
      if (level_fits(centre, level)) continue;
      ++report.searched;
      if (found_nearby(sure, x + 0.5, y + 0.5, level, bound)) continue;
      report.broken.push_back({x, y, level, centre.value_or(-1)});
      if (report.broken.size() >= options.enough) return report;
    }
  }
  return report;
}

}  // namespace halfspace::oracle
