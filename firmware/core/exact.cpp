#include "firmware/core/exact.hpp"

#include "firmware/core/radical_sign.hpp"

namespace halfspace {
namespace {

// Stack  A 768-bit number takes 96 bytes, and these functions run on controllers with a few KB of stack. So sums grow in
//        place, and each stage is a frame of its own that is gone before the next one begins: never inlined.
#define HALFSPACE_STAGE [[gnu::noinline]]

// All of it in integers of one width.
template <int Bits>
struct Exact {
  using Int = Wide<Bits>;

  // A depth z = (p + s sqrt(q)) / d with d > 0, q >= 0, s in {-1, 0, 1}; local to the face's frame.
  struct Depth {
    Int p, q, d;
    int s = 0;
  };

  static Int coefficient(const ActiveFace& face, int i) { return Int(face.c[i]); }

  // k0 x + k1 y + k2, by the face's coefficient numbers.
  HALFSPACE_STAGE static Int linear(const ActiveFace& f, int k0, int k1, int k2, std::int64_t x, std::int64_t y) {
    Int sum = coefficient(f, k0) * Int(x);
    sum += coefficient(f, k1) * Int(y);
    sum += coefficient(f, k2);
    return sum;
  }

  // x (c0 x + c3 y + c6) + y (c3 x + c1 y + c7) + (c6 x + c7 y + c9)
  HALFSPACE_STAGE static Int quadratic(const ActiveFace& f, std::int64_t x, std::int64_t y) {
    Int sum = linear(f, 0, 3, 6, x, y) * Int(x);
    sum += linear(f, 3, 1, 7, x, y) * Int(y);
    sum += linear(f, 6, 7, 9, x, y);
    return sum;
  }

  HALFSPACE_STAGE static Depth depth_at(const ActiveFace& f, std::int64_t x, std::int64_t y) {
    Depth z;
    if (f.kind == FaceKind::plane) {
      z.p = -linear(f, 0, 1, 3, x, y);
      z.d = coefficient(f, 2);
      return z;
    }
    z.p = linear(f, 5, 4, 8, x, y);  // b
    z.q = quadratic(f, x, y);        // c
    if (f.kind == FaceKind::rational) {
      z.d = z.p + z.p;
      z.p = -z.q;
      z.q = Int();
      if (z.d.negative()) {
        z.p = -z.p;
        z.d = -z.d;
      }
      return z;
    }
    z.d = coefficient(f, 2);
    z.q = z.p * z.p - z.d * z.q;
    z.p = -z.p;
    z.s = z.q.is_zero() ? 0 : f.sheet;
    return z;
  }

  // sign(A + B sqrt(q1) + C sqrt(q2)): the sign of the roots' sum S against A, then A^2 against S^2.
  HALFSPACE_STAGE static int sign_of_two_radicals(const Int& a, const Int& b, const Int& q1, const Int& c,
                                                  const Int& q2) {
    const Int b2q1 = b * b * q1;
    const Int c2q2 = c * c * q2;
    const int sb = b2q1.is_zero() ? 0 : b.sign();
    const int sc = c2q2.is_zero() ? 0 : c.sign();
    const int ss = sb == sc || sc == 0 ? sb : (sb == 0 ? sc : sb * (b2q1 - c2q2).sign());
    const int sa = a.sign();
    if (sa == 0 || ss == 0 || sa == ss) return sa != 0 ? sa : ss;
    // A^2 - S^2 = A^2 - B^2 q1 - C^2 q2 - 2 B C sqrt(q1 q2)
    const Int bc = b * c;
    return sa * sign_of_radical<Bits>(a * a - b2q1 - c2q2, -(bc + bc), q1 * q2);
  }

  static std::int64_t local(std::int32_t page, std::int32_t origin) { return static_cast<std::int64_t>(page) - origin; }

  // U + V sqrt(q).
  struct RootForm {
    Int u, v;
  };

  // d * (homogeneous gradient component j, in the face's frame) at the face point.
  HALFSPACE_STAGE static RootForm gradient(const ActiveFace& f, int j, std::int64_t x, std::int64_t y, const Depth& z) {
    static constexpr std::uint8_t row[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};
    const Int slope = coefficient(f, row[j][2]);
    RootForm g{linear(f, row[j][0], row[j][1], row[j][3], x, y) * z.d, slope * Int(z.s)};
    g.u += slope * z.p;
    return g;
  }

  // d N = M g, g in the page frame: gw(page) = gw(local) - o . g, so M's last column times -o joins the other three.
  HALFSPACE_STAGE static std::array<RootForm, 3> normal_at(const ActiveFace& face, const Lighting& lighting,
                                                           std::int64_t x, std::int64_t y, const Depth& z) {
    const std::array<std::int64_t, 4> origin{face.origin_x, face.origin_y, face.origin_z, 0};
    std::array<RootForm, 3> n;
    for (int j = 0; j < 4; ++j) {
      const RootForm g = gradient(face, j, x, y, z);
      for (int i = 0; i < 3; ++i) {
        const Int m = Int(lighting.matrix[i][j]) - Int(lighting.matrix[i][3]) * Int(origin[j]);
        n[i].u += m * g.u;
        n[i].v += m * g.v;
      }
    }
    return n;
  }

  // What the level at a face point depends on: d (l . N), d^2 |N|^2, and q.
  struct LitNormal {
    RootForm light, square;
    Int q;
  };

  HALFSPACE_STAGE static LitNormal lit_normal(const ActiveFace& face, const Lighting& lighting, std::int64_t x,
                                              std::int64_t y, const Depth& z) {
    const std::array<RootForm, 3> n = normal_at(face, lighting, x, y, z);
    LitNormal lit;
    for (int i = 0; i < 3; ++i) {
      const Int l(lighting.light[i] * face.light_sign);
      lit.light.u += l * n[i].u;
      lit.light.v += l * n[i].v;
      lit.square.u += n[i].u * n[i].u;
      lit.square.u += n[i].v * n[i].v * z.q;
      lit.square.v += n[i].u * n[i].v;
    }
    lit.square.v += lit.square.v;
    lit.q = z.q;
    return lit;
  }

  // The same by the face's polynomials, where they were not rounded: they are of these numbers.
  HALFSPACE_STAGE static LitNormal lit_surface(const RootSurface& s, std::int32_t x, std::int32_t y) {
    return {{Int(s.light.at(x, y)), Int(s.light_root)},
            {Int(s.square.at(x, y)), Int(s.square_root.at(x, y))},
            Int(s.discriminant.at(x, y))};
  }

  HALFSPACE_STAGE static LitNormal lit_at(const ActiveFace& face, const Lighting& lighting, std::int32_t x,
                                          std::int32_t y) {
    if (face.kind == FaceKind::root && face.ready && face.surface.is_exact()) return lit_surface(face.surface, x, y);
    return lit_normal(face, lighting, x, y, depth_at(face, x, y));
  }

  // sign(scale^2 (l . N)^2 - t2 |N|^2)
  HALFSPACE_STAGE static int sign_against(const LitNormal& lit, std::int64_t scale, const Int& t2) {
    const Int scale2 = Int(scale) * Int(scale);
    Int p = lit.light.v * lit.light.v * lit.q;
    p += lit.light.u * lit.light.u;
    p = p * scale2;
    p -= t2 * lit.square.u;
    Int r = lit.light.u * lit.light.v;
    r += r;
    r = r * scale2;
    r -= t2 * lit.square.v;
    return sign_of_radical<Bits>(p, r, lit.q);
  }

  static int compare_depth(const ActiveFace& f, const ActiveFace& g, std::int32_t x, std::int32_t y) {
    const Depth zf = depth_at(f, local(x, f.origin_x), local(y, f.origin_y));
    const Depth zg = depth_at(g, local(x, g.origin_x), local(y, g.origin_y));
    const Int shift = Int(f.origin_z) - Int(g.origin_z);
    return sign_of_two_radicals(shift * zf.d * zg.d + zf.p * zg.d - zg.p * zf.d, zg.d * Int(zf.s), zf.q,
                                zf.d * Int(-zg.s), zg.q);
  }

  static bool reaches_level(const ActiveFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k,
                            std::int32_t x, std::int32_t y) {
    // threshold * |l| |N| <= (levels - 1) parallel s (l . N)
    const std::int64_t threshold =
        static_cast<std::int64_t>(k) * lighting.unit - static_cast<std::int64_t>(levels - 1) * lighting.ambient;
    if (threshold <= 0) return true;
    const LitNormal lit = lit_at(face, lighting, x - face.origin_x, y - face.origin_y);
    if (sign_of_radical<Bits>(lit.light.u, lit.light.v, lit.q) <= 0) return false;
    std::int64_t l2 = 0;
    for (const std::int64_t l : lighting.light) l2 += l * l;
    const std::int64_t scale = static_cast<std::int64_t>(levels - 1) * lighting.parallel;
    return sign_against(lit, scale, Int(threshold) * Int(threshold) * Int(l2)) >= 0;
  }
};

template <int Bits>
constexpr ExactModule module_of{Bits, &Exact<Bits>::compare_depth, &Exact<Bits>::reaches_level};

}  // namespace

const ExactModule exact_384 = module_of<384>;
const ExactModule exact_768 = module_of<768>;
const ExactModule exact_1152 = module_of<1152>;

bool is_absent(const ActiveFace& face, std::int32_t x, std::int32_t y) {
  if (face.kind != FaceKind::rational) return false;
  return (face.c[5].times(x - face.origin_x) + face.c[4].times(y - face.origin_y) + face.c[8]).is_zero();
}

}  // namespace halfspace
