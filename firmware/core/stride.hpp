// stride.hpp - levels at some dots of a span, and their averages between: the shader that trades error for speed.
//   Levels are exact at the span's first dot, every stride dots from there, and at its last. Such a dot shows its own level,
//   so that a stride of 1 is exact; the dots between two of them show the average of both, rounded down.
// Source  Ressler 1985, 6.5.1 and (6.9).
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/shade.hpp"

namespace halfspace {

// The paper's k: about so many intervals to a span at least (half as many to a short one), whatever the largest stride.
inline constexpr std::int32_t stride_intervals = 16;

// (6.9)
constexpr std::int32_t stride_in(std::int32_t x0, std::int32_t x1, std::int32_t largest) {
  return std::min((x1 - x0) / stride_intervals + 1, std::max<std::int32_t>(largest, 1));
}

// Takes the dots with exact levels from left to right and paints runs of equal levels.
class SampledLevels {
 public:
  SampledLevels(const ShadeJob& job, std::int32_t x0) : job_(job), from_(x0) {}

  // Of the dot added last; -1: none.
  [[nodiscard]] std::int32_t level() const { return level_; }

  void add(std::int32_t x, std::int32_t level) {
    if (level_ < 0) {
      level_ = level;
    } else if (level != level_) {
      if (x - x_ > 1) show(x_ + 1, (level_ + level) / 2);
      show(x, level);
    }
    x_ = x;
    ++job_.counters.intensities;
  }
  // The dot added last ends the span.
  void finish() { paint(x_); }

 private:
  void show(std::int32_t x, std::int32_t level) {
    if (level == level_) return;
    paint(x - 1);
    from_ = x;
    level_ = level;
  }
  void paint(std::int32_t x1) {
    job_.painter.fill(from_, x1, level_);
    ++job_.counters.level_spans;
  }

  const ShadeJob& job_;
  std::int32_t from_, level_ = -1;  // the run being gathered; the dot added last is in it
  std::int32_t x_ = 0;              // that dot
};

// A second-order register after t steps at once, as t steps would leave it: r + t d1 + t (t - 1) / 2 d2, and d1 + t d2.
// Unsigned, since a product may not fit where the sum does.
inline void jump(std::uint64_t& r, std::uint64_t& d1, std::uint64_t d2, std::int32_t t) {
  const auto steps = static_cast<std::uint64_t>(t);
  r += steps * d1 + steps * (steps - 1) / 2 * d2;
  d1 += steps * d2;
}

}  // namespace halfspace
