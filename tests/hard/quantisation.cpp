#include "tests/hard/quantisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/oracle/promise_oracle.hpp"
#include "tests/oracle/ray_caster.hpp"

namespace halfspace::testing {
namespace {

// How far the level of a dot lies from that of the true face at its centre; nothing when only one of the two shows a face.
std::optional<double> level_error(const std::optional<double>& truth, int level) {
  if (!truth && level < 0) return 0;
  if (!truth || level < 0) return std::nullopt;
  return std::max({0.0, level - *truth, *truth - (level + 1)});
}

// In doubles a level may be off by this where large products cancel: then 256 bits are asked.
constexpr double doubtful = 1e-4;

std::optional<double> to_double(const std::optional<oracle::Real>& shade) {
  return shade ? std::optional<double>(shade->to_double()) : std::nullopt;
}

bool found_within(const oracle::RayCaster<oracle::Real>& caster, double x, double y, int level, double radius) {
  if (caster.may_show(x, y, level, radius)) return true;
  constexpr double diagonal = 0.7071;  // a little inside the ring
  static constexpr std::array<std::array<double, 2>, 8> ring = {{{1, 0},
                                                                 {diagonal, diagonal},
                                                                 {0, 1},
                                                                 {-diagonal, diagonal},
                                                                 {-1, 0},
                                                                 {-diagonal, -diagonal},
                                                                 {0, -1},
                                                                 {diagonal, -diagonal}}};
  return std::any_of(ring.begin(), ring.end(), [&](const std::array<double, 2>& at) {
    return caster.may_show(x + radius * at[0], y + radius * at[1], level, radius);
  });
}

double least_radius(const oracle::RayCaster<oracle::Real>& caster, double x, double y, int level) {
  for (int bits = 20; bits >= 4; --bits) {
    const double radius = std::ldexp(1.0, -bits);
    if (found_within(caster, x, y, level, radius)) return radius;
  }
  return 1;
}

}  // namespace

void QuantisationError::extend(const QuantisationError& other) {
  bound = std::max(bound, other.bound);
  radius = std::max(radius, other.radius);
  levels = std::max(levels, other.levels);
}

QuantisationError quantisation_error(const Scene& scene, const IntegerScene& integers, const Levels& levels) {
  const oracle::TrueScene truth = oracle::true_scene(scene);
  const oracle::Fit fit = *oracle::fit_to_page(truth, integers);
  const oracle::RayCaster<double> quick(truth, fit, integers.width, integers.height, integers.levels);
  const oracle::RayCaster<oracle::Real> sure(truth, fit, integers.width, integers.height, integers.levels);
  QuantisationError error;
  error.bound = integers.bound;
  auto level = levels.begin();
  for (int row = 0; row < integers.height; ++row) {
    for (int column = 0; column < integers.width; ++column, ++level) {
      const double x = column + 0.5, y = row + 0.5;
      std::optional<double> off = level_error(quick.shade(x, y), *level);
      if (!off || *off > doubtful) off = level_error(to_double(sure.shade(x, y)), *level);
      if (off && *off <= 0.5) {
        error.levels = std::max(error.levels, *off);
      } else {
        error.radius = std::max(error.radius, least_radius(sure, x, y, *level));
      }
    }
  }
  return error;
}

}  // namespace halfspace::testing
