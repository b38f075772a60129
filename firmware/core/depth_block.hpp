// depth_block.hpp - where a face lies over a block of lines: bounds of its depth, and forms that tell it at a dot in 64 bits.
//   Most pairs of faces that share dots of a line lie apart in depth, and did so on the lines above. A block says so at the cost of
//   two comparisons; it is made once for some lines, from the face's polynomials in 128 bits.
// Bounds  -b is linear. D is the linear form between its values at the block's corners, and at most |dxx| w^2 / 4 + |dyy| h^2 / 4 to the
//         one side that their signs tell. Hence bounds of n and of the depth, for all dots where D >= 0.
// Error   docs/core.md, "Bound of a sample"; tests/core/depth_test.cpp.
// Cost    A block takes about as much as four depths by polynomials in 128 bits; 51 lines share it, or a quarter as many as its width has
//         dots.
#pragma once

#include "firmware/core/face.hpp"

namespace halfspace {

inline constexpr int depth_fraction = 16;
inline constexpr std::int32_t strip_rows =
    17;  // lines that a block made on the first of them lasts at least: curtain.hpp
inline constexpr std::int64_t largest_depth = std::int64_t{1} << 45;  // 2^29 dots: sums stay inside 64 bits

// What blocks are made of, when a face enters: a plane's or root face's inverse (c2 > 0) and D.
void make_depth(ActiveFace& face);

struct DepthRange {
  std::int64_t low, high;
};

// Dots t0 .. t1 of lines s0 .. s1 of a block, counted from its first.
struct BlockPart {
  std::int32_t t0, t1, s0, s1;
};

// Of the root of D in units over the part, errors taken in.
[[nodiscard]] DepthRange root_over(const DepthBlock& block, const BlockPart& p);

// Where the face lies on dots a .. b of lines y0 .. y1, which its block holds.
struct DepthBounds {
  std::int32_t low, high;  // whole dots of page depth
};
[[nodiscard]] DepthBounds depth_over(const ActiveFace& face, std::int32_t y0, std::int32_t y1, std::int32_t a,
                                     std::int32_t b);

// Makes the face's block hold dots a .. b of line y, and some more of them and of lines to come. Not for rational faces.
void make_block(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b);

// Makes it hold them for a strip of lines from y on, at the cost of a look where it does already.
inline const DepthBlock& bounded_strip(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b) {
  if (face.block.y1 < std::min(y + strip_rows, largest_side) - 1) face.block.y1 = -1;  // an old one is not widened
  if (!face.block.holds(y, a, b)) make_block(face, y, a, b);
  return face.block;
}

// What is known of f and g, whose blocks hold dots x0 .. x1 of line y, on these dots; kept with f, and good for lines to come.
// Method  The difference of the linear parts of z at the corners, and the bounds of both roots.
//         Inner: f where z of f less z of g has the sign of a convex function, for that is below zero on an interval. A front sheet of
//         concave D is convex and a back sheet concave, a plane both. Two such sheets of quadrics whose second-order terms are in proportion
//         (spheres): with z = m - r the halves m differ by a constant k, r r by a linear form P. Where k >= 0, f is behind where
//         r_f <= r_g + k, or P - k k - 2 k r_g <= 0: convex again, and g is the inner one. Back sheets exchange f and g, and the sign of z.
//         Turn: cut into columns, in each of which the sign of f less g or that of its slope along the line is told by bounds, and of the
//         slopes all that tell where the other does not agree. Neighbouring columns share a dot.
[[nodiscard]] DepthProof& prove_order(ActiveFace& f, const ActiveFace& g, std::int32_t y, std::int32_t x0,
                                      std::int32_t x1);

// The same, at the cost of a look where it is known already.
[[nodiscard]] inline DepthProof& proven_order(ActiveFace& f, const ActiveFace& g, std::int32_t y, std::int32_t x0,
                                              std::int32_t x1) {
  for (DepthProof& proof : f.proofs) {
    if (proof.rival == g.order && proof.holds(y, x0, x1)) return proof;
  }
  return prove_order(f, g, y, x0, x1);
}

// The right one of two dots between which the sign changes, looked for about `guess`; left < right have different ones, `left_sign` the left.
// INT32_MIN: it cannot be told.
template <class SignAt>
std::int32_t find_change(const SignAt& sign_at, std::int32_t left, std::int32_t right, int left_sign,
                         std::int32_t guess) {
  for (std::int32_t step = 1; right - left > 1; step *= 2) {
    const std::int32_t x = left < guess && guess < right ? guess : left + (right - left) / 2;
    const int sign = sign_at(x);
    if (sign == 0) return INT32_MIN;
    (sign == left_sign ? left : right) = x;
    guess = sign == left_sign ? x + step : x - step;
  }
  return right;
}

// floor(v n 2^-bits) for |v| < 2^60 and 0 <= n < 2^bits <= 2^16.
constexpr std::int64_t part(std::int64_t v, std::int32_t n, int bits) {
  if constexpr (limb_bits == 64) return static_cast<std::int64_t>(static_cast<SignedDoubleLimb>(v) * n >> bits);
  const std::int64_t low = v & ((std::int64_t{1} << bits) - 1);
  return (v >> bits) * n + (low * n >> bits);
}

}  // namespace halfspace
