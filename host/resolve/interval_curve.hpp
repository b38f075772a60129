// interval_curve.hpp - curves with rounded coefficients: where one crosses a scan line or a line, in intervals.
// Certain  Every exact root lies in an interval that is returned. What intervals cannot tell is said to be unknown, and is left
//          to integers (row_point.hpp, root_marks.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/flatten/interval.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// All coefficients divided by the same power of two, so that they are at most 1.
struct IntervalCurve {
  std::array<Interval, 6> q;
  bool is_line = false;
};

[[nodiscard]] IntervalCurve interval_curve(const Curve& p);

// Ascending. A hull holds two roots, one twofold, or none.
struct IntervalRoots {
  int count = 0;
  std::array<Interval, 2> x;
  bool is_hull = false;  // then count is 1
};

// Of a x^2 + b x + c; none where a may vanish.
[[nodiscard]] std::optional<IntervalRoots> interval_roots(const Interval& a, const Interval& b, const Interval& c);

// Of a curve in x for any y in the interval; none where its first coefficient in x may vanish.
[[nodiscard]] std::optional<IntervalRoots> roots_in_x(const IntervalCurve& p, const Interval& y);

struct IntervalPoint {
  Interval x, y;
};

struct IntervalPoints {
  int count = 0;
  std::array<IntervalPoint, 2> at;
};

// Where a line and a curve meet; points with |y| > reach may be left out.
[[nodiscard]] std::optional<IntervalPoints> meeting_points(const IntervalCurve& line, const IntervalCurve& p,
                                                           double reach);

}  // namespace halfspace
