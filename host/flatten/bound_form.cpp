#include "host/flatten/bound_form.hpp"

#include <cmath>

namespace halfspace {
namespace {

constexpr double rounding = 0x1p-44;

// The least value of a d^2 + b d where |d| <= h.
double least(double a, double b, double h) {
  const bool turns = a > 0 && std::abs(b) < 2 * a * h;
  return turns ? -b * b / (4 * a) : a * h * h - std::abs(b) * h;
}

}  // namespace

BoundForm::BoundForm(const RealHalfSpace& shape) {
  const bool is_plane = shape.kind == HalfSpaceKind::plane;
  for (std::size_t i = 0; i < 3; ++i) {
    g_[i] = static_cast<double>(is_plane ? shape.c[i] / 2 : shape.c[6 + i]);
    for (std::size_t j = 0; j < 3 && !is_plane; ++j) a_[i][j] = static_cast<double>(shape.c[quadric_index[i][j]]);
  }
  k_ = static_cast<double>(shape.c[is_plane ? 3 : 9]);
}

ValueRange BoundForm::over(const Cell& cell) const {
  const auto& m = cell.middle;
  const auto& h = cell.half;
  double value = k_, size = std::abs(k_), low = 0, high = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double half_slope = g_[i];
    double half_slope_size = std::abs(g_[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      half_slope += a_[i][j] * m[j];
      half_slope_size += std::abs(a_[i][j]) * (std::abs(m[j]) + h[j]);
      if (j > i) high += 2 * std::abs(a_[i][j]) * h[i] * h[j];
    }
    value += m[i] * (half_slope + g_[i]);
    size += (std::abs(m[i]) + h[i]) * (half_slope_size + std::abs(g_[i]));
  }
  low = -high;
  for (std::size_t i = 0; i < 3; ++i) {
    double slope = 2 * g_[i];
    for (std::size_t j = 0; j < 3; ++j) slope += 2 * a_[i][j] * m[j];
    low += least(a_[i][i], slope, h[i]);
    high -= least(-a_[i][i], slope, h[i]);
  }
  const double margin = rounding * size;
  return {value + low - margin, value + high + margin, value + margin};
}

}  // namespace halfspace
