// section_forms.hpp - a root face's forms about a block of dots in 64 bits: rounded once for the block, so that each of its scan
// lines costs a few products.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  D and q quadratic, l and r linear in t and v, dot and line counted from the middle.
// Shear   Where a line of sight runs nearly along the face's asymptotic cone, l and m s are large and their sum is not. There s is told from a
//         plane that is near it on the block: L = l + m sigma, |N|^2 = q + r sigma, sigma = (s - plane) 2^bits, with l and q that have taken in
//         m and r times the plane, exactly.
// Ranges  D < 2^59 and |N|^2 < 2^59, q and r 2^30 < 2^58, |L| < 2^31 on the whole block; level k is reached when L > 0 and
//         L^2 >= squares[k] |N|^2 / 2^32.
// Errors  A coefficient is rounded down to a unit, so a quadratic's value is off by less than (|t| + |v| + 1)^2, and by 1 more where
//         RootSurface had rounded it: less than E = (reach + 1)^2. The rest follows as for a walk (docs/core.md).
#pragma once

#include <bit>
#include <cstdint>

#include "firmware/core/level_search.hpp"
#include "firmware/core/quick_root.hpp"

namespace halfspace {

// A block has at most so many dots on either side of its middle, which keeps a polynomial's error far under a root's.
inline constexpr std::int32_t longest_half = 1024;

// Unsigned inside, so that a job that lies about its widths wraps and nothing worse.
constexpr std::int64_t plus_product(std::int64_t a, std::int32_t t, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                   static_cast<std::uint64_t>(std::int64_t{t}) * static_cast<std::uint64_t>(b));
}
constexpr std::uint64_t magnitude(std::int64_t v) {
  return v < 0 ? 0 - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v);
}

// A polynomial of a line: v0 + v1 t + v2 t^2.
struct LinePolynomial {
  std::int64_t v0 = 0, v1 = 0, v2 = 0;

  [[nodiscard]] std::int64_t at(std::int32_t t) const { return plus_product(v0, t, plus_product(v1, t, v2)); }
  [[nodiscard]] std::int64_t linear(std::int32_t t) const { return plus_product(v0, t, v1); }
  // Of its value, or 0.
  [[nodiscard]] std::int32_t root(std::int32_t t) const {
    const std::int64_t v = at(t);
    return v > 0 ? quick_root(static_cast<std::uint64_t>(v)) : 0;
  }
};

// c + x t + y v + xx t^2 + xy t v + yy v^2
struct BlockQuadratic {
  std::int64_t c = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  [[nodiscard]] LinePolynomial on(std::int32_t v) const {
    return {plus_product(c, v, plus_product(y, v, yy)), plus_product(x, v, xy), xx};
  }
};
struct BlockLinear {
  std::int64_t c = 0, x = 0, y = 0;

  [[nodiscard]] LinePolynomial on(std::int32_t v) const { return {plus_product(c, v, y), x, 0}; }
};

// sigma = (s - plane) 2^bits; plane has 20 bits of fraction. Without bits there is none: sigma is s.
struct Shear {
  BlockLinear plane;
  int bits = 0;

  static constexpr int fraction = 20, most_bits = 9;

  // From s at dot t of a line with such a plane.
  [[nodiscard]] static std::int64_t sigma(const LinePolynomial& plane, int bits, std::int32_t t, std::int32_t s) {
    return (std::int64_t{s} * (1 << fraction) - plane.linear(t)) >> (fraction - bits);
  }
};

// s and sigma at a dot of a sheared block; too far from the plane for words where |sigma| is 2^30 or more.
struct ShearedRoot {
  std::int32_t s;
  std::int64_t fine;  // s 2^bits
  std::int64_t sigma;
  std::int32_t error;  // of the last two
  [[nodiscard]] bool is_far() const { return magnitude(sigma) >> 30 != 0; }
};

// What L and |N|^2 are by a root.
struct RootForms {
  BlockQuadratic q;
  BlockLinear r, l;    // 32 and light_fraction bits of fraction
  std::int32_t m = 0;  // 30 bits of fraction
};

// The forms on one line.
struct LineForms {
  LinePolynomial d, q, r, l;
  std::int32_t m;
  int half_bits;
  std::int32_t v;  // the line
  int shear_bits;
  LinePolynomial plane;  // of the shear
};

// What a dot may be off by: s, L, and |N|^2 in units of 2^16.
struct SectionErrors {
  std::int32_t root = 0, light = 0, square = 0;
};

// By sigma.
struct SectionForms : RootForms {
  BlockQuadratic d;
  Shear shear;
  RootForms by_root;                            // without the shear; if there is one
  std::int32_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // the block, on the page: y0 <= y < y1
  std::int32_t middle = 0, line = 0;            // where t and v are 0
  std::int32_t half = 0;                        // |t| <= half; 0: nothing is known yet
  int half_bits = 0;                            // half < 2^half_bits
  std::int32_t m_size = 0;                      // |m| 2^-30, rounded up
  std::int32_t deep_from = 0;                   // from this s on it is off by no more than a root's own error
  SectionErrors errors[2];                      // at a limb, and there
  bool may_be_dark = false;                     // L may be 0 on a whole line

  static constexpr int light_fraction = 28, root_fraction = 32;
  static constexpr std::int32_t deep_root_error = 6;

  [[nodiscard]] bool holds(std::int32_t y, std::int32_t from, std::int32_t to) const {
    return half != 0 && y0 <= y && y < y1 && x0 <= from && to <= x1;
  }
  // Makes them for a block that holds dots from .. to of line y, at most 2 longest_half, and those that may follow.
  void cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to);
  [[nodiscard]] LineForms on(std::int32_t y) const {
    const std::int32_t v = y - line;
    return {d.on(v), q.on(v),    r.on(v),
            l.on(v), m,          half_bits,
            v,       shear.bits, shear.bits == 0 ? LinePolynomial{} : shear.plane.on(v)};
  }
  // At dot t of a line, where there is a shear.
  [[nodiscard]] ShearedRoot sheared_root(const LinePolynomial& d_on, const LinePolynomial& plane_on,
                                         std::int32_t t) const;
  // Whether a dot of the block reaches a level, by its entry in LevelTable::squares.
  [[nodiscard]] Answer reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const;

 private:
  struct Box {
    std::int32_t left, right, y, lines;  // half of its lines
  };
  // For the shear, dots from .. to of its first line tell.
  void cover(const ShadeJob& job, const Box& box, std::int32_t from, std::int32_t to);
  void load(const ShadeJob& job, std::int32_t lines, std::int32_t from, std::int32_t to);
  [[nodiscard]] bool cancels(std::int32_t v, std::int32_t from, std::int32_t to) const;
  [[nodiscard]] SectionErrors errors_for(std::int32_t root_error, std::int32_t of_m) const;
};

}  // namespace halfspace
