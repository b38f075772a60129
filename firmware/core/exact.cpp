#include "firmware/core/exact.hpp"

namespace halfspace {
namespace {

using Int = Wide<exact_bits>;

// A depth z = (p + s sqrt(q)) / d with d > 0, q >= 0, s in {-1, 0, 1}; local to the face's frame.
struct Depth {
  Int p, q, d;
  int s = 0;
};

// Coefficient i of the face.
Int coefficient(const ActiveFace& face, int i) { return Int(face.c[i]); }

// k0 x + k1 y + k2, by the face's coefficient numbers.
Int linear(const ActiveFace& f, int k0, int k1, int k2, const Int& x, const Int& y) {
  return coefficient(f, k0) * x + coefficient(f, k1) * y + coefficient(f, k2);
}

Depth depth_at(const ActiveFace& f, const Int& x, const Int& y) {
  Depth z;
  if (f.kind == FaceKind::plane) {
    z.p = -linear(f, 0, 1, 3, x, y);
    z.d = coefficient(f, 2);
    return z;
  }
  const Int b = linear(f, 5, 4, 8, x, y);
  // c = x (c0 x + c3 y + c6) + y (c3 x + c1 y + c7) + (c6 x + c7 y + c9)
  const Int c = x * linear(f, 0, 3, 6, x, y) + y * linear(f, 3, 1, 7, x, y) + linear(f, 6, 7, 9, x, y);
  if (f.kind == FaceKind::rational) {
    z.p = -c;
    z.d = b + b;
    if (z.d.negative()) {
      z.p = -z.p;
      z.d = -z.d;
    }
    return z;
  }
  z.p = -b;
  z.d = coefficient(f, 2);
  z.q = b * b - z.d * c;
  z.s = z.q.is_zero() ? 0 : f.sheet;
  return z;
}

// sign(P + R sqrt(q)), q >= 0.
int sign_of_radical(const Int& p, const Int& r, const Int& q) {
  const int sp = p.sign();
  const int sr = q.is_zero() ? 0 : r.sign();
  if (sp == 0 || sr == 0 || sp == sr) return sp != 0 ? sp : sr;
  return sp * (p * p - r * r * q).sign();
}

// sign(A + B sqrt(q1) + C sqrt(q2)): the sign of the roots' sum S against A, then A^2 against S^2.
int sign_of_two_radicals(const Int& a, const Int& b, const Int& q1, const Int& c, const Int& q2) {
  const Int b2q1 = b * b * q1;
  const Int c2q2 = c * c * q2;
  const int sb = b2q1.is_zero() ? 0 : b.sign();
  const int sc = c2q2.is_zero() ? 0 : c.sign();
  const int ss = sb == sc || sc == 0 ? sb : (sb == 0 ? sc : sb * (b2q1 - c2q2).sign());
  const int sa = a.sign();
  if (sa == 0 || ss == 0 || sa == ss) return sa != 0 ? sa : ss;
  // A^2 - S^2 = A^2 - B^2 q1 - C^2 q2 - 2 B C sqrt(q1 q2)
  const Int bc = b * c;
  return sa * sign_of_radical(a * a - b2q1 - c2q2, -(bc + bc), q1 * q2);
}

Int local(std::int32_t page, std::int32_t origin) { return static_cast<std::int64_t>(page) - origin; }

// U + V sqrt(q): one component of the normal, times d.
struct RootForm {
  Int u, v;
};

// d * (homogeneous page-frame gradient component j) at the face point.
RootForm gradient(const ActiveFace& f, int j, const Int& x, const Int& y, const Depth& z) {
  static constexpr std::uint8_t row[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};
  const Int slope = coefficient(f, row[j][2]);
  return {linear(f, row[j][0], row[j][1], row[j][3], x, y) * z.d + slope * z.p, slope * Int(z.s)};
}

}  // namespace

int compare_depth(const ActiveFace& f, const ActiveFace& g, std::int32_t x, std::int32_t y) {
  const Depth zf = depth_at(f, local(x, f.origin_x), local(y, f.origin_y));
  const Depth zg = depth_at(g, local(x, g.origin_x), local(y, g.origin_y));
  const Int shift = Int(f.origin_z) - Int(g.origin_z);
  return sign_of_two_radicals(shift * zf.d * zg.d + zf.p * zg.d - zg.p * zf.d, zg.d * Int(zf.s), zf.q,
                              zf.d * Int(-zg.s), zg.q);
}

bool reaches_level(const ActiveFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k,
                   std::int32_t x, std::int32_t y) {
  // threshold * |l| |N| <= (levels - 1) parallel s (l . N)
  const std::int64_t threshold =
      static_cast<std::int64_t>(k) * lighting.unit - static_cast<std::int64_t>(levels - 1) * lighting.ambient;
  if (threshold <= 0) return true;
  const Int lx = local(x, face.origin_x);
  const Int ly = local(y, face.origin_y);
  const Depth z = depth_at(face, lx, ly);
  std::array<RootForm, 4> g;
  for (int j = 0; j < 4; ++j) g[j] = gradient(face, j, lx, ly, z);
  // gw(page) = gw(local) - o . g
  const std::array<std::int64_t, 3> origin{face.origin_x, face.origin_y, face.origin_z};
  for (int j = 0; j < 3; ++j) {
    g[3].u -= Int(origin[j]) * g[j].u;
    g[3].v -= Int(origin[j]) * g[j].v;
  }
  RootForm light;  // l . N
  Int nu, nv;      // |N|^2 = nu + nv sqrt(q)
  std::int64_t l2 = 0;
  for (int i = 0; i < 3; ++i) {
    RootForm n;
    for (int j = 0; j < 4; ++j) {
      n.u += Int(lighting.matrix[i][j]) * g[j].u;
      n.v += Int(lighting.matrix[i][j]) * g[j].v;
    }
    nu += n.u * n.u + n.v * n.v * z.q;
    nv += n.u * n.v;
    light.u += Int(lighting.light[i]) * n.u;
    light.v += Int(lighting.light[i]) * n.v;
    l2 += static_cast<std::int64_t>(lighting.light[i]) * lighting.light[i];
  }
  if (face.light_sign * sign_of_radical(light.u, light.v, z.q) <= 0) return false;
  const Int scale = static_cast<std::int64_t>(levels - 1) * lighting.parallel;
  const Int scale2 = scale * scale;
  const Int t2 = Int(threshold) * Int(threshold) * Int(l2);
  const Int p = scale2 * (light.u * light.u + light.v * light.v * z.q) - t2 * nu;
  const Int half_r = scale2 * light.u * light.v - t2 * nv;
  return sign_of_radical(p, half_r + half_r, z.q) >= 0;
}

bool is_absent(const ActiveFace& face, std::int32_t x, std::int32_t y) {
  if (face.kind != FaceKind::rational) return false;
  return linear(face, 5, 4, 8, local(x, face.origin_x), local(y, face.origin_y)).is_zero();
}

}  // namespace halfspace
