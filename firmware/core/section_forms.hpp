// section_forms.hpp - a root face's forms about a block of dots in 64 bits: rounded once for the block, so that each of its scan
// lines costs a few products.
//   L = l + m s,  |N|^2 = q + r s,  s = sqrt(D);  D and q quadratic, l and r linear in t and v, dot and line counted from the middle.
// Depth   Where a line of sight runs nearly along the face's asymptotic cone, l and m s are large and their sum is not. There the forms are
//         those of z: L = l + m z, |N|^2 = q + r z + zz z^2, whose terms are no larger than what they make. With a z^2, 2 b z and c in
//         the quadric, and signs such that s = b + a z, z = c / (s + b), however small a is; where b < 0, z = (s - b) / a.
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
  std::int64_t v0, v1, v2;

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

// z of a dot, in units such that |z| < 2^29.
struct DotDepth {
  std::int32_t s, z;
  std::int32_t root_error, error;  // of s and z
  static constexpr std::int32_t far_error = 1 << 30;
  [[nodiscard]] bool is_far() const { return error == far_error; }  // z is not known
};

// s = b + a z, and z = c / (s + b).
struct LineDepth {
  LinePolynomial b, c;
  std::int64_t a;  // 60 bits of fraction
};
struct BlockDepth {
  BlockLinear b;     // 20 bits of fraction
  BlockQuadratic c;  // its terms are off by less than term_error units
  std::int64_t a = 0;
  std::int64_t zz = 0;  // of |N|^2, 60 bits of fraction

  static constexpr int fraction = 20, term_error = 8;
  [[nodiscard]] LineDepth on(std::int32_t v) const { return {b.on(v), c.on(v), a}; }
};

// What L and |N|^2 are by a root, or by z.
struct RootForms {
  BlockQuadratic q;
  BlockLinear r, l;         // 32 and light_fraction bits of fraction
  std::int64_t wide_m = 0;  // 58 bits of fraction
  std::int32_t m = 0;       // 30 bits of fraction
  std::int32_t zz = 0;      // of z^2: 30 bits of fraction
};

// The forms on one line.
struct LineForms {
  LinePolynomial d, q, r, l;
  std::int32_t m;
  int half_bits;
  bool by_depth;
  LineDepth depth;  // if so
};

// What a dot may be off by: s, L, and |N|^2 in units of 2^16.
struct SectionErrors {
  std::int32_t root = 0, light = 0, square = 0;
};

struct SectionForms : RootForms {
  BlockQuadratic d;
  bool by_depth = false;
  BlockDepth depth;                             // if so
  RootForms by_root;                            // too
  std::int32_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // the block, on the page: y0 <= y < y1
  std::int32_t middle = 0, line = 0;            // where t and v are 0
  std::int32_t half = 0;                        // |t| <= half; 0: nothing is known yet
  int half_bits = 0;                            // half < 2^half_bits
  std::int32_t m_size = 0;                      // |m| 2^-30, rounded up
  std::int32_t deep_from = 0;                   // from this s on it is off by no more than a root's own error
  SectionErrors errors[2];                      // at a limb, and there
  bool may_be_dark = false;                     // L may be 0 on a whole line
  bool has_wide_slopes = false;                 // r, l and wide_m, by s, are exact to their last bits

  static constexpr int light_fraction = 28, root_fraction = 32;
  static constexpr std::int32_t deep_root_error = 6;

  [[nodiscard]] bool holds(std::int32_t y, std::int32_t from, std::int32_t to) const {
    return half != 0 && y0 <= y && y < y1 && x0 <= from && to <= x1;
  }
  // Makes them for a block that holds dots from .. to of line y, at most 2 longest_half, and those that may follow.
  void cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to);
  [[nodiscard]] LineForms on(std::int32_t y) const {
    const std::int32_t v = y - line;
    LineForms forms;
    forms.d = d.on(v);
    forms.q = q.on(v);
    forms.r = r.on(v);
    forms.l = l.on(v);
    forms.m = m;
    forms.half_bits = half_bits;
    forms.by_depth = by_depth;
    if (by_depth) forms.depth = depth.on(v);
    return forms;
  }
  // At dot t of a line, where the forms are by z.
  [[nodiscard]] DotDepth depth_at(const LinePolynomial& d_on, const LineDepth& depth_on, std::int32_t t) const;
  // The same of a dot of which but s is known, where b < 0.
  [[nodiscard]] static DotDepth depth_behind(DotDepth dot, std::int64_t b, std::int64_t a);
  // Whether a dot of the block reaches a level, by its entry in LevelTable::squares.
  [[nodiscard]] Answer reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const;

 private:
  struct Box {
    std::int32_t left, right, y, lines;  // half of its lines
  };
  // Whether by z, dots from .. to of its first line tell.
  void cover(const ShadeJob& job, const Box& box, std::int32_t from, std::int32_t to);
  void load(const ShadeJob& job, std::int32_t lines, std::int32_t from, std::int32_t to);
  [[nodiscard]] bool cancels(std::int32_t v, std::int32_t from, std::int32_t to) const;
  // False where z cannot be told well enough.
  [[nodiscard]] bool load_depth(const ShadeJob& job, int root_shift, std::int32_t lines, std::int32_t from,
                                std::int32_t to);
  [[nodiscard]] SectionErrors errors_for(std::int32_t root_error, std::int32_t of_m) const;
};

// value / sum for |value| < 2^29 sum, 2^16 <= sum < 2^31: by 16 bits of the sum's inverse, and once more of what is left. Floors take less than 5.
[[gnu::always_inline]] inline std::int32_t depth_quotient(std::int64_t value, std::uint32_t sum) {
  const int zeros = std::countl_zero(sum);  // 1 to 15
  const auto inverse = static_cast<std::int32_t>(~0U / (sum << zeros >> 16));
  const auto high = static_cast<std::uint32_t>(value >> 32);
  const std::uint32_t upper = high << zeros | static_cast<std::uint32_t>(value) >> (32 - zeros);
  const auto first = static_cast<std::int32_t>(std::int64_t{static_cast<std::int32_t>(upper)} * inverse >> 16);
  const std::int64_t left = value - std::int64_t{first} * static_cast<std::int32_t>(sum);
  const std::uint32_t rest = static_cast<std::uint32_t>(left) >> (16 - zeros) | static_cast<std::uint32_t>(left >> 32)
                                                                                    << (16 + zeros);
  return first + static_cast<std::int32_t>(std::int64_t{static_cast<std::int32_t>(rest)} * inverse >> 32);
}

// D's error makes E / s in its root or, at a limb, its own root. Where s + b is s / 2 or more it is off by no more than s is, but for 1; so
// is z by c's error and |z| times that, over the sum, and by 5 of floors.
[[gnu::always_inline]] inline DotDepth SectionForms::depth_at(const LinePolynomial& d_on, const LineDepth& depth_on,
                                                              std::int32_t t) const {
  const std::int32_t s = d_on.root(t);
  const std::int32_t root_error = std::min(deep_from / std::max<std::int32_t>(s, 1) + 4, errors[0].root);
  DotDepth dot{s, 0, root_error, DotDepth::far_error};
  const std::int64_t b = depth_on.b.linear(t) >> BlockDepth::fraction;
  const std::int64_t wide_sum = s + b;
  if (root_error >> 12 != 0) return dot;
  if (wide_sum < (s + 1) >> 1) return depth_behind(dot, b, depth_on.a);
  const auto sum = static_cast<std::uint32_t>(wide_sum);
  if (wide_sum >> 31 != 0 || sum < 1 << 16) return dot;
  const std::int64_t value = depth_on.c.at(t);
  if (static_cast<std::uint32_t>(magnitude(static_cast<std::int32_t>(value >> 32))) >= sum >> 3) return dot;
  dot.z = depth_quotient(value, sum);
  const auto c_error = static_cast<std::uint32_t>(BlockDepth::term_error * deep_from);
  const std::uint32_t error =
      (c_error >> 10) + 1 +
      ((static_cast<std::uint32_t>(magnitude(dot.z)) >> 10) + 1) * static_cast<std::uint32_t>(root_error + 2);
  dot.error = static_cast<std::int32_t>(error / (sum >> 10)) + 5;
  if (dot.error >> 15 != 0) dot.error = DotDepth::far_error;
  return dot;
}

}  // namespace halfspace
