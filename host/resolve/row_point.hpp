// row_point.hpp - a point of one scan line: an interval around it, and the exact number when that is asked for.
// Most questions are settled by the interval; the integers of line_root.hpp are only made where two points come close.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/resolve/interval_curve.hpp"
#include "host/resolve/line_root.hpp"

namespace halfspace {

class RowPoint {
 public:
  explicit RowPoint(LineRoot exact) : near_(exact.near), exact_(std::move(exact)) {}
  // Root `index` of the curve on scan line y, which lies in `near`. Keeps a pointer to the curve.
  RowPoint(const Curve& curve, std::int64_t y, std::size_t index, const Interval& near)
      : near_(near), curve_(&curve), y_(y), index_(index) {}
  // A multiple of 2^-10 below 2^40.
  explicit RowPoint(double x) : near_{x, x} {}

  [[nodiscard]] const Interval& near() const { return near_; }
  [[nodiscard]] const LineRoot& exact() const;

 private:
  Interval near_;
  const Curve* curve_ = nullptr;
  std::int64_t y_ = 0;
  std::size_t index_ = 0;
  mutable std::optional<LineRoot> exact_;
};

// Appends the real roots of a curve on a scan line, ascending, a double root once.
void append_roots_on_row(const Curve& curve, const IntervalCurve& enclosed, std::int64_t y,
                         std::vector<RowPoint>& points);

// -1, 0, 1: the sign of a - b.
[[nodiscard]] int compare(const RowPoint& a, const RowPoint& b);

// A point strictly between a and b, with a < b; some point below, some point above.
[[nodiscard]] RowPoint point_between(const RowPoint& a, const RowPoint& b);
[[nodiscard]] RowPoint point_below(const RowPoint& x);
[[nodiscard]] RowPoint point_above(const RowPoint& x);

}  // namespace halfspace
