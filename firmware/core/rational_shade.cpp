// A quadric without z^2: z = p(x) / d(x) on a scan line, p quadratic and d linear, and N = d * normal quadratic in x.
// Registers  The components N_i and L, each under 2^30 with 32 bits of fraction: second order, no root.
// Errors     n dots round a component by n^2 2^-32 + 2 units at most: 4 in all.

#include <algorithm>
#include <array>

#include "firmware/core/level_search.hpp"
#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/reaches_level.hpp"
#include "firmware/core/root_surface.hpp"
#include "firmware/core/stride.hpp"

namespace halfspace {
namespace {

using Int = Wide<256>;

// u2 x^2 + u1 x + u0, x counted from the span's first dot.
struct Quadratic {
  Int u2, u1, u0;

  [[nodiscard]] Int at(std::int64_t x) const { return (u2 * Int(x) + u1) * Int(x) + u0; }
  // Bits that hold its values on n dots (root_shade.cpp, LineQuadratic).
  [[nodiscard]] int bits(std::int64_t n) const {
    return 1 + std::max({u0.bit_length(), at(n / 2).bit_length(), at(n).bit_length()});
  }
  void add(const Int& m, const Quadratic& o) {
    u2 += m * o.u2;
    u1 += m * o.u1;
    u0 += m * o.u0;
  }
};

// z = p / (d1 x + d0) on the line, with d > 0: b keeps one sign inside a cell.
struct LineDepth {
  Quadratic p;
  Int d1, d0;
};

LineDepth line_depth(const ActiveFace& f, const Int& x, const Int& y) {
  const auto c = [&f](int i) { return Int(f.c[i]); };
  const auto twice = [](const Int& a) { return a + a; };
  const Int b = c(5) * x + c(4) * y + c(8);
  const Quadratic rest{c(0), twice(c(0) * x + c(3) * y + c(6)),
                       x * (c(0) * x + twice(c(3) * y + c(6))) + y * (c(1) * y + twice(c(7))) + c(9)};
  const Int sign = b.negative() ? -1 : 1;
  LineDepth z;
  z.d1 = sign * twice(c(5));
  z.d0 = sign * twice(b);
  z.p.add(-sign, rest);
  return z;
}

// The three components of N, exact.
std::array<Quadratic, 3> line_normal(const ActiveFace& f, const Lighting& lighting, const Int& x, const Int& y) {
  static constexpr std::uint8_t row[4][4] = {{0, 3, 6, 5}, {3, 1, 7, 4}, {5, 4, 8, 2}, {6, 7, 9, 8}};
  const LineDepth z = line_depth(f, x, y);
  const std::array<std::int64_t, 4> origin{f.origin_x, f.origin_y, f.origin_z, 0};
  std::array<Quadratic, 3> n;
  for (int j = 0; j < 4; ++j) {
    // d * gradient_j = (g1 x + g0) d + slope p
    const Int slope(f.c[row[j][3]]);
    const Int g1(f.c[row[j][0]]);
    const Int g0 = g1 * x + Int(f.c[row[j][1]]) * y + Int(f.c[row[j][2]]);
    Quadratic g{g1 * z.d1, g1 * z.d0 + g0 * z.d1, g0 * z.d0};
    g.add(slope, z.p);
    for (int i = 0; i < 3; ++i) {
      // gw(page) = gw(local) - o . g
      n[i].add(Int(lighting.matrix[i][j]) - Int(lighting.matrix[i][3]) * Int(origin[j]), g);
    }
  }
  return n;
}

// Unsigned, so that a job that lies about its widths wraps and nothing worse.
struct Registers {
  std::uint64_t r, d1, d2;

  Registers() = default;
  Registers(const Quadratic& q, int shift)
      : r(fixed(q.u0, shift)), d1(fixed(q.u1 + q.u2, shift)), d2(fixed(q.u2 + q.u2, shift)) {}
  void step() {
    r += d1;
    d1 += d2;
  }
  void skip(std::int32_t t) { jump(r, d1, d2, t); }
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(r) >> 32; }

 private:
  static std::uint64_t fixed(const Int& v, int shift) { return static_cast<std::uint64_t>(scaled(v, shift - 32)); }
};

// The registers of L and N at one dot of the span.
class SpanShader {
 public:
  SpanShader(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) : job_(job), y_(y) {
    const std::int64_t lx = static_cast<std::int64_t>(x0) - job.face.origin_x;
    const std::int64_t ly = static_cast<std::int64_t>(y) - job.face.origin_y;
    const std::array<Quadratic, 3> normal = line_normal(job.face, job.lighting, lx, ly);
    Quadratic light;
    int bits = 0;
    for (int i = 0; i < 3; ++i) {
      light.add(Int(job.lighting.light[i]) * Int(job.face.light_sign), normal[i]);
      bits = std::max(bits, normal[i].bits(x1 - x0 + 1));
    }
    const int shift = bits + 1 - 30;
    for (int i = 0; i < 3; ++i) n_[i] = Registers(normal[i], shift);
    l_ = Registers(light, shift + job.table.light_bits);
  }

  void step() {
    for (Registers& component : n_) component.step();
    l_.step();
  }
  void skip(std::int32_t t) {
    for (Registers& component : n_) component.skip(t);
    l_.skip(t);
  }
  // Of the dot x where the registers stand, sought from `level`.
  [[nodiscard]] std::int32_t level_at(std::int32_t x, std::int32_t level) const {
    Light here{l_.value(), 0};
    std::int64_t sizes = 0;
    for (const Registers& component : n_) {
      const std::int64_t n = component.value();
      sizes += n < 0 ? -n : n;
      here.n2 += n * n;
    }
    const Margin margin = lit_margin(here, sizes, component_error);
    return search_level(job_.table, level, [&](std::int32_t k) {
      const Answer answer = compare(here, margin, job_.table.squares[static_cast<std::size_t>(k)]);
      return answer == Answer::unsure ? reaches_level(job_, x, y_, k) : answer == Answer::yes;
    });
  }

 private:
  const ShadeJob& job_;
  std::int32_t y_;
  std::array<Registers, 3> n_;
  Registers l_;
  static constexpr std::int64_t component_error = 4;
};

void sample_span(const ShadeJob& job, SpanShader shader, std::int32_t x0, std::int32_t x1) {
  const std::int32_t stride = stride_in(x0, x1, job.stride);
  SampledLevels samples(job, x0);
  samples.add(x0, shader.level_at(x0, -1));
  for (std::int32_t x = x0; x < x1;) {
    const std::int32_t t = std::min(stride, x1 - x);
    shader.skip(t);
    x += t;
    samples.add(x, shader.level_at(x, samples.level()));
  }
  samples.finish();
}

}  // namespace

void shade_rational_span(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  SpanShader line(job, y, x0, x1);
  if (shader == Shader::stride) return sample_span(job, line, x0, x1);
  paint_levels(job, x0, x1, [&line](std::int32_t x, std::int32_t level) {
    const std::int32_t k = line.level_at(x, level);
    line.step();
    return k;
  });
}

namespace {

// For contours.
void enter(ActiveFace& face, const Lighting& lighting) {
  if (!has_polynomial_normal(face, lighting)) return;
  make_discriminant(face);
  make_root_surface(face, lighting);
}

}  // namespace

const FaceModule rational_faces{&enter, &shade_rational_span};

}  // namespace halfspace
