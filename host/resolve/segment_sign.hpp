// segment_sign.hpp - does a polynomial of degree four keep its sign along a straight piece? In doubles, never wrong.
// Used as the filter before `along` (quartic.hpp) and Bernstein's coefficients in integers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

class SegmentSign {
 public:
  explicit SegmentSign(const QuarticForm& p);

  // On x = at + step t, y = start + t for all 0 <= t <= length: the one sign of Bernstein's coefficients, or 0 if they have both; nothing
  // where that is not certain.
  [[nodiscard]] std::optional<int> along(double at, double step, double start, double length) const;

 private:
  std::array<double, 15> c_{};  // divided by a power of two so that they are at most 1
  std::size_t order_;           // the degree: in a higher one Bernstein's coefficients would tell more than `along`'s
};

}  // namespace halfspace
