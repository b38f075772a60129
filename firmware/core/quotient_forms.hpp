// quotient_forms.hpp - light and normal of a face without z^2, z = -c / 2b: polynomials, as 2b times a gradient is of second degree.
//   2b g_j = 2b (row j of (x, y, 1)) - slope_j c,  slope_j what z has in g_j;  N = 2b normal and L = light . N, but for b's sign
// Once in numbers of 62 bits about any point (lit_forms), and for a block of dots in 64-bit integers (QuotientForms), so that each of its
// scan lines costs a few products.
// Ranges  |N_i| < 2^60 on the whole block, so |N| < 2^61 and |L| < 2^61; L is scaled as LevelTable asks.
// Errors  A coefficient is known to within E units, so a value to less than (|t| + |v| + 1)^2 E <= 2^error_bits. cover() fails where that
//         exceeds half of the fraction.
// Source  Ours.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/cross_arc.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/real.hpp"
#include "firmware/core/section_forms.hpp"
#include "firmware/core/shade.hpp"

namespace halfspace {

// A face's matrix about a page dot, z taken out: row j is row[j] . (1, x, y) + slope[j] z, and the quadric at z = 0 is c, by terms 1, x, y,
// x^2, xy, y^2. Row 2 is b.
struct FaceRows {
  std::array<RealVector, 4> row;
  std::array<BoundedReal, 4> slope;
  std::array<BoundedReal, 6> c;

  FaceRows(const ActiveFace& face, std::int32_t page_x, std::int32_t page_y);
};

// Terms 1, x, y, x^2, xy, y^2; or the first alone, which is the value at the point.
template <std::size_t Terms>
struct LitForms {
  static_assert(Terms == 1 || Terms == 6);
  std::array<std::array<BoundedReal, Terms>, 3> normal{};
  std::array<BoundedReal, Terms> light{};
};

// By z: |N|^2 = q + r z + square z^2, L = l + m z, with the sign of z^2's factor; about the dot of its rows.
struct DepthLight {
  std::array<BoundedReal, 6> q;
  RealVector r, l;
  BoundedReal square, m;
};
[[nodiscard]] DepthLight light_by_depth(const FaceRows& rows, const ActiveFace& face, const Lighting& lighting);

// The sum of a polynomial's terms' sizes up to so many dots and lines away.
[[nodiscard]] BoundedReal size_of(const std::array<BoundedReal, 6>& p, std::int32_t dots, std::int32_t lines);

// About page dot (x, y); to be multiplied by quotient_sign().
template <std::size_t Terms>
[[nodiscard]] LitForms<Terms> lit_forms(const ActiveFace& face, const Lighting& lighting, std::int32_t x,
                                        std::int32_t y);
// Of b: the same all along a visible span.
[[nodiscard]] int quotient_sign(const ActiveFace& face, std::int32_t x, std::int32_t y);

// What comparisons must exceed at a dot whose L and N_i, of sizes |N_i| in sum, are off by `error` each.
inline Margin lit_margin(const Light& at, std::int64_t sizes, std::int64_t error) {
  const std::int64_t l = at.l < 0 ? -at.l : at.l;
  return {error, 2 * error * (l + sizes) + 4 * error * error + (at.n2 >> 32) + 2};
}

// The forms on one line.
struct QuotientLine {
  LinePolynomial n[3], l;
  int half_bits, error_bits;
};

// Trivial, to share its memory with the forms of other faces: QuotientForms{} knows nothing.
struct QuotientForms {
  using Coefficients = std::array<std::int64_t, 6>;
  Coefficients n[3], l;
  std::int32_t x0, x1, y0, y1;  // the block, on the page: y0 <= y < y1
  std::int32_t middle, line;    // where t and v are 0
  std::int32_t half_bits;       // |t| < 2^half_bits
  std::int32_t error_bits;
  std::int32_t sign;  // that l has been multiplied by

  // N and L of a line, cut by as many bits, are off by less than 2.
  static constexpr int fraction = 31;
  static constexpr std::int32_t value_error = 2;

  [[nodiscard]] bool holds(std::int32_t y, std::int32_t from, std::int32_t to) const {
    return y0 <= y && y < y1 && x0 <= from && to <= x1;
  }
  // Makes them for a block that holds dots from .. to of line y, at most 2 longest_half, and those that may follow. False where they
  // cannot be told well enough.
  [[nodiscard]] bool cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to);
  // Of a span: quotient_sign() there.
  void turn(std::int32_t to) {
    if (to == sign) return;
    for (std::int64_t& c : l) c = -c;
    sign = to;
  }
  [[nodiscard]] QuotientLine on(std::int32_t y) const;
  // Whether a dot of the block reaches a level, by its entry in LevelTable::squares.
  [[nodiscard]] Answer reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const;
};

}  // namespace halfspace
