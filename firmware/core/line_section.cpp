#include "firmware/core/line_section.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 60;  // D, q and r s
constexpr int light_fraction = 28;
constexpr int root_fraction = 32;

// A line of a face's polynomial, before it is scaled.
struct WideLine {
  Wide<128> v0, v1, v2;

  WideLine(const ScaledQuadratic& p, std::int32_t x, std::int32_t y)
      : v0(p.at(x, y)), v1(p.q[0].times(2 * x) + p.q[1].times(y) + p.q[3]), v2(p.q[0]) {}
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

// 256 |v| |K| 2^-90, rounded up. K is taken from 30 bits of D0, D1 h, D2 h^2, h = 2^half_bits; and v^2 D <= q.
std::uint32_t bend_of(const LinePolynomial& d, const LinePolynomial& q, int half_bits) {
  const std::int64_t d0 = d.v0 >> 30;
  const std::int64_t d1 = d.v1 >> (30 - half_bits);
  const std::int64_t d2 = half_bits > 15 ? 0 : d.v2 >> (30 - 2 * half_bits);
  const std::int64_t k = d0 * d2 - (d1 * d1 >> 2);
  const std::uint64_t size = static_cast<std::uint64_t>(k < 0 ? -k : k) + (std::uint64_t{1} << 33);
  const int d_bits = std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(d.v0, 0)));
  const int q_bits = std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(q.v0, 0)));
  const int shift = 22 + 2 * half_bits - ((q_bits - d_bits + 3) >> 1);
  if (d_bits < 40 || shift < 0) return ~0U;
  const std::uint64_t bend = (shift > 63 ? 0 : size >> shift) + 1;
  return bend >> 32 != 0 ? ~0U : static_cast<std::uint32_t>(bend);
}

}  // namespace

// The scales follow root_shade.cpp: from the largest values that the section can reach, and where coefficients were rounded
// (exponent > 0) such that their error stays under one unit.
LineSection::LineSection(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const RootSurface& f = job.face.surface;
  middle_ = x0 + (x1 - x0) / 2;
  half_ = x1 - middle_;
  half_bits_ = std::bit_width(static_cast<std::uint32_t>(half_));
  const std::int32_t x = middle_ - job.face.origin_x;
  const std::int32_t ly = y - job.face.origin_y;

  const WideLine d(f.discriminant, x, ly);
  const int root_shift =
      std::max((d.bits(half_) - square_bits + 1) >> 1, f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
  const WideLine q(f.square, x, ly);
  const WideLine r(f.square_root, x, ly);
  const int r_bits = r.bits(half_) + root_shift + square_bits / 2;
  int square_shift = std::max(q.bits(half_), r_bits) + 1 - square_bits;
  if (f.square.exponent > 0) square_shift = std::max(square_shift, quadratic_error_bits);
  // L / (|N| 2^light_bits) must come out as in LevelTable: twice light's scale is square's.
  const int balance = f.square.exponent - 2 * f.light.exponent + 2 * job.table.light_bits;
  if (f.light.exponent > 0) square_shift = std::max(square_shift, 2 * linear_error_bits - balance);
  const int half_exponent = f.discriminant.exponent / 2;
  if (f.light.exponent > half_exponent) square_shift = std::max(square_shift, 2 * (root_shift + 30) - balance);
  if (f.square.exponent > half_exponent) {
    square_shift = std::max(square_shift, root_shift + 30 + linear_error_bits - 31);
  }
  const WideLine l(f.light, x, ly);
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

  const std::uint64_t steepest = static_cast<std::uint64_t>(std::abs(d_.v1)) +
                                 2 * static_cast<std::uint64_t>(half_) * static_cast<std::uint64_t>(std::abs(d_.v2));
  slope_shift_ = std::max(0, static_cast<int>(std::bit_width(steepest)) - 31);
  bend_ = bend_of(d_, q_, half_bits_);
  const std::int64_t h = half_;
  const std::int64_t quadratic_error = h * h + h + 2;
  deep_from_ = quadratic_error;
  const std::int64_t m = m_ < 0 ? -std::int64_t{m_} : m_;
  for (const bool deep : {false, true}) {
    const std::int64_t e = deep ? 6 : h + 6;
    light_error_[deep] = (m * e >> 30) + 6;
    square_error_[deep] = (e << 30) + (std::int64_t{1} << 32) + quadratic_error;
  }
}

LitDot LineSection::dot(std::int32_t t) const {
  LitDot dot;
  dot.t = t;
  const std::int64_t d = d_.at(t);
  dot.root = certified_root(d <= 0 ? 0 : static_cast<std::uint64_t>(d));
  const auto s = static_cast<std::int32_t>(dot.root.s);
  dot.light.l = (l_.at(t) >> light_fraction) + (std::int64_t{m_} * s >> 30);
  const auto r = static_cast<std::int32_t>(r_.at(t) >> root_fraction);
  dot.light.n2 = std::max<std::int64_t>(q_.at(t) + std::int64_t{r} * s, 0);
  return dot;
}

// s'' = K / s^3, K = D0 D2 - D1^2 / 4. Where D >= 4 (|D'| + |D2|) neighbours have s >= sqrt(3/4) of here, so that eps, half of the largest
// s'', is less than 0.78 K / s^3, and 4 L |v| K <= room s^3 is enough.
bool LineSection::bent(const LitDot& dot, std::int64_t room) const {
  const std::uint32_t s = dot.root.s;
  if (s < 1U << 24) return true;
  const std::int64_t slope = d_.slope(dot.t);
  const auto quarter = static_cast<std::int64_t>(std::uint64_t{s} * s >> 2);
  if ((slope < 0 ? -slope : slope) + (d_.v2 < 0 ? -d_.v2 : d_.v2) + (std::int64_t{s} << 3) > quarter) return true;
  const std::uint32_t cube = high_product(high_product(s << 2, s << 2), s << 2);  // of s 2^-30, 32 bits of fraction
  return static_cast<std::uint64_t>(dot.light.l) * bend_ >> 6 >= static_cast<std::uint64_t>(scale_by(cube, room));
}

Margin LineSection::margin(const LitDot& dot, std::uint32_t square) const {
  const bool deep = dot.root.s >= static_cast<std::uint64_t>(deep_from_);
  const std::int64_t light = light_error_[deep];
  const std::int64_t l = dot.light.l < 0 ? -dot.light.l : dot.light.l;
  // The last three: a square is rounded by less than 2^-32, its two products by less than 1 each.
  return {light, (2 * l + light) * light + scale_by(square, square_error_[deep]) + (dot.light.n2 >> 32) + 4};
}

LitSlope LineSection::slope(const LitDot& dot) const {
  LitSlope slope;
  const std::int64_t d = d_.slope(dot.t) >> slope_shift_;
  // s' = D' / 2 s
  const int shift = 63 - slope_shift_ - dot.root.shift;
  if (shift < 0 || shift > 62) return slope;
  slope.s = d * static_cast<std::int32_t>(dot.root.inverse) >> shift;
  if (slope.s >= 1 << 30 || slope.s <= -(1 << 30)) return slope;
  const auto s1 = static_cast<std::int32_t>(slope.s);
  const auto s = static_cast<std::int32_t>(dot.root.s);
  slope.l = (l_.v1 >> light_fraction) + (std::int64_t{m_} * s1 >> 30);
  const auto r = static_cast<std::int32_t>(r_.at(dot.t) >> root_fraction);
  const std::int64_t r1s = (r_.v1 >> 32) * s + (static_cast<std::int64_t>((r_.v1 & 0xffffffff) * s) >> 32);
  slope.n2 = q_.slope(dot.t) + r1s + std::int64_t{r} * s1;
  slope.known = true;
  return slope;
}

}  // namespace halfspace
