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

int coefficient_bits(const ActiveFace& f, std::size_t from, std::size_t end) {
  int bits = 0;
  for (std::size_t i = from; i < end; ++i) bits = std::max(bits, f.c[i].bit_length());
  return bits;
}

// Of the widest integers of a face's forms, without a sign: of those that are linear in a gradient and of D; and of products of two of them.
struct FormBits {
  int linear, square;
};

// With coefficients of c2, c1 and c0 bits by degree, D takes what two of them and 2 bits do, u one less, and the normal 2 more than u and v with
// factors of m bits: four terms. Light adds three of those times numbers of 16 bits. |N|^2 takes six products of u or three of v^2 D.
FormBits bits_needed(const ActiveFace& f, const NormalMatrix& matrix) {
  int m = 0;
  bool is_affine = true;
  for (const auto& row : matrix) {
    for (const Wide<128>& value : row) m = std::max(m, value.bit_length());
    is_affine = is_affine && row[3].is_zero();
  }
  const int c2 = coefficient_bits(f, 0, 6);
  const int high = std::max(c2, coefficient_bits(f, 6, 9));
  const int all = std::max(high, coefficient_bits(f, 9, 10));
  const int d = std::max(2 * high, c2 + all) + 2;
  const int u = (is_affine ? c2 + high : d - 2) + 1 + m + 2;
  const int v = (is_affine ? c2 : high) + m + 2;
  return {std::max(d, u + 18), std::max(2 * u + 3, 2 * v + 2 + d) + 1};
}

Wide<128> shifted(const auto& value, int shift) { return Wide<128>(shift >= 0 ? value >> shift : value << -shift); }

// The forms of one face in integers of one width, and of twice as much for products of two of them.
template <int Bits>
class Maker {
 public:
  explicit Maker(const ActiveFace& face) : f_(face) {}

  void make_discriminant(ScaledQuadratic& out) const {
    const Quadratic<Int> d = discriminant();
    scale_to(out, d, std::max(0, bits(d) - value_bits + 1) / 2 * 2);
  }

  void make(const Lighting& lighting, const NormalMatrix& matrix, RootSurface& s) const {
    const Quadratic<Int> d = discriminant();
    const std::array<Component, 3> normal = normal_by(matrix);
    Component light;
    Quadratic<Product> square{};
    Linear<Product> square_root{};
    Product v2;
    for (int i = 0; i < 3; ++i) {
      const Component& n = normal[i];
      const std::int32_t l = lighting.light[i] * f_.light_sign;
      for (int k = 0; k < 3; ++k) {
        light.u[k] += n.u[k].times(l);
        square_root[k] += (n.u[k] + n.u[k]).full_product(n.v);
      }
      light.v += n.v.times(l);
      add_square(square, n.u);
      v2 += n.v.full_product(n.v);
    }
    for (int i = 0; i < 6; ++i) square[i] += v2 * Product(d[i]);

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

 private:
  using Int = Wide<Bits>;
  using Product = Wide<2 * Bits>;
  template <class Number>
  using Quadratic = std::array<Number, 6>;
  template <class Number>
  using Linear = std::array<Number, 3>;
  struct Component {
    Linear<Int> u{};
    Int v;
  };

  // Bits that a form's value can have, its degree-2, degree-1 and constant terms in the order of ScaledQuadratic.
  template <class Number>
  static int bits(const Quadratic<Number>& q) {
    constexpr int degree[6] = {2, 2, 2, 1, 1, 0};
    int most = 0;
    for (int i = 0; i < 6; ++i) most = std::max(most, q[i].bit_length() + degree[i] * coordinate_bits);
    return most + 3;
  }
  template <class Number>
  static int bits(const Linear<Number>& q) {
    return 2 + std::max({q[0].bit_length() + coordinate_bits, q[1].bit_length() + coordinate_bits, q[2].bit_length()});
  }

  template <class Number>
  static void scale_to(ScaledQuadratic& out, const Quadratic<Number>& q, int exponent) {
    out.exponent = static_cast<std::int16_t>(exponent);
    for (int i = 0; i < 6; ++i) out.q[i] = shifted(q[i], exponent);
  }
  template <class Number>
  static void scale_to(ScaledLinear& out, const Linear<Number>& q, int exponent, int shift) {
    out.exponent = static_cast<std::int16_t>(exponent);
    for (int i = 0; i < 3; ++i) out.q[i] = shifted(q[i], shift);
  }

  // p^2 added to `sum`.
  static void add_square(Quadratic<Product>& sum, const Linear<Int>& p) {
    const Int twice_x = p[0] + p[0];
    sum[0] += p[0].full_product(p[0]);
    sum[1] += twice_x.full_product(p[1]);
    sum[2] += p[1].full_product(p[1]);
    sum[3] += twice_x.full_product(p[2]);
    sum[4] += (p[1] + p[1]).full_product(p[2]);
    sum[5] += p[2].full_product(p[2]);
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

  [[nodiscard]] std::array<Component, 3> normal_by(const NormalMatrix& matrix) const {
    std::array<Component, 3> normal{};
    for (int j = 0; j < 4; ++j) {
      if (matrix[0][j].is_zero() && matrix[1][j].is_zero() && matrix[2][j].is_zero()) continue;
      const Component g = gradient(j);
      for (int i = 0; i < 3; ++i) {
        const Int m(matrix[i][j]);
        if (m.is_zero()) continue;
        for (int k = 0; k < 3; ++k) normal[i].u[k] += m * g.u[k];
        normal[i].v += m * g.v;
      }
    }
    return normal;
  }

  [[nodiscard]] Quadratic<Int> discriminant() const {
    if (f_.kind == FaceKind::rational) return {Int(), Int(), Int(), Int(), Int(), Int(1)};
    const Int a(f_.c[2]);
    const Linear<Int> b{Int(f_.c[5]), Int(f_.c[4]), Int(f_.c[8])};
    const Int twice_x = b[0] + b[0];
    Quadratic<Int> d{b[0] * b[0], twice_x * b[1], b[1] * b[1], twice_x * b[2], (b[1] + b[1]) * b[2], b[2] * b[2]};
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
  if (2 * coefficient_bits(face, 0, face.c.size()) + 4 <= 128) {
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
  const FormBits needed = bits_needed(face, matrix);
  if (needed.linear < 128 && needed.square < 256) {
    Maker<128>(face).make(lighting, matrix, face.surface);
  } else {
    Maker<256>(face).make(lighting, matrix, face.surface);
  }
}

}  // namespace halfspace
