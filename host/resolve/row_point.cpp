#include "host/resolve/row_point.hpp"

#include <cmath>

namespace halfspace {
namespace {

constexpr double largest = 0x1p40;  // doubles up to here carry at least 12 bits after the point

bool is_small(const Interval& x) { return -largest < x.low && x.high < largest; }

}  // namespace

const LineRoot& RowPoint::exact() const {
  if (exact_) return *exact_;
  if (curve_ == nullptr) {
    exact_ = rational_root(mpz_class(near_.low * 0x1p10), 1 << 10);
  } else {
    exact_ = real_roots(restricted(*curve_, y_))[index_];
  }
  return *exact_;
}

void append_roots_on_row(const Curve& curve, const IntervalCurve& enclosed, std::int64_t y,
                         std::vector<RowPoint>& points) {
  const auto line = static_cast<double>(y);
  const auto sure = roots_in_x(enclosed, {line, line});
  if (!sure || sure->is_hull) {
    for (LineRoot& x : real_roots(restricted(curve, y))) points.emplace_back(std::move(x));
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(sure->count); ++i) points.emplace_back(curve, y, i, sure->x[i]);
}

int compare(const RowPoint& a, const RowPoint& b) {
  if (a.near().high < b.near().low) return -1;
  if (a.near().low > b.near().high) return 1;
  return compare(a.exact(), b.exact());
}

RowPoint point_between(const RowPoint& a, const RowPoint& b) {
  if (const auto x = short_number_between(a.near().high, b.near().low)) return RowPoint(*x);
  return RowPoint(rational_between(a.exact(), b.exact()));
}

RowPoint point_below(const RowPoint& x) {
  if (is_small(x.near())) return RowPoint(std::floor(x.near().low) - 1);
  return RowPoint(rational_root(floor_of(x.exact()) - 1, 1));
}

RowPoint point_above(const RowPoint& x) {
  if (is_small(x.near())) return RowPoint(std::ceil(x.near().high) + 1);
  return RowPoint(rational_root(ceiling_of(x.exact()) + 1, 1));
}

}  // namespace halfspace
