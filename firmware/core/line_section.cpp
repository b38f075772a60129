#include "firmware/core/line_section.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 60;        // q and r s
constexpr int discriminant_bits = 59;  // a bit less than quick_root allows: rounding may carry
constexpr int root_fraction = 32;

// A line of a face's polynomial, before it is scaled.
struct WideLine {
  Wide<128> v0, v1, v2;

  WideLine(const ScaledQuadratic& p, std::int32_t x, std::int32_t y) : v2(p.q[0]) {
    const Wide<128> rise = v2.times(x);
    const Wide<128> chord = rise + p.q[1].times(y) + p.q[3];  // from x = 0
    v0 = chord.times(x) + (p.q[2].times(y) + p.q[4]).times(y) + p.q[5];
    v1 = chord + rise;
  }
  WideLine(const ScaledLinear& p, std::int32_t x, std::int32_t y) : v0(p.at(x, y)), v1(p.q[0]) {}

  // Bits that hold the sum of its terms' sizes for |t| <= h.
  [[nodiscard]] int bits(std::int32_t h) const {
    Wide<128> most = v1.magnitude();
    if (!v2.is_zero()) most += v2.magnitude().times(h);
    return (most.times(h) + v0.magnitude()).bit_length();
  }
  [[nodiscard]] LinePolynomial scaled_by(int shift) const {
    return {scaled(v0, shift), scaled(v1, shift), scaled(v2, shift)};
  }
};

// In units of 2^unit. The terms at tau = 1 are up to 2 and 4 times those at the ends.
ShortPolynomial shortened(const LinePolynomial& p, int half_bits, int unit) {
  const auto cut = [](std::int64_t v, int shift) { return static_cast<std::int32_t>(shifted_down(v, shift)); };
  return {cut(p.v0, unit), cut(p.v1, unit + 2 - half_bits), cut(p.v2, unit + 3 - 2 * half_bits)};
}

}  // namespace

// The scales follow root_shade.cpp: from the largest values that the section can reach, and where coefficients were rounded
// (exponent > 0) such that their error stays under one unit.
LineSection::LineSection(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
    : middle_(x0 + (x1 - x0) / 2),
      half_(std::max<std::int32_t>(1, x1 - middle_)),
      half_bits_(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(half_)))),
      tau_shift_(31 - half_bits_) {
  load(job.face.surface, job.table.light_bits, middle_ - job.face.origin_x, y - job.face.origin_y);
  prepare_errors();
}

void LineSection::load(const RootSurface& f, int light_bits, std::int32_t x, std::int32_t y) {
  const WideLine d(f.discriminant, x, y);
  const int root_shift = std::max((d.bits(half_) - discriminant_bits + 1) >> 1,
                                  f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
  const WideLine q(f.square, x, y);
  const WideLine r(f.square_root, x, y);
  const int r_bits = r.bits(half_) + root_shift + square_bits / 2;
  int square_shift = std::max(q.bits(half_), r_bits) + 1 - square_bits;
  if (f.square.exponent > 0) square_shift = std::max(square_shift, quadratic_error_bits);
  // L / (|N| 2^light_bits) must come out as in LevelTable: twice light's scale is square's.
  const int balance = f.square.exponent - 2 * f.light.exponent + 2 * light_bits;
  if (f.light.exponent > 0) square_shift = std::max(square_shift, 2 * linear_error_bits - balance);
  const int half_exponent = f.discriminant.exponent / 2;
  if (f.light.exponent > half_exponent) square_shift = std::max(square_shift, 2 * (root_shift + 30) - balance);
  if (f.square.exponent > half_exponent) {
    square_shift = std::max(square_shift, root_shift + 30 + linear_error_bits - 31);
  }
  const WideLine l(f.light, x, y);
  const int light_terms = std::max(l.bits(half_), f.light_root.bit_length() + root_shift + square_bits / 2);
  square_shift = std::max(square_shift, 2 * (light_terms - 31) - balance);
  square_shift += (square_shift + balance) & 1;
  const int light_shift = (square_shift + balance) / 2;

  d_ = d.scaled_by(2 * root_shift);
  q_ = q.scaled_by(square_shift);
  r_ = r.scaled_by(square_shift - root_shift - root_fraction);
  l_ = l.scaled_by(light_shift - light_fraction);
  m_ = static_cast<std::int32_t>(scaled(f.light_root, light_shift - root_shift - 30));
  dark_ = f.light_root.is_zero() && l.v0.is_zero() && l.v1.is_zero();
  short_q_ = shortened(q_, half_bits_, short_unit);
  short_r_ = shortened(r_, half_bits_, root_fraction);
  short_l_ = shortened(l_, half_bits_, light_fraction);
}

void LineSection::prepare_errors() {
  deep_from_ = half_ * half_ + half_ + 2;
  errors_[0] = errors_for(half_ + 6);
  errors_[1] = errors_for(6);
  // What is short adds 16 units to l, 16 s to r s and 40 2^short_unit to q: the last two less than 2^35.
  const std::int32_t roots[2] = {half_ + 6, 6};
  for (int i = 0; i < 2; ++i) {
    quick_errors_[i] = {roots[i], static_cast<std::int32_t>(errors_[i].light) + 16,
                        static_cast<std::int32_t>(errors_[i].square >> (16 - error_unit)) + (1 << 19) + 1};
  }
}

LineSection::Errors LineSection::errors_for(std::int64_t root_error) const {
  const auto m = static_cast<std::int64_t>(magnitude(m_));
  const std::int64_t light = (m * root_error >> 30) + 6;
  const std::int64_t square = (root_error << 30) + (std::int64_t{1} << 32) + deep_from_;
  return {static_cast<std::uint32_t>(light), static_cast<std::uint32_t>(square >> error_unit) + 1,
          static_cast<std::uint64_t>(light * light)};
}

}  // namespace halfspace
