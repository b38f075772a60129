#include "firmware/core/root_surface.hpp"

#include <algorithm>

namespace halfspace {
namespace {

using Int = Wide<512>;
using ExactQuadratic = std::array<Int, 6>;
using ExactLinear = std::array<Int, 3>;

// Bits that a form's value can have, its degree-2, degree-1 and constant terms in the order of ScaledQuadratic.
int bits(const ExactQuadratic& q) {
  constexpr int degree[6] = {2, 2, 2, 1, 1, 0};
  int most = 0;
  for (int i = 0; i < 6; ++i) most = std::max(most, q[i].bit_length() + degree[i] * coordinate_bits);
  return most + 3;
}
int bits(const ExactLinear& q) {
  return 2 + std::max({q[0].bit_length() + coordinate_bits, q[1].bit_length() + coordinate_bits, q[2].bit_length()});
}

Wide<128> shifted(const Int& value, int shift) { return Wide<128>(shift >= 0 ? value >> shift : value << -shift); }

void scale_to(ScaledQuadratic& out, const ExactQuadratic& q, int exponent) {
  out.exponent = static_cast<std::int16_t>(exponent);
  for (int i = 0; i < 6; ++i) out.q[i] = shifted(q[i], exponent);
}

void scale_to(ScaledLinear& out, const ExactLinear& q, int exponent, int shift) {
  out.exponent = static_cast<std::int16_t>(exponent);
  for (int i = 0; i < 3; ++i) out.q[i] = shifted(q[i], shift);
}

// p q added to `sum`.
void add_product(ExactQuadratic& sum, const ExactLinear& p, const ExactLinear& q) {
  sum[0] += p[0] * q[0];
  sum[1] += p[0] * q[1] + p[1] * q[0];
  sum[2] += p[1] * q[1];
  sum[3] += p[0] * q[2] + p[2] * q[0];
  sum[4] += p[1] * q[2] + p[2] * q[1];
  sum[5] += p[2] * q[2];
}

struct Component {
  ExactLinear u{};
  Int v;
};

// a * gradient_j = u + v sqrt(D): row_j a - slope b + slope s sqrt(D).
Component gradient(const ActiveFace& f, int j) {
  static constexpr std::uint8_t row[4][4] = {{0, 3, 6, 5}, {3, 1, 7, 4}, {5, 4, 8, 2}, {6, 7, 9, 8}};
  static constexpr std::uint8_t b[3] = {5, 4, 8};
  const Int slope(f.c[row[j][3]]);
  Component g;
  for (int i = 0; i < 3; ++i) g.u[i] = Int(f.c[2]) * Int(f.c[row[j][i]]) - slope * Int(f.c[b[i]]);
  g.v = f.sheet < 0 ? -slope : slope;
  return g;
}

// N_i = M g in the page frame, where gw(page) = gw(local) - o . g.
Component normal(const ActiveFace& f, const Lighting& lighting, int i) {
  const std::array<std::int64_t, 4> origin{f.origin_x, f.origin_y, f.origin_z, 0};
  Component n;
  for (int j = 0; j < 4; ++j) {
    const Int m = Int(lighting.matrix[i][j]) - Int(lighting.matrix[i][3]) * Int(origin[j]);
    if (m.is_zero()) continue;
    const Component g = gradient(f, j);
    for (int k = 0; k < 3; ++k) n.u[k] += m * g.u[k];
    n.v += m * g.v;
  }
  return n;
}

ExactQuadratic discriminant(const ActiveFace& f) {
  const Int a(f.c[2]);
  const ExactLinear b{Int(f.c[5]), Int(f.c[4]), Int(f.c[8])};
  ExactQuadratic d{};
  add_product(d, b, b);
  static constexpr std::uint8_t rest[6] = {0, 3, 1, 6, 7, 9};
  for (int i = 0; i < 6; ++i) {
    const Int term = a * Int(f.c[rest[i]]);
    d[i] -= i == 1 || i == 3 || i == 4 ? term + term : term;
  }
  return d;
}

}  // namespace

void make_root_surface(ActiveFace& face, const Lighting& lighting) {
  const ExactQuadratic d = discriminant(face);
  Component light;
  ExactQuadratic square{};
  ExactLinear square_root{};
  Int v2;
  for (int i = 0; i < 3; ++i) {
    const Component n = normal(face, lighting, i);
    const Int l(static_cast<std::int64_t>(lighting.light[i]) * face.light_sign);
    for (int k = 0; k < 3; ++k) {
      light.u[k] += l * n.u[k];
      square_root[k] += (n.u[k] + n.u[k]) * n.v;
    }
    light.v += l * n.v;
    add_product(square, n.u, n.u);
    v2 += n.v * n.v;
  }
  for (int i = 0; i < 6; ++i) square[i] += v2 * d[i];

  RootSurface& s = face.surface;
  const int half = std::max(0, bits(d) - value_bits + 1) / 2;
  scale_to(s.discriminant, d, 2 * half);
  const int root_bits = (bits(d) + 1) / 2;
  const int light_exponent = std::max(0, std::max(bits(light.u), light.v.bit_length() + root_bits) - value_bits);
  scale_to(s.light, light.u, light_exponent, light_exponent);
  s.light_root = shifted(light.v, light_exponent - half);
  const int square_exponent = std::max(0, std::max(bits(square), bits(square_root) + root_bits) - value_bits);
  scale_to(s.square, square, square_exponent);
  scale_to(s.square_root, square_root, square_exponent, square_exponent - half);
}

}  // namespace halfspace
