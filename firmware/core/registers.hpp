// registers.hpp - additive registers: a polynomial held at one dot and walked by additions.
//   first order   r(x, y) = A x + B y + C                              3 registers
//   second order  r(x, y) = A x^2 + B x y + C y^2 + D x + E y + F      6 registers
// Exact   No rounding: after any walk r equals the polynomial there. A step forward and a step back cancel,
// and XY = YX
//         makes every route give the same value (Peredy's "conservative" algorithms).
// Ranges  Int must hold the values at every dot visited and one step beyond; the job writer proves it
// (host/job/limits). Cost    A step is 1 addition (first order) or 3 (second); a multi-step is 2 products. No
// heap; cannot fail. Source  Peredy 1991, "Additive Algorithms", "Additive Algorithm of Second Order", and
// the multi-step forms.
#pragma once

#include <cstdint>

#include "firmware/core/wide.hpp"

namespace halfspace {

template <class Int>
struct FirstOrder {
  Int r;     // the value at the current dot
  Int x, y;  // r(x+1, y) - r, r(x, y+1) - r: constant

  constexpr void step_x() { r += x; }
  constexpr void back_x() { r -= x; }
  constexpr void step_y() { r += y; }
  constexpr void jump_x(std::int64_t n) { r += Int(n) * x; }
  constexpr void jump_y(std::int64_t n) { r += Int(n) * y; }
  friend constexpr bool operator==(const FirstOrder&, const FirstOrder&) = default;
};

template <class Int>
struct SecondOrder {
  Int r;           // the value at the current dot
  Int x, y;        // r(x+1, y) - r, r(x, y+1) - r
  Int xx, xy, yy;  // 2A, B, 2C: constant

  // A x^2 + B x y + C y^2 + D x + E y + F at (px, py).
  static constexpr SecondOrder load(const Int& a, const Int& b, const Int& c, const Int& d, const Int& e, const Int& f,
                                    std::int64_t px, std::int64_t py) {
    SecondOrder s{f, d + a, e + c, a + a, b, c + c};
    s.jump_x(px);
    s.jump_y(py);
    return s;
  }
  constexpr void step_x() {
    r += x;
    x += xx;
    y += xy;
  }
  constexpr void back_x() {
    x -= xx;
    y -= xy;
    r -= x;
  }
  constexpr void step_y() {
    r += y;
    y += yy;
    x += xy;
  }
  // n steps at once: r + n x + n (n - 1) / 2 xx.
  constexpr void jump_x(std::int64_t n) {
    r += Int(n) * x + Int(n * (n - 1) / 2) * xx;
    x += Int(n) * xx;
    y += Int(n) * xy;
  }
  constexpr void jump_y(std::int64_t n) {
    r += Int(n) * y + Int(n * (n - 1) / 2) * yy;
    y += Int(n) * yy;
    x += Int(n) * xy;
  }
  friend constexpr bool operator==(const SecondOrder&, const SecondOrder&) = default;
};

// Executable specification: a walk, a jump and a fresh load agree, and steps back undo steps.
static_assert([] {
  using Registers = SecondOrder<std::int64_t>;
  auto walk = Registers::load(3, -5, 7, 11, -13, 17, 0, 0);
  for (int i = 0; i < 4; ++i) walk.step_x();
  for (int i = 0; i < 3; ++i) walk.step_y();
  walk.back_x();
  auto jump = Registers::load(3, -5, 7, 11, -13, 17, -2, 1);
  jump.jump_x(5);
  jump.jump_y(2);
  return walk == Registers::load(3, -5, 7, 11, -13, 17, 3, 3) && jump == walk &&
         walk.r == 3 * 9 - 5 * 9 + 7 * 9 + 33 - 39 + 17;
}());

}  // namespace halfspace
