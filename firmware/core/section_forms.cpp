#include "firmware/core/section_forms.hpp"

#include <algorithm>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 59, discriminant_bits = 59;
constexpr int root_bits = 30;

// A face's polynomial about a dot, before it is scaled.
struct WideBlock {
  Wide<128> c, x, y, xx, xy, yy;

  WideBlock(const ScaledQuadratic& p, std::int32_t at_x, std::int32_t at_y) : xx(p.q[0]), xy(p.q[1]), yy(p.q[2]) {
    const Wide<128> rise_x = xx.times(at_x);
    const Wide<128> rise_y = yy.times(at_y);
    const Wide<128> chord = rise_x + xy.times(at_y) + p.q[3];  // from x = 0
    c = chord.times(at_x) + (rise_y + p.q[4]).times(at_y) + p.q[5];
    x = chord + rise_x;
    y = rise_y + rise_y + xy.times(at_x) + p.q[4];
  }
  WideBlock(const ScaledLinear& p, std::int32_t at_x, std::int32_t at_y) : c(p.at(at_x, at_y)), x(p.q[0]), y(p.q[1]) {}

  // Bits that hold the sum of its terms' sizes for |t| <= h, |v| <= lines.
  [[nodiscard]] int bits(std::int32_t h, std::int32_t lines) const {
    const Wide<128> across = xx.magnitude().times(h) + xy.magnitude().times(lines) + x.magnitude();
    const Wide<128> down = yy.magnitude().times(lines) + y.magnitude();
    return (across.times(h) + down.times(lines) + c.magnitude()).bit_length();
  }
  [[nodiscard]] BlockQuadratic quadratic(int shift) const {
    return {scaled(c, shift),  scaled(x, shift),  scaled(y, shift),
            scaled(xx, shift), scaled(xy, shift), scaled(yy, shift)};
  }
  [[nodiscard]] BlockLinear linear(int shift) const { return {scaled(c, shift), scaled(x, shift), scaled(y, shift)}; }
};

}  // namespace

// As many lines as an eighth of the span has dots, at most 32, and a quarter of it on either side; what the last block had beside, too,
// where this line crosses it: a face may be seen in several spans.
void SectionForms::cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to) {
  const std::int32_t width = to - from + 1;
  const std::int32_t spare = std::min(width / 4 + 2, (2 * longest_half - width) / 2);
  std::int32_t left = from - spare;
  std::int32_t right = to + spare;
  if (half != 0 && y0 <= y && y < y1 && std::max(to, x1) - std::min(from, x0) < 2 * longest_half) {
    left = std::max(std::min(x0, left), to - 2 * longest_half + 1);
    right = std::min(std::max(x1, right), left + 2 * longest_half - 1);
  }
  const std::int32_t lines = std::clamp<std::int32_t>(width / 16, 4, 16);
  x0 = left;
  x1 = right;
  y0 = y;
  y1 = y + 2 * lines;
  middle = x0 + (x1 - x0) / 2;
  line = y + lines;
  half = std::max<std::int32_t>(1, x1 - middle);
  half_bits = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(half)));
  load(job.face.surface, job.table.light_bits, lines, middle - job.face.origin_x, line - job.face.origin_y);
  const std::int32_t reach = half + lines + 1;
  deep_from = (reach + 1) * (reach + 1);
  errors[0] = errors_for(reach + 1 + 4);
  errors[1] = errors_for(deep_root_error);
}

// The scales follow root_shade.cpp: from the largest values that the block can reach, and where coefficients were rounded
// (exponent > 0) such that their error stays under one unit.
void SectionForms::load(const RootSurface& f, int light_bits, std::int32_t lines, std::int32_t x, std::int32_t y) {
  const WideBlock wide_d(f.discriminant, x, y);
  const int root_shift = std::max((wide_d.bits(half, lines) - discriminant_bits + 1) >> 1,
                                  f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
  const WideBlock wide_q(f.square, x, y);
  const WideBlock wide_r(f.square_root, x, y);
  const int r_bits = wide_r.bits(half, lines) + root_shift + root_bits;
  int square_shift = std::max(wide_q.bits(half, lines), r_bits) + 1 - square_bits;
  if (f.square.exponent > 0) square_shift = std::max(square_shift, quadratic_error_bits);
  // L / (|N| 2^light_bits) must come out as in LevelTable: twice light's scale is square's.
  const int balance = f.square.exponent - 2 * f.light.exponent + 2 * light_bits;
  if (f.light.exponent > 0) square_shift = std::max(square_shift, 2 * linear_error_bits - balance);
  const int half_exponent = f.discriminant.exponent / 2;
  if (f.light.exponent > half_exponent) square_shift = std::max(square_shift, 2 * (root_shift + 30) - balance);
  if (f.square.exponent > half_exponent) {
    square_shift = std::max(square_shift, root_shift + 30 + linear_error_bits - 31);
  }
  const WideBlock wide_l(f.light, x, y);
  const int light_terms = std::max(wide_l.bits(half, lines), f.light_root.bit_length() + root_shift + root_bits);
  square_shift = std::max(square_shift, 2 * (light_terms - 31) - balance);
  square_shift += (square_shift + balance) & 1;
  const int light_shift = (square_shift + balance) / 2;

  d = wide_d.quadratic(2 * root_shift);
  q = wide_q.quadratic(square_shift);
  r = wide_r.linear(square_shift - root_shift - root_fraction);
  l = wide_l.linear(light_shift - light_fraction);
  m = static_cast<std::int32_t>(scaled(f.light_root, light_shift - root_shift - 30));
  m_size = static_cast<std::int32_t>(magnitude(m) >> 30) + 1;
  may_be_dark = f.light_root.is_zero() && f.light.q[0].is_zero() && f.light.exponent == 0;
}

// quick_root errs by 3; where s >= E, E / (sqrt(D) + sqrt(D~)) is less than 2, and the root of E is at most reach + 1.
SectionErrors SectionForms::errors_for(std::int32_t root_error) const {
  const std::int64_t light = (static_cast<std::int64_t>(magnitude(m)) * root_error >> 30) + 6;
  const std::int64_t square = (std::int64_t{root_error} << 30) + (std::int64_t{1} << 32) + deep_from;
  return {root_error, static_cast<std::int32_t>(light), static_cast<std::int32_t>(square >> 16) + 1};
}

Answer SectionForms::reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const {
  const std::int32_t t = x - middle;
  const LineForms on_y = on(y);
  const std::int32_t s = on_y.d.root(t);
  const std::int64_t slope = on_y.r.linear(t) >> root_fraction;
  // The error of s can take a small |N|^2 below 0; the true one is not.
  const Light dot{(on_y.l.linear(t) >> light_fraction) + (std::int64_t{m} * s >> 30),
                  std::max<std::int64_t>(on_y.q.at(t) + slope * s, 0)};
  const SectionErrors& e = errors[s >= deep_from ? 1 : 0];
  const auto light = static_cast<std::uint64_t>(e.light);
  const std::uint64_t from_l = (magnitude(dot.l) & 0xffffffffU) * (2 * light) + light * light;
  const std::uint64_t from_n = (std::uint64_t{square} * static_cast<std::uint32_t>(e.square) >> 32) + 1;
  // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
  const Margin margin{e.light, static_cast<std::int64_t>(from_l + (from_n << 16)) + (dot.n2 >> 32) + 4};
  return compare(dot, margin, square);
}

}  // namespace halfspace
