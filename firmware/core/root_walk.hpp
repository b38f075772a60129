// root_walk.hpp - s = sqrt(D) from dot to dot along a span, D < 2^60 given by its registers.
//   RootWalk    to within root_tolerance units: Newton's correction of an extrapolated root
//   JordanWalk  to within half a step of 2^shift units: additions and comparisons only
// Source  Jordan, Lennon, Holmes 1973, "An Improved Algorithm for the Generation of Nonparametric Curves"; Ressler 1985, 6.3.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/isqrt.hpp"

namespace halfspace {

// sqrt(d) to within `root_tolerance` units. The roots of the three dots before predict it to R^-2 of its size on a curve of
// radius R dots; one Newton step squares that error. Where this is not enough (a limb, the first dots) the root is taken afresh.
inline constexpr std::int64_t root_tolerance = 4;

class RootWalk {
 public:
  std::int64_t next(std::int64_t d) {
    std::int64_t s = 3 * (s_[0] - s_[1]) + s_[2];
    if (in_range(s)) s += (d - s * s) / (2 * s);
    if (!in_range(s) || !close(s, d)) s = fresh(d);  // a step from a small s can lead anywhere
    s_[2] = s_[1];
    s_[1] = s_[0];
    s_[0] = s;
    return s;
  }
  [[nodiscard]] std::int64_t root() const { return s_[0]; }

 private:
  // Squares fit.
  static bool in_range(std::int64_t s) { return s >= 1 && s < std::int64_t{1} << 31; }
  // |rest| = |s - sqrt(d)| (s + sqrt(d)), about 2 s times the error
  static bool close(std::int64_t s, std::int64_t d) {
    const std::int64_t rest = d - s * s;
    return rest <= root_tolerance * s && -rest <= root_tolerance * s;
  }
  static std::int64_t fresh(std::int64_t d) { return d <= 0 ? 0 : isqrt(static_cast<std::uint64_t>(d)); }
  std::int64_t s_[3] = {};
};

// Jordan's incremental conic s^2 = D(x): s moves by steps of one unit, found by additions and comparisons
// only. gap = D - s^2 with s counted in units of 2^shift.
class JordanWalk {
 public:
  JordanWalk(std::int64_t d, int shift) : shift_(shift), last_(std::max<std::int64_t>(d, 0)) {
    const auto root = static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(last_)));
    s_ = root >> shift_;
    gap_ = last_ - ((s_ * s_) << (2 * shift_));
    odd_ = (2 * s_ + 1) << (2 * shift_);
    unit_ = std::int64_t{2} << (2 * shift_);
  }
  // The middle of the unit that holds sqrt(d).
  std::int64_t next(std::int64_t d) {
    const std::int64_t floor_d = std::max<std::int64_t>(d, 0);
    gap_ += floor_d - last_;
    last_ = floor_d;
    while (gap_ < 0) {
      odd_ -= unit_;
      gap_ += odd_;
      --s_;
    }
    while (gap_ >= odd_) {
      gap_ -= odd_;
      odd_ += unit_;
      ++s_;
    }
    return root();
  }
  [[nodiscard]] std::int64_t root() const { return (s_ << shift_) + ((std::int64_t{1} << shift_) >> 1); }

 private:
  int shift_;
  std::int64_t last_, s_ = 0, gap_ = 0, odd_ = 0, unit_ = 0;
};

}  // namespace halfspace
