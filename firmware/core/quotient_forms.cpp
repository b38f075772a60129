#include "firmware/core/quotient_forms.hpp"

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

constexpr int normal_bits = 60;

template <std::size_t Terms>
using Polynomial = std::array<BoundedReal, Terms>;

template <std::size_t Terms>
Polynomial<Terms> product(const RealVector& a, const RealVector& b) {
  if constexpr (Terms == 1) {
    return {a[0] * b[0]};
  } else {
    return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[2] * b[0],
            a[1] * b[1], a[1] * b[2] + a[2] * b[1], a[2] * b[2]};
  }
}
template <std::size_t Terms>
void add(Polynomial<Terms>& sum, const BoundedReal& factor, const Polynomial<Terms>& p) {
  if (factor.is_zero()) return;
  for (std::size_t i = 0; i < Terms; ++i) sum[i] = sum[i] + factor * p[i];
}

// 2b g_j
template <std::size_t Terms>
Polynomial<Terms> gradient(const FaceRows& f, std::size_t j) {
  Polynomial<Terms> g = product<Terms>(f.row[2], f.row[j]);
  for (std::size_t i = 0; i < Terms; ++i) g[i] = g[i] + g[i] - f.slope[j] * f.c[i];
  return g;
}

// What multiplies a gradient's component j in the normal's component i: gw(page) = gw(local) - o . g.
BoundedReal normal_factor(const ActiveFace& face, const Lighting& lighting, std::size_t i, std::size_t j) {
  const std::array<std::int64_t, 4> origin{face.origin_x, face.origin_y, face.origin_z, 0};
  const auto& row = lighting.matrix[i];
  return BoundedReal(Wide<128>(row[j]) - Wide<128>(row[3]) * Wide<128>(origin[j]), 0);
}

// Returns the largest error.
std::int64_t put(QuotientForms::Coefficients& out, const Polynomial<6>& values, int bits) {
  std::int64_t error = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    out[i] = values[i].fixed(bits);
    error = std::max(error, values[i].error_of(bits));
  }
  return error + 1;
}

LinePolynomial on_line(const QuotientForms::Coefficients& c, std::int32_t v) {
  return BlockQuadratic{c[0], c[1], c[2], c[3], c[4], c[5]}.on(v);
}

}  // namespace

// Coefficients of 128 bits at places of 17: exact in 256.
FaceRows::FaceRows(const ActiveFace& face, std::int32_t page_x, std::int32_t page_y) {
  static constexpr std::uint8_t entry[4][4] = {{6, 0, 3, 5}, {7, 3, 1, 4}, {8, 5, 4, 2}, {9, 6, 7, 8}};
  const std::int32_t x = page_x - face.origin_x;
  const std::int32_t y = page_y - face.origin_y;
  const auto wide = [&face](int i) { return Wide<256>(face.c[i]); };
  Wide<256> at[4];
  for (std::size_t j = 0; j < 4; ++j) {
    at[j] = wide(entry[j][1]).times(x) + wide(entry[j][2]).times(y) + wide(entry[j][0]);
    row[j] = {BoundedReal(at[j], 0), BoundedReal(face.c[entry[j][1]], 0), BoundedReal(face.c[entry[j][2]], 0)};
    slope[j] = BoundedReal(face.c[entry[j][3]], 0);
  }
  c = {BoundedReal(at[0].times(x) + at[1].times(y) + at[3], 0),
       row[0][0] + row[0][0],
       row[1][0] + row[1][0],
       row[0][1],
       row[0][2] + row[0][2],
       row[1][2]};
}

template <std::size_t Terms>
LitForms<Terms> lit_forms(const ActiveFace& face, const Lighting& lighting, std::int32_t x, std::int32_t y) {
  const FaceRows rows(face, x, y);
  LitForms<Terms> out;
  for (std::size_t j = 0; j < 4; ++j) {
    const Polynomial<Terms> g = gradient<Terms>(rows, j);
    for (std::size_t i = 0; i < 3; ++i) add<Terms>(out.normal[i], normal_factor(face, lighting, i, j), g);
  }
  for (int i = 0; i < 3; ++i) {
    add<Terms>(out.light, BoundedReal(std::int64_t{lighting.light[i]} * face.light_sign), out.normal[i]);
  }
  return out;
}
template LitForms<1> lit_forms<1>(const ActiveFace&, const Lighting&, std::int32_t, std::int32_t);
template LitForms<6> lit_forms<6>(const ActiveFace&, const Lighting&, std::int32_t, std::int32_t);

DepthLight light_by_depth(const FaceRows& rows, const ActiveFace& face, const Lighting& lighting) {
  DepthLight out;
  for (std::size_t i = 0; i < 3; ++i) {
    Polynomial<3> normal{};
    BoundedReal slope;
    for (std::size_t j = 0; j < 4; ++j) {
      const BoundedReal factor = normal_factor(face, lighting, i, j);
      if (factor.is_zero()) continue;
      add<3>(normal, factor, rows.row[j]);
      slope = slope + factor * rows.slope[j];
    }
    const BoundedReal light(std::int64_t{lighting.light[i]} *
                            (rows.slope[2].sign() < 0 ? -face.light_sign : face.light_sign));
    add<3>(out.l, light, normal);
    out.m = out.m + light * slope;
    add<6>(out.q, 1, product<6>(normal, normal));
    add<3>(out.r, slope + slope, normal);
    out.square = out.square + slope * slope;
  }
  return out;
}

BoundedReal size_of(const std::array<BoundedReal, 6>& p, std::int32_t dots, std::int32_t lines) {
  const auto size = [&p](std::size_t i) { return p[i].sign() < 0 ? -p[i] : p[i]; };
  return size(0) + BoundedReal(dots) * (size(1) + BoundedReal(dots) * size(3) + BoundedReal(lines) * size(4)) +
         BoundedReal(lines) * (size(2) + BoundedReal(lines) * size(5));
}

int quotient_sign(const ActiveFace& face, std::int32_t x, std::int32_t y) {
  const Wide<128> b = face.c[5].times(x - face.origin_x) + face.c[4].times(y - face.origin_y) + face.c[8];
  return b.negative() ? -1 : 1;
}

// As many lines as an eighth of the span has dots, at most 32, and a quarter of it on either side; what the last block had beside, too,
// where this line crosses it: a face may be seen in several spans.
bool QuotientForms::cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to) {
  const std::int32_t width = to - from + 1;
  const std::int32_t spare = std::min(width / 4 + 2, (2 * longest_half - width) / 2);
  std::int32_t left = from - spare;
  std::int32_t right = to + spare;
  if (y0 <= y && y < y1 && std::max(to, x1) - std::min(from, x0) < 2 * longest_half) {
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
  const std::int32_t half = std::max<std::int32_t>(1, x1 - middle);
  half_bits = static_cast<std::int32_t>(std::bit_width(static_cast<std::uint32_t>(half)));

  const LitForms<6> forms = lit_forms<6>(job.face, job.lighting, middle, line);
  int bits = std::numeric_limits<std::int16_t>::min();
  for (const auto& component : forms.normal) bits = std::max(bits, size_of(component, half, lines).bits());
  const int scale = normal_bits - bits;
  std::int64_t error = put(l, forms.light, scale - job.table.light_bits);
  for (std::size_t i = 0; i < 3; ++i) error = std::max(error, put(n[i], forms.normal[i], scale));
  sign = 1;
  const std::int64_t reach = half + lines + 1;
  error_bits = static_cast<std::int32_t>(std::bit_width(
      static_cast<std::uint64_t>(reach * reach) * static_cast<std::uint64_t>(std::min(error, std::int64_t{1} << 31))));
  return error_bits < fraction;
}

QuotientLine QuotientForms::on(std::int32_t y) const {
  const std::int32_t v = y - line;
  return {{on_line(n[0], v), on_line(n[1], v), on_line(n[2], v)}, on_line(l, v), half_bits, error_bits};
}

Answer QuotientForms::reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const {
  const std::int32_t t = x - middle;
  const QuotientLine at = on(y);
  Light dot{at.l.at(t) >> fraction, 0};
  std::int64_t sizes = 0;
  for (const LinePolynomial& p : at.n) {
    const std::int64_t value = p.at(t) >> fraction;
    sizes += value < 0 ? -value : value;
    dot.n2 += value * value;
  }
  return compare(dot, lit_margin(dot, sizes, value_error), square);
}

}  // namespace halfspace
