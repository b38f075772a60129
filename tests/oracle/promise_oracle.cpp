#include "tests/oracle/promise_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/oracle/solid_extent.hpp"

namespace halfspace::oracle {
namespace {

// Does a net of rays about the middle, from wide to narrow, meet a face?
bool shows_something(const TrueScene& scene) {
  const RayCaster<double> caster(scene, Fit{}, 0, 0, 2);  // a page of no size at one dot a unit
  constexpr int count = 97;
  for (int bits = 8; bits > -7; --bits) {
    const double reach = std::ldexp(1.0, bits);
    for (int i = 0; i < count * count; ++i) {
      const auto place = [&](int line) { return reach * (2 * (line + 0.5) / count - 1); };
      if (caster.shade(place(i % count), place(i / count))) return true;
    }
  }
  return false;
}

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

std::optional<Fit> fit_to_page(const TrueScene& scene, const IntegerScene& integers) {
  const std::optional<Real>& half_width = scene.view.half_width;
  const std::optional<Real>& half_height = scene.view.half_height;
  const Real width = integers.width, height = integers.height;
  Fit fit;
  if (half_width && half_height) {
    fit.scale = std::min(width / (Real(2) * *half_width), height / (Real(2) * *half_height));
    return fit;
  }
  if (!integers.extent) return std::nullopt;
  const auto& [low, high] = *integers.extent;
  if (!half_width) fit.u = (Real(low[0]) + Real(high[0])) / Real(2);
  if (!half_height) fit.v = -(Real(low[1]) + Real(high[1])) / Real(2);
  if (half_width) {
    fit.scale = width / (Real(2) * *half_width);
  } else if (half_height) {
    fit.scale = height / (Real(2) * *half_height);
  } else {
    const Real across = Real(high[0]) - Real(low[0]), down = Real(high[1]) - Real(low[1]);
    const bool by_width = across * height > down * width;
    if (by_width || !(down == Real(0))) fit.scale = by_width ? width / across : height / down;
  }
  return fit;
}

PromiseReport check_promise(const Scene& scene, const IntegerScene& integers, const std::vector<std::int16_t>& levels,
                            const PromiseOptions& options) {
  const TrueScene truth = true_scene(scene, options.view);
  PromiseReport report;
  const std::optional<Fit> fit = fit_to_page(truth, integers);
  report.wrong_extent = fit ? integers.extent && !is_extent_of_solids(truth, *integers.extent) : shows_something(truth);
  if (!fit) return report;
  const RayCaster<double> quick(truth, *fit, integers.width, integers.height, integers.levels);
  const RayCaster<Real> sure(truth, *fit, integers.width, integers.height, integers.levels);
  const double bound = std::clamp(integers.bound, least_bound, most_bound) + options.slack;

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
