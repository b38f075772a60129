#include "firmware/core/root_surface.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// What multiplies a gradient's component j in the normal's component i, in the page frame, where gw(page) = gw(local) - o . g.
using NormalMatrix = std::array<std::array<Wide<128>, 4>, 3>;

NormalMatrix normal_matrix(const ActiveFace& f, const Lighting& lighting) {
  const std::array<std::int64_t, 4> origin{f.origin_x, f.origin_y, f.origin_z, 0};
  NormalMatrix m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      m[i][j] = Wide<128>(lighting.matrix[i][j]) - Wide<128>(lighting.matrix[i][3]) * Wide<128>(origin[j]);
    }
  }
  return m;
}

int coefficient_bits(const ActiveFace& f) {
  int bits = 0;
  for (const Wide<128>& value : f.c) bits = std::max(bits, value.bit_length());
  return bits;
}

// Bits of the widest integer of a surface, |N|^2: with coefficients of c bits and factors of m, a gradient's u takes 2c + 1, the normal's
// 2c + m + 3 and v c + m + 2, three squares of u 4c + 2m + 9, and with v^2 D, D of 2c + 3, 4c + 2m + 11; and a sign.
int bits_needed(const ActiveFace& f, const NormalMatrix& matrix) {
  int m = 0;
  for (const auto& row : matrix) {
    for (const Wide<128>& value : row) m = std::max(m, value.bit_length());
  }
  return 4 * coefficient_bits(f) + 2 * m + 12;
}

Wide<128> shifted(const auto& value, int shift) { return Wide<128>(shift >= 0 ? value >> shift : value << -shift); }

// The forms of one face in integers of one width.
template <int Bits>
class Maker {
 public:
  struct Component {
    std::array<Wide<Bits>, 3> u{};
    Wide<Bits> v;
  };

  explicit Maker(const ActiveFace& face) : f_(face) {}

  void make_discriminant(ScaledQuadratic& out) const {
    const ExactQuadratic d = discriminant();
    scale_to(out, d, std::max(0, bits(d) - value_bits + 1) / 2 * 2);
  }

  void make(const Lighting& lighting, const NormalMatrix& matrix, RootSurface& s) const {
    const ExactQuadratic d = discriminant();
    Component light;
    ExactQuadratic square{};
    ExactLinear square_root{};
    Int v2;
    for (int i = 0; i < 3; ++i) {
      const Component n = normal(matrix[i]);
      const Int l(static_cast<std::int64_t>(lighting.light[i]) * f_.light_sign);
      for (int k = 0; k < 3; ++k) {
        light.u[k] += l * n.u[k];
        square_root[k] += (n.u[k] + n.u[k]) * n.v;
      }
      light.v += l * n.v;
      add_product(square, n.u, n.u);
      v2 += n.v * n.v;
    }
    for (int i = 0; i < 6; ++i) square[i] += v2 * d[i];

    const int half = s.discriminant.exponent / 2;
    const int root_bits = (bits(d) + 1) / 2;
    const int light_exponent = std::max(0, std::max(bits(light.u), light.v.bit_length() + root_bits) - value_bits);
    scale_to(s.light, light.u, light_exponent, light_exponent);
    s.light_root = shifted(light.v, light_exponent - half);
    const int square_exponent = std::max(0, std::max(bits(square), bits(square_root) + root_bits) - value_bits);
    scale_to(s.square, square, square_exponent);
    // Its values have fewer bits: it is rounded less, if at all.
    const int root_exponent = std::min(square_exponent, half + std::max(0, bits(square_root) - value_bits));
    scale_to(s.square_root, square_root, root_exponent, root_exponent - half);
  }

  [[nodiscard]] Component normal(const std::array<Wide<128>, 4>& row) const {
    Component n;
    for (int j = 0; j < 4; ++j) {
      const Int m(row[j]);
      if (m.is_zero()) continue;
      const Component g = gradient(j);
      for (int k = 0; k < 3; ++k) n.u[k] += m * g.u[k];
      n.v += m * g.v;
    }
    return n;
  }

 private:
  using Int = Wide<Bits>;
  using ExactQuadratic = std::array<Int, 6>;
  using ExactLinear = std::array<Int, 3>;
  // Bits that a form's value can have, its degree-2, degree-1 and constant terms in the order of ScaledQuadratic.
  static int bits(const ExactQuadratic& q) {
    constexpr int degree[6] = {2, 2, 2, 1, 1, 0};
    int most = 0;
    for (int i = 0; i < 6; ++i) most = std::max(most, q[i].bit_length() + degree[i] * coordinate_bits);
    return most + 3;
  }
  static int bits(const ExactLinear& q) {
    return 2 + std::max({q[0].bit_length() + coordinate_bits, q[1].bit_length() + coordinate_bits, q[2].bit_length()});
  }

  static void scale_to(ScaledQuadratic& out, const ExactQuadratic& q, int exponent) {
    out.exponent = static_cast<std::int16_t>(exponent);
    for (int i = 0; i < 6; ++i) out.q[i] = shifted(q[i], exponent);
  }
  static void scale_to(ScaledLinear& out, const ExactLinear& q, int exponent, int shift) {
    out.exponent = static_cast<std::int16_t>(exponent);
    for (int i = 0; i < 3; ++i) out.q[i] = shifted(q[i], shift);
  }

  // p q added to `sum`.
  static void add_product(ExactQuadratic& sum, const ExactLinear& p, const ExactLinear& q) {
    sum[0] += p[0] * q[0];
    sum[1] += p[0] * q[1] + p[1] * q[0];
    sum[2] += p[1] * q[1];
    sum[3] += p[0] * q[2] + p[2] * q[0];
    sum[4] += p[1] * q[2] + p[2] * q[1];
    sum[5] += p[2] * q[2];
  }

  [[nodiscard]] Int scale() const { return f_.kind == FaceKind::rational ? Int(1) : Int(f_.c[2]); }

  // a * gradient_j = u + v sqrt(D): row_j a - slope b + slope s sqrt(D).
  [[nodiscard]] Component gradient(int j) const {
    static constexpr std::uint8_t row[4][4] = {{0, 3, 6, 5}, {3, 1, 7, 4}, {5, 4, 8, 2}, {6, 7, 9, 8}};
    static constexpr std::uint8_t b[3] = {5, 4, 8};
    const Int a = scale();
    const Int slope(f_.c[row[j][3]]);
    Component g;
    for (int i = 0; i < 3; ++i) g.u[i] = a * Int(f_.c[row[j][i]]) - slope * Int(f_.c[b[i]]);
    g.v = f_.sheet < 0 ? -slope : slope;
    return g;
  }

  [[nodiscard]] ExactQuadratic discriminant() const {
    if (f_.kind == FaceKind::rational) return {Int(), Int(), Int(), Int(), Int(), Int(1)};
    const Int a(f_.c[2]);
    const ExactLinear b{Int(f_.c[5]), Int(f_.c[4]), Int(f_.c[8])};
    ExactQuadratic d{};
    add_product(d, b, b);
    static constexpr std::uint8_t rest[6] = {0, 3, 1, 6, 7, 9};
    for (int i = 0; i < 6; ++i) {
      const Int term = a * Int(f_.c[rest[i]]);
      d[i] -= i == 1 || i == 3 || i == 4 ? term + term : term;
    }
    return d;
  }

  const ActiveFace& f_;
};

}  // namespace

void make_discriminant(ActiveFace& face) {
  if (2 * coefficient_bits(face) + 4 <= 128) {
    Maker<128>(face).make_discriminant(face.surface.discriminant);
  } else {
    Maker<256>(face).make_discriminant(face.surface.discriminant);
  }
}

bool has_polynomial_normal(const ActiveFace& face, const Lighting& lighting) {
  return face.kind == FaceKind::rational && face.c[4].is_zero() && face.c[5].is_zero() &&
         std::all_of(std::begin(lighting.matrix), std::end(lighting.matrix),
                     [](const auto& row) { return row[3] == 0; });
}

void make_root_surface(ActiveFace& face, const Lighting& lighting) {
  const NormalMatrix matrix = normal_matrix(face, lighting);
  if (bits_needed(face, matrix) <= 256) {
    Maker<256>(face).make(lighting, matrix, face.surface);
  } else {
    Maker<512>(face).make(lighting, matrix, face.surface);
  }
}

}  // namespace halfspace
