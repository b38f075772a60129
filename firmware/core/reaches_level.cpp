// The filter before exact arithmetic: L >= t |N| at one dot in 62-bit mantissas.
// Exact   A rounded coefficient of RootSurface is off by less than 1 unit, a value by less than quadratic_error_bits or
//         linear_error_bits tell (root_surface.hpp); BoundedReal carries these errors and its own. What is left to exact arithmetic
//         comes within about 2^-50 of a tie.
// Cost    On a Cortex-M3 some 4,000 instructions, where exact arithmetic takes 12,000 to 100,000.

#include "firmware/core/reaches_level.hpp"

#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/real.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

struct LitDot {
  BoundedReal light, square;  // L and |N|^2
};

// The error of a form, in its own units.
constexpr std::int64_t rounding(bool rounded, int bits) { return rounded ? std::int64_t{1} << bits : 0; }

LitDot root_dot(const RootSurface& s, std::int32_t x, std::int32_t y) {
  const int half = s.discriminant.exponent / 2;
  const int light = s.light.exponent;
  const int square = s.square.exponent;
  const int of_root = s.square_root.exponent;
  const BoundedReal root =
      BoundedReal(s.discriminant.at(x, y), 2 * half, rounding(half > 0, quadratic_error_bits)).root();
  return {BoundedReal(s.light.at(x, y), light, rounding(light > 0, linear_error_bits)) +
              BoundedReal(s.light_root, light - half, rounding(light > half, 0)) * root,
          BoundedReal(s.square.at(x, y), square, rounding(square > 0, quadratic_error_bits)) +
              BoundedReal(s.square_root.at(x, y), of_root - half, rounding(of_root > half, linear_error_bits)) * root};
}

LitDot quotient_dot(const ShadeJob& job, std::int32_t x, std::int32_t y) {
  const LitForms<1> at = lit_forms<1>(job.face, job.lighting, x, y);
  LitDot dot{quotient_sign(job.face, x, y) < 0 ? -at.light[0] : at.light[0], {}};
  for (const auto& n : at.normal) dot.square = dot.square + n[0] * n[0];
  return dot;
}

LitDot lit_dot(const ShadeJob& job, std::int32_t x, std::int32_t y) {
  const ActiveFace& face = job.face;
  return face.kind == FaceKind::root ? root_dot(face.surface, x - face.origin_x, y - face.origin_y)
                                     : quotient_dot(job, x, y);
}

// The sign of L - t |N|, 0 where it is not certain: as t > 0 that is the sign of L where L <= 0, else that of the squares.
int sign_of_level(const ShadeJob& job, const LitDot& dot, std::int32_t k) {
  const int light_sign = dot.light.sign();
  if (light_sign <= 0) return light_sign;
  const Lighting& g = job.lighting;
  const std::int64_t scale = static_cast<std::int64_t>(job.table.levels - 1) * g.parallel;
  const std::int64_t threshold =
      static_cast<std::int64_t>(k) * g.unit - static_cast<std::int64_t>(job.table.levels - 1) * g.ambient;
  std::int64_t l2 = 0;
  for (const std::int32_t l : g.light) l2 += static_cast<std::int64_t>(l) * l;
  const BoundedReal left = BoundedReal(scale * scale) * dot.light * dot.light;
  const BoundedReal right = BoundedReal(threshold * threshold) * BoundedReal(l2) * dot.square;
  return (left - right).sign();
}

}  // namespace

bool reaches_level(const ShadeJob& job, std::int32_t x, std::int32_t y, std::int32_t k) {
  const ActiveFace& face = job.face;
  if (k <= job.table.ambient_level) return true;
  if (k > job.table.top_level) return false;
  if (const int sign = sign_of_level(job, lit_dot(job, x, y), k); sign != 0) return sign > 0;
  ++job.counters.exact_levels;
  return job.exact.reaches_level(face, job.lighting, job.table.levels, k, x, y);
}

std::int32_t level_between(const ShadeJob& job, std::int32_t x, std::int32_t y, std::int32_t low, std::int32_t high) {
  while (low < high) {
    const std::int32_t middle = (low + high + 1) / 2;
    if (reaches_level(job, x, y, middle)) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

}  // namespace halfspace
