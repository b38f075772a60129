// depth_bounds.hpp - at which depths a half-space holds over a rectangle of dots, in doubles; never wrong.
// On the ray of (x, y) a half-space is a z^2 + 2 b z + c <= 0, with a constant, b linear and c quadratic in (x, y); d = b^2 - a c. With |a| = 1
// its depths lie between the roots -b -+ sqrt(d), or beyond them; with a = 0 on one side of -c / 2b.
// Exact   Every bound holds what rounding may do: coefficients are known to 2^-47 of their terms, sums to 2^-44 of what these are at most.
// Cost    Some 40 additions and multiplications and two square roots a rectangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/flatten/integer_scene.hpp"

namespace halfspace {

inline constexpr double no_bound = std::numeric_limits<double>::infinity();

// Of dots, seen from the body's origin: middle and half sides.
struct DotRectangle {
  double x = 0, y = 0;
  double half_x = 0, half_y = 0;
};

// Local depths. Empty where low > high.
struct DepthInterval {
  double low = -no_bound, high = no_bound;

  [[nodiscard]] bool empty() const { return low > high; }
};

struct HoldingDepths {
  DepthInterval may;         // nowhere else does it hold, on any dot
  DepthInterval must;        // there it does on all dots, but for `hole`
  DepthInterval hole{1, 0};  // closed
};

class DepthForm {
 public:
  // For rectangles whose dots have no |x| and |y| larger than these.
  DepthForm(const IntegerHalfSpace& half_space, double largest_x, double largest_y);

  [[nodiscard]] HoldingDepths over(const DotRectangle& dots) const;

  // A rectangle outside which it holds nowhere: of an ellipsoid about its silhouette, else without end.
  [[nodiscard]] DotRectangle silhouette() const;

 private:
  enum class Kind : std::uint8_t {
    unknown,  // coefficients too far apart for doubles
    between,  // a > 0
    beyond,   // a < 0
    flat,     // a = 0
  };
  struct Linear {
    double x = 0, y = 0, k = 0;
    double margin = 0;

    [[nodiscard]] DepthInterval over(const DotRectangle& dots) const;
  };
  // xx x^2 + 2 xy x y + yy y^2 + 2 x x + 2 y y + k
  struct Quadratic {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0, k = 0;
    double margin = 0;

    [[nodiscard]] DepthInterval over(const DotRectangle& dots) const;
  };

  [[nodiscard]] static HoldingDepths on_one_side(const DepthInterval& b, const DepthInterval& c);

  Kind kind_ = Kind::unknown;
  Linear b_;     // the middle of the roots, where there are two
  Quadratic q_;  // d, or c where a is 0
};

inline DepthInterval DepthForm::Linear::over(const DotRectangle& dots) const {
  const double middle = x * dots.x + y * dots.y + k;
  const double swing = std::abs(x) * dots.half_x + std::abs(y) * dots.half_y + margin;
  return {middle - swing, middle + swing};
}

inline DepthInterval DepthForm::Quadratic::over(const DotRectangle& dots) const {
  const double slope_x = xx * dots.x + xy * dots.y + x;
  const double slope_y = xy * dots.x + yy * dots.y + y;
  const double middle = (slope_x + x) * dots.x + (slope_y + y) * dots.y + k;
  const double swing =
      2 * ((std::abs(slope_x) + std::abs(xy) * dots.half_y) * dots.half_x + std::abs(slope_y) * dots.half_y) + margin;
  const double bow_x = xx * dots.half_x * dots.half_x;
  const double bow_y = yy * dots.half_y * dots.half_y;
  return {middle - swing + std::min(bow_x, 0.0) + std::min(bow_y, 0.0),
          middle + swing + std::max(bow_x, 0.0) + std::max(bow_y, 0.0)};
}

}  // namespace halfspace
