#include "host/resolve/depth_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace halfspace {
namespace {

constexpr long widest = 400;  // bits between two coefficients: products of four of them and of dots stay normal doubles
constexpr double precision = 0x1p-44;
constexpr DepthInterval everywhere{};
constexpr DepthInterval nowhere{1, 0};

// c0 .. c9 of a quadric, negative inside, as multiples of one number; false: too far apart. They may all be 0.
bool scaled(const IntegerHalfSpace& half_space, std::array<double, 10>& c) {
  const bool is_plane = half_space.kind == HalfSpaceKind::plane;
  std::array<double, 10> mantissa{};
  std::array<long, 10> exponent{};
  long most = std::numeric_limits<long>::min(), least = std::numeric_limits<long>::max();
  for (std::size_t i = 0; i < (is_plane ? 4 : 10); ++i) {
    const mpz_class& value = half_space.c[i];
    if (sgn(value) == 0) continue;
    const std::size_t at = is_plane ? i + 6 : i;
    mantissa[at] = mpz_get_d_2exp(&exponent[at], value.get_mpz_t());
    if (is_plane && i < 3) mantissa[at] /= 2;
    most = std::max(most, exponent[at]);
    least = std::min(least, exponent[at]);
  }
  if (most > least && most - least > widest) return false;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (mantissa[i] == 0) continue;
    const double value = std::ldexp(mantissa[i], static_cast<int>(exponent[i] - most));
    c[i] = half_space.complement ? -value : value;
  }
  return true;
}

struct Known {
  double value = 0, error = 0;
};

// A value that is right to `precision`.
DepthInterval around(double low, double high) {
  return {low - precision * std::abs(low), high + precision * std::abs(high)};
}

}  // namespace

DepthForm::DepthForm(const IntegerHalfSpace& half_space, double largest_x, double largest_y) {
  std::array<double, 10> c{};
  if (!scaled(half_space, c)) return;
  const double a = c[2];
  kind_ = a == 0 ? Kind::flat : a > 0 ? Kind::between : Kind::beyond;
  if (a != 0) {
    for (double& value : c) value /= std::abs(a);
  }
  const double sign = a > 0 ? -1 : 1;  // of b: -b / a is between the roots
  b_ = {sign * c[5], sign * c[4], sign * c[8]};
  b_.margin = precision * (std::abs(b_.x) * largest_x + std::abs(b_.y) * largest_y + std::abs(b_.k));
  const Linear root = a == 0 ? Linear{} : b_;
  const double factor = a == 0 ? 1 : sign;
  q_ = {root.x * root.x + factor * c[0], root.x * root.y + factor * c[3], root.y * root.y + factor * c[1],
        root.x * root.k + factor * c[6], root.y * root.k + factor * c[7], root.k * root.k + factor * c[9]};
  const double of_root = std::abs(root.x) * largest_x + std::abs(root.y) * largest_y + std::abs(root.k);
  const double of_rest = (std::abs(c[0]) * largest_x + 2 * (std::abs(c[3]) * largest_y + std::abs(c[6]))) * largest_x +
                         (std::abs(c[1]) * largest_y + 2 * std::abs(c[7])) * largest_y + std::abs(c[9]);
  q_.margin = precision * (of_root * of_root + of_rest);
}

// 2 b z + c <= 0
HoldingDepths DepthForm::on_one_side(const DepthInterval& b, const DepthInterval& c) {
  const auto at = [](double free, double slope) { return around(-free / (2 * slope), -free / (2 * slope)); };
  HoldingDepths bounds;
  if (b.low > 0) {
    bounds.may.high = std::max(at(c.low, b.low).high, at(c.low, b.high).high);
    bounds.must.high = std::min(at(c.high, b.low).low, at(c.high, b.high).low);
  } else if (b.high < 0) {
    bounds.may.low = std::min(at(c.low, b.low).low, at(c.low, b.high).low);
    bounds.must.low = std::max(at(c.high, b.low).high, at(c.high, b.high).high);
  } else {
    const bool is_edge_on = b.low == 0 && b.high == 0;
    if (is_edge_on && c.low > 0) bounds.may = nowhere;
    if (!is_edge_on || c.high > 0) bounds.must = nowhere;
  }
  return bounds;
}

HoldingDepths DepthForm::over(const DotRectangle& dots) const {
  if (kind_ == Kind::unknown) return {everywhere, nowhere, nowhere};
  const DepthInterval q = q_.over(dots);
  if (kind_ == Kind::between && q.high < 0) return {nowhere, nowhere, nowhere};
  if (kind_ == Kind::beyond && q.high < 0) return {};
  const DepthInterval b = b_.over(dots);
  if (kind_ == Kind::flat) return on_one_side(b, q);
  const double most = std::sqrt(q.high) * (1 + precision);
  const DepthInterval outer = around(b.low - most, b.high + most);
  if (kind_ == Kind::beyond) return {everywhere, everywhere, outer};
  if (q.low < 0) return {outer, nowhere, nowhere};
  const double least = std::sqrt(q.low) * (1 - precision);
  const double low = b.high - least, high = b.low + least;
  return {outer, {low + precision * std::abs(low), high - precision * std::abs(high)}, nowhere};
}

// In the window d, as it is held here, is above -margin wherever the half-space holds: an ellipse, where its second-order part is negative
// definite. Two products of the determinant cancel to 2^-20 at worst, so that quotients are right to 2^-30 of their terms.
DotRectangle DepthForm::silhouette() const {
  constexpr double least_determinant = 0x1p-20, slack = 0x1p-28;
  const double determinant = q_.xx * q_.yy - q_.xy * q_.xy;
  if (kind_ != Kind::between || q_.xx >= 0 || determinant <= least_determinant * q_.xx * q_.yy) {
    return {0, 0, no_bound, no_bound};
  }
  const auto difference = [determinant](double u, double v) {
    return Known{(u - v) / determinant, slack * (std::abs(u) + std::abs(v)) / determinant};
  };
  const Known x = difference(q_.xy * q_.y, q_.yy * q_.x);
  const Known y = difference(q_.xy * q_.x, q_.xx * q_.y);
  const double highest = q_.x * x.value + q_.y * y.value + q_.k + q_.margin + std::abs(q_.x) * x.error +
                         std::abs(q_.y) * y.error + slack * std::abs(q_.k);
  const auto half = [&](double other, double error) {
    return std::sqrt(std::max(-other * highest, 0.0) / determinant) * (1 + slack) + error;
  };
  return {x.value, y.value, half(q_.yy, x.error), half(q_.xx, y.error)};
}

}  // namespace halfspace
