#include "host/flatten/bound_form.hpp"

#include <algorithm>
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

BoundForm::BoundForm(const RealHalfSpace& shape) : is_plane_(shape.kind == HalfSpaceKind::plane) {
  for (std::size_t i = 0; i < 3; ++i) {
    g_[i] = static_cast<double>(is_plane_ ? shape.c[i] / 2 : shape.c[6 + i]);
    for (std::size_t j = 0; j < 3 && !is_plane_; ++j) a_[i][j] = static_cast<double>(shape.c[quadric_index[i][j]]);
  }
  k_ = static_cast<double>(shape.c[is_plane_ ? 3 : 9]);
  add_up();
}

void BoundForm::add_up() {
  for (std::size_t i = 0; i < 3; ++i) {
    linear_terms_ += 2 * std::abs(g_[i]);
    for (std::size_t j = 0; j < 3; ++j) square_terms_ += std::abs(a_[i][j]);
  }
}

// The homogeneous form of x, y, z and t with t in the place of the axis, which is `sign`. A plane's is k t + 2 g x.
BoundForm BoundForm::towards(std::size_t axis, double sign) const {
  const std::array<std::size_t, 2> aside{(axis + 1) % 3, (axis + 2) % 3};
  BoundForm far;
  far.is_plane_ = is_plane_;
  for (std::size_t i = 0; i < 2; ++i) {
    far.g_[i] = is_plane_ ? g_[aside[i]] : sign * a_[axis][aside[i]];
    for (std::size_t j = 0; j < 2; ++j) far.a_[i][j] = a_[aside[i]][aside[j]];
    if (!is_plane_) far.a_[i][2] = far.a_[2][i] = g_[aside[i]];
  }
  far.a_[2][2] = is_plane_ ? 0 : k_;
  far.g_[2] = is_plane_ ? k_ / 2 : sign * g_[axis];
  far.k_ = is_plane_ ? 2 * sign * g_[axis] : a_[axis][axis];
  far.add_up();
  return far;
}

ValueRange BoundForm::over(const CentredBox& cell) const {
  const auto& m = cell.middle;
  const auto& h = cell.half;
  double value = k_, low = 0, high = 0, reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double half_slope = g_[i];
    for (std::size_t j = 0; j < 3; ++j) {
      half_slope += a_[i][j] * m[j];
      if (j > i) high += 2 * std::abs(a_[i][j]) * h[i] * h[j];
    }
    value += m[i] * (half_slope + g_[i]);
    reach = std::max(reach, std::abs(m[i]) + h[i]);
  }
  low = -high;
  for (std::size_t i = 0; i < 3; ++i) {
    double slope = 2 * g_[i];
    for (std::size_t j = 0; j < 3; ++j) slope += 2 * a_[i][j] * m[j];
    low += least(a_[i][i], slope, h[i]);
    high -= least(-a_[i][i], slope, h[i]);
  }
  const double margin = rounding * ((square_terms_ * reach + linear_terms_) * reach + std::abs(k_));
  return {value + low - margin, value + high + margin, value + margin};
}

}  // namespace halfspace
