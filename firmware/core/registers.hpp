// registers.hpp - additive registers: a polynomial held at one dot and walked by additions.
//   first order   r(x, y) = A x + B y + C                              3 registers
//   second order  r(x, y) = A x^2 + B x y + C y^2 + D x + E y + F      6 registers
//   fourth order  the sum of q_ij x^i y^j over i + j <= 4              15 registers
// Exact   No rounding: after any walk r equals the polynomial there. A step forward and a step back cancel,
// and XY = YX
//         makes every route give the same value (Peredy's "conservative" algorithms).
// Ranges  Int must hold the values at every dot visited and one step beyond; the job writer proves it (host/job/limits).
//         Where Int wraps, as Wide does, a value that fits is right whatever the differences lost.
// Cost    A step is 1 addition (first order), 3 (second) or 10 (fourth); a multi-step is 1, 4 or 20 products.
//         No heap; cannot fail.
// Source  Peredy 1991, "Additive Algorithms", "Additive Algorithm of Second Order", and the multi-step forms.
#pragma once

#include <array>
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

// All differences of a polynomial of fourth degree, by order:
//   r      x y      xx xy yy      xxx xxy xyy yyy      xxxx xxxy xxyy xyyy yyyy: constant
// Register `first(n) + j` is the difference taken n - j times in x and j times in y. One more in x stands n + 1 places on, one
// more in y the next place.
template <class Int>
struct FourthOrder {
  std::array<Int, 15> at;

  static constexpr int first(int order) { return order * (order + 1) / 2; }
  [[nodiscard]] constexpr const Int& r() const { return at[0]; }

  // From the coefficients of x^(n-j) y^j, kept in the same places, to a walk's state at (px, py): |px|, |py| <= 2^17. In place: a
  // controller's stack need not hold them twice.
  constexpr void begin(std::int32_t px, std::int32_t py) {
    take_differences(0);
    take_differences(1);
    jump_x(px / 2);
    jump_x(px - px / 2);
    jump_y(py / 2);
    jump_y(py - py / 2);
  }
  constexpr void step_x() {
    for (int n = 0, k = 0; n < 4; ++n) {
      for (int j = 0; j <= n; ++j, ++k) at[k] += at[k + n + 1];
    }
  }
  constexpr void back_x() {
    for (int n = 3, k = 9; n >= 0; --n) {
      for (int j = n; j >= 0; --j, --k) at[k] -= at[k + n + 1];
    }
  }
  constexpr void step_y() {
    for (int n = 0, k = 0; n < 4; ++n) {
      for (int j = 0; j <= n; ++j, ++k) at[k] += at[k + n + 2];
    }
  }
  // n steps at once, |n| <= 2^16: each register gains binomial(n, s) times its s-th difference.
  constexpr void jump_x(std::int32_t n) { jump(n, 0); }
  constexpr void jump_y(std::int32_t n) { jump(n, 1); }
  friend constexpr bool operator==(const FourthOrder&, const FourthOrder&) = default;

 private:
  // Of powers of x, or of y, at 0: x^e has the k-th difference `of[e][k]`, the ways to hand e things to k people, none left out.
  constexpr void take_differences(int in_y) {
    constexpr std::int32_t of[5][5] = {{1}, {0, 1}, {0, 1, 2}, {0, 1, 6, 6}, {0, 1, 14, 36, 24}};
    for (int order = 0, k = 0; order <= 4; ++order) {
      for (int j = 0; j <= order; ++j, ++k) {
        const int power = in_y != 0 ? j : order - j;
        at[k] = at[k].times(of[power][power]);
        for (int s = 1; s <= 4 - order; ++s) at[k] += at[first(order + s) + j + s * in_y].times(of[power + s][power]);
      }
    }
  }
  constexpr void jump(std::int64_t n, int in_y) {
    // The last is the largest: under 2^62 before its division.
    const std::int64_t two = n * (n - 1) / 2;
    const std::int64_t three = two * (n - 2) / 3;
    const std::array<Int, 4> binomial{Int(n), Int(two), Int(three), Int(three * (n - 3) / 4)};
    for (int order = 0, k = 0; order < 4; ++order) {
      for (int j = 0; j <= order; ++j, ++k) {
        for (int s = 1; s <= 4 - order; ++s) at[k] += binomial[s - 1] * at[first(order + s) + j + s * in_y];
      }
    }
  }
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

static_assert([] {
  using Registers = FourthOrder<Wide<64>>;
  const std::array<Wide<64>, 15> q{17, 11, -13, 3, -5, 7, 2, -4, 6, -8, 1, -9, 10, 12, -3};
  const auto begin = [&q](std::int32_t x, std::int32_t y) {
    Registers s{q};
    s.begin(x, y);
    return s;
  };
  auto walk = begin(0, 0);
  for (int i = 0; i < 4; ++i) walk.step_x();
  for (int i = 0; i < 2; ++i) walk.step_y();
  walk.back_x();
  auto jump = begin(-5, 7);
  jump.jump_x(8);
  jump.jump_y(-5);
  // at (3, 2):   17  33 - 26  27 - 30 + 28  54 - 72 + 72 - 64  81 - 486 + 360 + 288 - 48
  return walk == begin(3, 2) && jump == walk && walk.r() == Wide<64>(17 + 7 + 25 - 10 + 195);
}());

}  // namespace halfspace
