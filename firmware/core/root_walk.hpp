// root_walk.hpp - s = sqrt(D) from dot to dot along a span, D < 2^60 given by its registers.
//   RootWalk    to within one unit: Newton's correction of an extrapolated root
//   JordanWalk  to within half a step of 2^shift units: additions and comparisons only
// Source  Jordan, Lennon, Holmes 1973, "An Improved Algorithm for the Generation of Nonparametric Curves"; Ressler 1985, 6.3.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/isqrt.hpp"

namespace halfspace {

// floor(sqrt(d)) to within one unit, from the roots of the three dots before: their second difference
// predicts it to a few units, and one division corrects the rest.
class RootWalk {
 public:
  std::int64_t next(std::int64_t d) {
    if (d <= 0) {
      known_ = 0;
      return 0;
    }
    std::int64_t s = known_ == 3 ? 3 * (s_[0] - s_[1]) + s_[2] : 0;
    if (s < 1 || s > (std::int64_t{1} << 31) || !close(s, d)) s = isqrt(static_cast<std::uint64_t>(d));
    s_[2] = s_[1];
    s_[1] = s_[0];
    s_[0] = s;
    if (known_ < 3) ++known_;
    return s;
  }

 private:
  // Two Newton steps at most; true when |s - sqrt(d)| < 1.
  static bool close(std::int64_t& s, std::int64_t d) {
    for (int i = 0; i < 3; ++i) {
      const std::int64_t rest = d - s * s;
      if (rest <= s && -rest <= s) return true;
      s += rest / (2 * s);
      if (s < 1) return false;
    }
    return false;
  }
  std::int64_t s_[3] = {};
  int known_ = 0;
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
    return (s_ << shift_) + ((std::int64_t{1} << shift_) >> 1);
  }

 private:
  int shift_;
  std::int64_t last_, s_ = 0, gap_ = 0, odd_ = 0, unit_ = 0;
};

}  // namespace halfspace
