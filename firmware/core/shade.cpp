#include "firmware/core/shade.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/exact.hpp"
#include "firmware/core/isqrt.hpp"
#include "firmware/core/registers.hpp"

namespace halfspace {
namespace {

using Int = Wide<256>;

// u2 x^2 + u1 x + u0, x counted from the span's first dot.
struct Quadratic {
  Int u2, u1, u0;

  [[nodiscard]] Int at(std::int64_t x) const { return (u2 * Int(x) + u1) * Int(x) + u0; }
  // Bits that hold its values on 0 .. n: a quadratic exceeds the largest of three equally spaced values by at most a quarter.
  [[nodiscard]] int bits(std::int64_t n) const {
    return 1 + std::max({u0.bit_length(), at(n / 2).bit_length(), at(n).bit_length()});
  }
};

// The face restricted to the scan line: N_i = u[i] + v[i] sqrt(D), exact.
struct Slice {
  std::array<Quadratic, 3> u;
  std::array<Int, 3> v;
  Quadratic discriminant;
};

// Coefficient rows of the homogeneous gradient: x, y, z, 1.
constexpr std::uint8_t gradient_row[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};

// The depth z = (p + s sqrt(D)) / d on the line, as polynomials in x.
struct LineDepth {
  Quadratic p;
  Int d1, d0;  // d = d1 x + d0
  Quadratic discriminant;
  int s = 0;
};

LineDepth line_depth(const ActiveFace& f, const Int& x, const Int& y) {
  const auto c = [&f](int i) { return Int(f.c[i]); };
  const auto twice = [](const Int& a) { return a + a; };
  const Int b1 = c(5);
  const Int b0 = c(5) * x + c(4) * y + c(8);
  const Quadratic rest{c(0), twice(c(0) * x + c(3) * y + c(6)),
                       x * (c(0) * x + twice(c(3) * y + c(6))) + y * (c(1) * y + twice(c(7))) + c(9)};
  LineDepth z;
  if (f.kind == FaceKind::rational) {
    // One sign of d over the span: b does not vanish inside a cell.
    const bool flip = b0.negative();
    z.d1 = flip ? -twice(b1) : twice(b1);
    z.d0 = flip ? -twice(b0) : twice(b0);
    z.p = flip ? rest : Quadratic{-rest.u2, -rest.u1, -rest.u0};
    return z;
  }
  const Int a = c(2);
  z.d0 = a;
  z.p = {Int(), -b1, -b0};
  z.discriminant = {b1 * b1 - a * rest.u2, twice(b1 * b0) - a * rest.u1, b0 * b0 - a * rest.u0};
  z.s = f.sheet;
  return z;
}

Slice make_slice(const ActiveFace& f, const Lighting& lighting, std::int32_t y, std::int32_t x0) {
  const Int lx = static_cast<std::int64_t>(x0) - f.origin_x;
  const Int ly = static_cast<std::int64_t>(y) - f.origin_y;
  const LineDepth z = line_depth(f, lx, ly);
  Slice slice;
  slice.discriminant = z.discriminant;
  const std::array<std::int64_t, 3> origin{f.origin_x, f.origin_y, f.origin_z};
  for (int j = 0; j < 4; ++j) {
    const std::uint8_t* row = gradient_row[j];
    const Int slope = Int(f.c[row[2]]);
    const Int g1 = Int(f.c[row[0]]);
    const Int g0 = g1 * lx + Int(f.c[row[1]]) * ly + Int(f.c[row[3]]);
    // d * gradient_j = (g1 x + g0)(d1 x + d0) + slope (p + s sqrt(D))
    const Quadratic u{g1 * z.d1 + slope * z.p.u2, g1 * z.d0 + g0 * z.d1 + slope * z.p.u1, g0 * z.d0 + slope * z.p.u0};
    const Int v = slope * Int(z.s);
    for (int i = 0; i < 3; ++i) {
      // The local frame's share of the page-frame matrix: gw(page) = gw(local) - o . g.
      Int m = lighting.matrix[i][j];
      if (j < 3) m -= Int(lighting.matrix[i][3]) * Int(origin[j]);
      if (m.is_zero()) continue;
      slice.u[i].u2 += m * u.u2;
      slice.u[i].u1 += m * u.u1;
      slice.u[i].u0 += m * u.u0;
      slice.v[i] += m * v;
    }
  }
  return slice;
}

// One component of N (or L) in 64-bit registers: (u >> 32) + (m * s >> 30), off by at most error(e) when s is off by e.
struct Component {
  SecondOrder<std::int64_t> u;
  std::int64_t m = 0;
  std::int64_t rounding = 0;

  [[nodiscard]] std::int64_t value(std::int64_t s) const { return (u.r >> 32) + (m * s >> 30); }
  [[nodiscard]] std::int64_t error(std::int64_t root_error) const {
    return ((m < 0 ? -m : m) * root_error >> 30) + rounding;
  }
};

constexpr int root_bits = 30;       // s < 2^30
constexpr int component_bits = 30;  // |N_i| < 2^30, |L| < 2^31

struct Registers {
  std::array<Component, 3> n;
  Component light;
  std::int64_t d = 0, d1 = 0, d2 = 0;  // D and its differences, scaled by 2^-2h
  int root_shift = 0;                  // h: sqrt(D) = s 2^h
  int depth_shift = 0;                 // log2 of s units in a dot of z, about: Jordan's step
  bool grazing = false;                // L = 0 on the whole span: a cylinder lit along its axis
};

Component make_component(const Quadratic& u, const Int& v, int shift, int h, std::int64_t n) {
  Component c;
  c.u.r = scaled(u.u0, shift - 32);
  c.u.x = scaled(u.u1 + u.u2, shift - 32);
  c.u.xx = scaled(u.u2 + u.u2, shift - 32);
  c.m = scaled(v, shift - h - 30);
  c.rounding = ((n * n + 2 * n) >> 32) + 4;
  return c;
}

Registers make_registers(const ActiveFace& face, const Slice& slice, const Lighting& lighting, const LevelTable& table,
                         std::int64_t n) {
  Registers r;
  const int d_bits = slice.discriminant.bits(n);
  r.root_shift = (d_bits - 2 * root_bits + 1) >> 1;
  r.d = scaled(slice.discriminant.u0, 2 * r.root_shift);
  r.d1 = scaled(slice.discriminant.u1 + slice.discriminant.u2, 2 * r.root_shift);
  r.d2 = scaled(slice.discriminant.u2 + slice.discriminant.u2, 2 * r.root_shift);
  r.depth_shift = std::clamp(face.c[2].bit_length() - r.root_shift - 2, 8, 24);
  Quadratic light;
  Int light_v;
  int bits = 0;
  for (int i = 0; i < 3; ++i) {
    const Int l = lighting.light[i] * face.light_sign;
    light.u2 += l * slice.u[i].u2;
    light.u1 += l * slice.u[i].u1;
    light.u0 += l * slice.u[i].u0;
    light_v += l * slice.v[i];
    bits = std::max({bits, slice.u[i].bits(n), slice.v[i].bit_length() + r.root_shift + root_bits});
  }
  r.grazing = light.u2.is_zero() && light.u1.is_zero() && light.u0.is_zero() && light_v.is_zero();
  const int shift = bits + 1 - component_bits;
  for (int i = 0; i < 3; ++i) {
    r.n[i] = make_component(slice.u[i], slice.v[i], shift, r.root_shift, n);
  }
  r.light = make_component(light, light_v, shift + table.light_bits, r.root_shift, n);
  return r;
}

// floor(sqrt(d)) to within one unit, from the roots of the three dots before: their second difference
// predicts it to a few units, and one division corrects the rest.
class RootWalk {
 public:
  std::int64_t next(std::int64_t d) {
    if (d <= 0) {
      known_ = 0;
      return 0;
    }
    std::int64_t s = known_ == 3 ? 3 * (s_[0] - s_[1]) + s_[2] : 0;
    if (s < 1 || s > (std::int64_t{1} << 31) || !close(s, d)) s = isqrt(static_cast<std::uint64_t>(d));
    s_[2] = s_[1];
    s_[1] = s_[0];
    s_[0] = s;
    if (known_ < 3) ++known_;
    return s;
  }

 private:
  // Two Newton steps at most; true when |s - sqrt(d)| < 1.
  static bool close(std::int64_t& s, std::int64_t d) {
    for (int i = 0; i < 3; ++i) {
      const std::int64_t rest = d - s * s;
      if (rest <= s && -rest <= s) return true;
      s += rest / (2 * s);
      if (s < 1) return false;
    }
    return false;
  }
  std::int64_t s_[3] = {};
  int known_ = 0;
};

// Jordan's incremental conic s^2 = D(x): s moves by steps of one unit, found by additions and comparisons
// only. gap = D - s^2 with s counted in units of 2^shift.
class JordanWalk {
 public:
  JordanWalk(std::int64_t d, int shift) : shift_(shift), last_(std::max<std::int64_t>(d, 0)) {
    const auto root = static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(last_)));
    s_ = root >> shift_;
    gap_ = last_ - ((s_ * s_) << (2 * shift_));
    odd_ = (2 * s_ + 1) << (2 * shift_);
    unit_ = std::int64_t{2} << (2 * shift_);
  }
  // The middle of the unit that holds sqrt(d).
  std::int64_t next(std::int64_t d) {
    const std::int64_t floor_d = std::max<std::int64_t>(d, 0);
    gap_ += floor_d - last_;
    last_ = floor_d;
    while (gap_ < 0) {
      odd_ -= unit_;
      gap_ += odd_;
      --s_;
    }
    while (gap_ >= odd_) {
      gap_ -= odd_;
      odd_ += unit_;
      ++s_;
    }
    return (s_ << shift_) + ((std::int64_t{1} << shift_) >> 1);
  }

 private:
  int shift_;
  std::int64_t last_, s_ = 0, gap_ = 0, odd_ = 0, unit_ = 0;
};

// (t * a) >> 32 for a < 2^63: two 32-bit products.
std::uint64_t scale_by(std::uint32_t t, std::uint64_t a) { return t * (a >> 32) + ((t * (a & 0xffffffffU)) >> 32); }

// L and |N|^2 at a dot.
struct Light {
  std::int64_t l = 0;
  std::uint64_t l2 = 0, n2 = 0;
};

// What L, and L^2 - t |N|^2, must exceed to be certain.
struct Margin {
  std::int64_t light = 0;
  std::int64_t squares = 0;
};

constexpr int yes = 1, no = 0, unsure = -1;

class SpanShader {
 public:
  SpanShader(const ActiveFace& face, const Lighting& lighting, const LevelTable& table, std::int32_t y, std::int32_t x0,
             std::int32_t x1, Counters& counters)
      : face_(face),
        lighting_(lighting),
        table_(table),
        y_(y),
        x0_(x0),
        x1_(x1),
        counters_(counters),
        r_(make_registers(face, make_slice(face, lighting, y, x0), lighting, table, x1 - x0 + 1)) {
    // D is off by at most n^2 / 2 + n + 1: sqrt(D) by its root, and by one unit at most from s = n^2 on.
    const std::int64_t n = x1 - x0 + 1;
    deep_from_ = n * n + 2 * n;
    deep_ = margin_for(3);
    shallow_ = margin_for(n + 3);
  }

  void run(Shader shader, RowPainter& painter) {
    if (r_.grazing) {
      paint(painter, x0_, x1_, table_.ambient_level);
    } else if (shader == Shader::jordan && face_.kind == FaceKind::root) {
      JordanWalk walk(r_.d, r_.depth_shift);
      const std::int64_t half_unit = (std::int64_t{1} << r_.depth_shift) >> 1;
      const Margin coarse = margin_for(half_unit + (x1_ - x0_) + 4);
      sweep(painter,
            [&](std::int32_t x, std::int32_t level) { return level_of(light_at(walk.next(r_.d)), coarse, x, level); });
    } else {
      RootWalk walk;
      sweep(painter, [&](std::int32_t x, std::int32_t level) {
        const std::int64_t s = walk.next(r_.d);
        return level_of(light_at(s), fine_margin(s), x, level);
      });
    }
  }

 private:
  template <class LevelAt>
  void sweep(RowPainter& painter, LevelAt level_at) {
    std::int32_t from = x0_;
    std::int32_t level = -1;
    for (std::int32_t x = x0_; x <= x1_; ++x) {
      const std::int32_t k = level_at(x, level);
      if (k != level) {
        if (level >= 0) paint(painter, from, x - 1, level);
        from = x;
        level = k;
      }
      step();
    }
    paint(painter, from, x1_, level);
    counters_.intensities += static_cast<std::uint32_t>(x1_ - x0_ + 1);
  }

  void paint(RowPainter& painter, std::int32_t x0, std::int32_t x1, std::int32_t level) {
    ++counters_.level_spans;
    painter.fill(x0, x1, level);
  }

  void step() {
    r_.d += r_.d1;
    r_.d1 += r_.d2;
    for (Component& c : r_.n) {
      c.u.r += c.u.x;
      c.u.x += c.u.xx;
    }
    r_.light.u.r += r_.light.u.x;
    r_.light.u.x += r_.light.u.xx;
  }

  // From the errors of L (|L| < 2^31) and of |N|^2 (three components under 2^30), and the rounding of t and its product.
  [[nodiscard]] Margin margin_for(std::int64_t root_error) const {
    const std::int64_t el = r_.light.error(root_error);
    std::int64_t en = 0;
    for (const Component& c : r_.n) en = std::max(en, c.error(root_error));
    return {el, (el << 32) + el * el + 3 * ((en << 31) + en * en) + (std::int64_t{1} << 31)};
  }

  [[nodiscard]] const Margin& fine_margin(std::int64_t s) const { return s >= deep_from_ ? deep_ : shallow_; }

  [[nodiscard]] Light light_at(std::int64_t s) const {
    Light light;
    light.l = r_.light.value(s);
    light.l2 = static_cast<std::uint64_t>(light.l * light.l);
    for (const Component& c : r_.n) {
      const std::int64_t n = c.value(s);
      light.n2 += static_cast<std::uint64_t>(n * n);
    }
    return light;
  }

  [[nodiscard]] int filter(const Light& light, const Margin& margin, std::int32_t k) const {
    if (light.l <= margin.light) return light.l < -margin.light ? no : unsure;
    const auto difference =
        static_cast<std::int64_t>(light.l2) - static_cast<std::int64_t>(scale_by(table_.squares[k], light.n2));
    if (difference > margin.squares) return yes;
    return difference < -margin.squares ? no : unsure;
  }

  [[nodiscard]] bool reaches(const Light& light, const Margin& margin, std::int32_t x, std::int32_t k) {
    if (k <= table_.ambient_level) return true;
    if (k > table_.top_level) return false;
    const int answer = filter(light, margin, k);
    return answer == unsure ? settle(x, k) : answer == yes;
  }

  // The integer square root first (Jordan's walk asks here often), exact arithmetic last.
  [[nodiscard]] bool settle(std::int32_t x, std::int32_t k) {
    const std::int64_t s = isqrt(static_cast<std::uint64_t>(std::max<std::int64_t>(r_.d, 0)));
    const int answer = filter(light_at(s), fine_margin(s), k);
    if (answer != unsure) return answer == yes;
    ++counters_.exact_levels;
    return reaches_level(face_, lighting_, table_.levels, k, x, y_);
  }

  // The largest level reached, sought from the level of the dot before (-1: none) or by bisection.
  std::int32_t level_of(const Light& light, const Margin& margin, std::int32_t x, std::int32_t level) {
    if (level < 0) {
      std::int32_t low = table_.ambient_level;
      std::int32_t high = table_.top_level + 1;
      while (high - low > 1) {
        const std::int32_t middle = (low + high) / 2;
        (reaches(light, margin, x, middle) ? low : high) = middle;
      }
      return low;
    }
    if (reaches(light, margin, x, level + 1)) {
      do {
        ++level;
      } while (reaches(light, margin, x, level + 1));
    } else {
      while (!reaches(light, margin, x, level)) --level;
    }
    return level;
  }

  const ActiveFace& face_;
  const Lighting& lighting_;
  const LevelTable& table_;
  std::int32_t y_, x0_, x1_;
  Counters& counters_;
  Registers r_;
  std::int64_t deep_from_ = 0;
  Margin deep_, shallow_;
};

}  // namespace

LevelTable make_levels(const Lighting& lighting, std::int32_t levels, std::span<std::uint32_t> squares) {
  LevelTable table;
  table.levels = levels;
  table.squares = squares;
  std::int64_t l2 = 0;
  for (const std::int32_t l : lighting.light) l2 += static_cast<std::int64_t>(l) * l;
  while ((std::int64_t{1} << (2 * table.light_bits)) <= l2) ++table.light_bits;
  const std::int64_t most = static_cast<std::int64_t>(levels - 1) * lighting.parallel;
  for (std::int32_t k = 0; k < levels; ++k) {
    const std::int64_t t =
        static_cast<std::int64_t>(k) * lighting.unit - static_cast<std::int64_t>(levels - 1) * lighting.ambient;
    if (t <= 0) {
      table.ambient_level = k;
      squares[k] = 0;
    } else if (t <= most) {
      // (t / most)^2 l2 / 2^(2 bits), rounded down; below 1 since l2 < 2^(2 bits).
      const Int numerator = Int(t) * Int(t) * Int(l2);
      std::uint32_t quotient = 0;
      Int rest = numerator >> 0;
      const Int divisor = (Int(most) * Int(most)) << (2 * table.light_bits);
      for (int bit = 0; bit < 32; ++bit) {
        rest += rest;
        quotient <<= 1;
        if (rest >= divisor) {
          rest -= divisor;
          quotient |= 1;
        }
      }
      squares[k] = quotient;
    } else {
      squares[k] = 0xffffffffU;
    }
    if (t <= most || t <= 0) table.top_level = k;
  }
  return table;
}

void shade_span(const ActiveFace& face, const Lighting& lighting, const LevelTable& table, Shader shader,
                std::int32_t y, std::int32_t x0, std::int32_t x1, RowPainter& painter, Counters& counters) {
  SpanShader(face, lighting, table, y, x0, x1, counters).run(shader, painter);
}

}  // namespace halfspace
