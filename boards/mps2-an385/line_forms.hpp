// line_forms.hpp - a face's polynomials in 64 bits, and their values from dot to dot.
// Rounding  Coefficients are rounded to units, once, so a value is off by at most form_error; from there on all is exact.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/face.hpp"

namespace halfspace::mps2 {

// Of a frame's coordinates on the page: |x| <= reach.x, |y| <= reach.y.
struct Reach {
  std::int32_t x = 0, y = 0;
};

// A coefficient is off by its rounding here and, where it was scaled before, there: less than 2 units.
constexpr std::int64_t form_error(const Reach& reach) {
  const std::int64_t sum = reach.x + reach.y + 1;
  return 2 * sum * sum;
}

// Bits of the largest value that a form may take.
inline int form_bits(const ScaledQuadratic& p, const Reach& r) {
  Wide<128> sum = p.q[5].magnitude();
  const std::int32_t scale[5] = {r.x * r.x, r.x * r.y, r.y * r.y, r.x, r.y};
  for (int i = 0; i < 5; ++i) sum += p.q[static_cast<std::size_t>(i)].magnitude().times(scale[i]);
  return sum.bit_length();
}
inline int form_bits(const ScaledLinear& p, const Reach& r) {
  return (p.q[0].magnitude().times(r.x) + p.q[1].magnitude().times(r.y) + p.q[2].magnitude()).bit_length();
}

struct LineRegisters {
  std::int64_t v, d1, d2;

  void step() {
    v += d1;
    d1 += d2;
  }
};

struct Quadratic64 {
  std::int64_t q[6] = {};

  static Quadratic64 of(const ScaledQuadratic& p, int shift) {
    Quadratic64 r;
    for (std::size_t i = 0; i < 6; ++i) r.q[i] = scaled(p.q[i], shift);
    return r;
  }
  [[nodiscard]] LineRegisters at(std::int32_t x, std::int32_t y) const {
    const std::int64_t slope = q[0] * (2 * x + 1) + q[1] * y + q[3];
    return {(q[0] * x + q[1] * y + q[3]) * x + (q[2] * y + q[4]) * y + q[5], slope, 2 * q[0]};
  }
};

// With 32 bits of fraction, so that the value is the upper word.
struct Linear32 {
  std::int64_t q[3] = {};

  static Linear32 of(const ScaledLinear& p, int shift) {
    Linear32 r;
    for (std::size_t i = 0; i < 3; ++i) r.q[i] = scaled(p.q[i], shift - 32);
    return r;
  }
  [[nodiscard]] std::int64_t at(std::int32_t x, std::int32_t y) const { return q[0] * x + q[1] * y + q[2]; }
};

inline std::int32_t upper(std::int64_t v) { return static_cast<std::int32_t>(v >> 32); }
inline std::int64_t product(std::int32_t a, std::int32_t b) { return static_cast<std::int64_t>(a) * b; }

}  // namespace halfspace::mps2
