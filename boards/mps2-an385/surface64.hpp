// surface64.hpp - what both baselines compute once for a face: its forms in 64 bits, and what their filters must exceed.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D)
// Ranges  D, q < 2^60; s, r, l, m s < 2^29 or 2^30: the upper words of 64 bits.
#pragma once

#include "boards/mps2-an385/line_forms.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/shade.hpp"

namespace halfspace::mps2 {

struct Surface64 {
  Quadratic64 d, q;
  Linear32 l, r;
  std::int32_t m = 0;  // 32 bits of fraction, below 1/2
  Reach reach;
  std::int32_t deep_from = 0;  // of s: from there on D's rounding moves it by less than a unit
  Margin deep, shallow;

  static Surface64 of(const ShadeJob& job);
};

// What a shader keeps of the face that it shaded last, made again when another one comes or one enters.
template <class Prepared>
class LastFace {
 public:
  void forget() { face_ = nullptr; }
  const Prepared& of(const ShadeJob& job) {
    if (face_ != &job.face) {
      face_ = &job.face;
      prepared_ = Prepared::of(job);
    }
    return prepared_;
  }

 private:
  const ActiveFace* face_ = nullptr;
  Prepared prepared_;
};

}  // namespace halfspace::mps2
