#include "firmware/core/section_forms.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 59, discriminant_bits = 59;
constexpr int root_bits = 30;
// A shear is worth its cost on spans of so many dots, where |N|^2 lacks so many bits, and sigma so many of s.
constexpr std::int32_t fewest_dots = 64;
constexpr int lost_bits = 6, fewest_shear_bits = 2;

// A face's polynomial about a dot, before it is scaled.
template <int Bits>
struct WideBlock {
  Wide<Bits> c, x, y, xx, xy, yy;

  WideBlock() = default;
  WideBlock(const ScaledQuadratic& p, std::int32_t at_x, std::int32_t at_y) : xx(p.q[0]), xy(p.q[1]), yy(p.q[2]) {
    const Wide<Bits> rise_x = xx.times(at_x);
    const Wide<Bits> rise_y = yy.times(at_y);
    const Wide<Bits> chord = rise_x + xy.times(at_y) + p.q[3];  // from x = 0
    c = chord.times(at_x) + (rise_y + p.q[4]).times(at_y) + p.q[5];
    x = chord + rise_x;
    y = rise_y + rise_y + xy.times(at_x) + p.q[4];
  }
  WideBlock(const ScaledLinear& p, std::int32_t at_x, std::int32_t at_y) : c(p.at(at_x, at_y)), x(p.q[0]), y(p.q[1]) {}
  explicit WideBlock(const BlockLinear& p) : c(p.c), x(p.x), y(p.y) {}
  explicit WideBlock(const BlockQuadratic& p) : c(p.c), x(p.x), y(p.y), xx(p.xx), xy(p.xy), yy(p.yy) {}
  template <int Other>
  explicit WideBlock(const WideBlock<Other>& p) : c(p.c), x(p.x), y(p.y), xx(p.xx), xy(p.xy), yy(p.yy) {}

  // Bits that hold the sum of its terms' sizes for |t| <= h, |v| <= lines.
  [[nodiscard]] int bits(std::int32_t h, std::int32_t lines) const {
    const Wide<Bits> across = xx.magnitude().times(h) + xy.magnitude().times(lines) + x.magnitude();
    const Wide<Bits> down = yy.magnitude().times(lines) + y.magnitude();
    return (across.times(h) + down.times(lines) + c.magnitude()).bit_length();
  }
  [[nodiscard]] BlockQuadratic quadratic(int shift) const {
    return {scaled(c, shift),  scaled(x, shift),  scaled(y, shift),
            scaled(xx, shift), scaled(xy, shift), scaled(yy, shift)};
  }
  [[nodiscard]] BlockLinear linear(int shift) const { return {scaled(c, shift), scaled(x, shift), scaled(y, shift)}; }

  [[nodiscard]] WideBlock shifted(int up) const {
    return of({c << up, x << up, y << up, xx << up, xy << up, yy << up});
  }
  // Of linear ones.
  [[nodiscard]] WideBlock operator*(const WideBlock& o) const {
    return of({c * o.c, c * o.x + x * o.c, c * o.y + y * o.c, x * o.x, x * o.y + y * o.x, y * o.y});
  }
  [[nodiscard]] WideBlock operator*(const Wide<Bits>& factor) const {
    return of({c * factor, x * factor, y * factor, {}, {}, {}});
  }
  [[nodiscard]] WideBlock operator+(const WideBlock& o) const {
    return of({c + o.c, x + o.x, y + o.y, xx + o.xx, xy + o.xy, yy + o.yy});
  }
  [[nodiscard]] WideBlock operator-(const WideBlock& o) const {
    return of({c - o.c, x - o.x, y - o.y, xx - o.xx, xy - o.xy, yy - o.yy});
  }

 private:
  static WideBlock of(const std::array<Wide<Bits>, 6>& p) {
    WideBlock b;
    b.c = p[0], b.x = p[1], b.y = p[2], b.xx = p[3], b.xy = p[4], b.yy = p[5];
    return b;
  }
};

// L and |N|^2 by a root; q and l have so many bits of fraction.
template <int Bits>
struct WideForms {
  WideBlock<Bits> q, r, l;
  Wide<Bits> m;
  int q_fraction, l_fraction;
};

// The scales follow root_shade.cpp: from the largest values that the block can reach, and where coefficients were rounded
// (exponent > 0) such that their error stays under one unit.
class Scale {
 public:
  // For a block up to `far` dots and lines from the page's corner, s in units of 2^root_shift.
  Scale(const RootSurface& f, int light_bits, int root_shift, std::int32_t half, std::int32_t lines, std::int32_t far)
      : f_(f),
        light_bits_(light_bits),
        root_shift_(root_shift),
        half_(half),
        lines_(lines),
        error_bits_(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(far)))) {}

  // By sigma, of which 2^sigma_bits units are one of s.
  template <int Bits>
  [[nodiscard]] RootForms of(const WideForms<Bits>& w, int sigma_bits) const {
    const int m_shift = root_shift_ - sigma_bits;
    const int r_shift = m_shift - f_.square_root_fraction();
    const int r_bits = w.r.bits(half_, lines_) + r_shift + root_bits;
    int square_shift = std::max(w.q.bits(half_, lines_) - w.q_fraction, r_bits) + 1 - square_bits;
    if (f_.square.exponent > 0) square_shift = std::max(square_shift, 2 * error_bits_);
    // L / (|N| 2^light_bits) must come out as in LevelTable: twice light's scale is square's.
    const int balance = f_.square.exponent - 2 * f_.light.exponent + 2 * light_bits_;
    if (f_.light.exponent > 0) square_shift = std::max(square_shift, 2 * error_bits_ - balance);
    // The factors of s, too, may have been rounded: by 1 and by 2^error_bits, times s.
    const int half_exponent = f_.discriminant.exponent / 2;
    if (f_.light.exponent > half_exponent) square_shift = std::max(square_shift, 2 * (root_shift_ + 30) - balance);
    if (f_.square_root.exponent > half_exponent) {
      square_shift = std::max(square_shift, root_shift_ - f_.square_root_fraction() + 30 + error_bits_ - 31);
    }
    const int light_terms = std::max(w.l.bits(half_, lines_) - w.l_fraction, w.m.bit_length() + m_shift + root_bits);
    square_shift = std::max(square_shift, 2 * (light_terms - 31) - balance);
    square_shift += (square_shift + balance) & 1;
    const int light_shift = (square_shift + balance) / 2;
    return {w.q.quadratic(square_shift + w.q_fraction),
            w.r.linear(square_shift - r_shift - SectionForms::root_fraction),
            w.l.linear(light_shift - SectionForms::light_fraction + w.l_fraction),
            static_cast<std::int32_t>(scaled(w.m, light_shift - m_shift - 30))};
  }

 private:
  const RootSurface& f_;
  int light_bits_, root_shift_;
  std::int32_t half_, lines_;
  int error_bits_;
};

// form + factor plane 2^shift, with `fraction` bits more than form has.
template <class Factor>
WideBlock<256> plus_product(const WideBlock<128>& form, const Factor& factor, const WideBlock<256>& plane, int shift,
                            int fraction) {
  return WideBlock<256>(form).shifted(fraction) + (plane * factor).shifted(shift + fraction);
}

// With l and q that take in what m and r make of the plane.
WideForms<256> sheared(const WideForms<128>& w, const BlockLinear& plane, int root_shift, int r_fraction) {
  const int m_shift = root_shift - Shear::fraction;
  const int r_shift = m_shift - r_fraction;
  const int q_fraction = std::max(-r_shift, 0);
  const int l_fraction = std::max(-m_shift, 0);
  const WideBlock<256> wide_plane(plane);
  const WideBlock<256> r(w.r);
  const Wide<256> m(w.m);
  return {plus_product(w.q, r, wide_plane, r_shift, q_fraction),
          r,
          plus_product(w.l, m, wide_plane, m_shift, l_fraction),
          m,
          q_fraction,
          l_fraction};
}

// Through s at both ends of a line's span and its middle and, down the block, as that goes; such that what s has beside it there, and half
// of the block down, takes half the words' range. Elsewhere it may take more (ShearedRoot).
Shear shear_for(const BlockQuadratic& d, std::int32_t lines, std::int32_t from, std::int32_t to) {
  constexpr std::int64_t unit = 1 << Shear::fraction;
  const LinePolynomial first = d.on(-lines);
  const LinePolynomial below = d.on(0);
  const std::int32_t mid = from + (to - from) / 2;
  const std::int64_t at_mid = first.root(mid);
  const std::int64_t at_from = first.root(from);
  const std::int64_t at_to = first.root(to);
  const std::int64_t at_below = below.root(mid);
  Shear shear;
  BlockLinear& plane = shear.plane;
  if (to > from) plane.x = (at_to - at_from) * unit / (to - from);
  if (at_below > 0) plane.y = (at_below - at_mid) * unit / lines;
  plane.c = (at_from + at_to + 2 * at_mid) * (unit / 4) - plane.x * mid + plane.y * lines;
  std::uint64_t most = 1;
  for (std::int32_t i = 0; i <= 8; ++i) {
    const std::int32_t t = from + (to - from) * i / 8;
    for (int row = 0; row < 2; ++row) {
      const std::int32_t s = (row == 0 ? first : below).root(t);
      const std::int64_t plane_there = plane.on(row == 0 ? -lines : 0).linear(t);
      if (s > 0) most = std::max(most, magnitude(s * unit - plane_there) >> Shear::fraction);
    }
  }
  shear.bits = std::clamp(28 - static_cast<int>(std::bit_width(most)), 0, Shear::most_bits);
  return shear;
}

}  // namespace

// As many lines as an eighth of the span has dots, at most 32, and a quarter of it on either side; what the last block had beside, too,
// where this line crosses it: a face may be seen in several spans.
void SectionForms::cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to) {
  const std::int32_t width = to - from + 1;
  const std::int32_t spare = std::min(width / 4 + 2, (2 * longest_half - width) / 2);
  const std::int32_t left = from - spare;
  const std::int32_t right = to + spare;
  const bool joins =
      half != 0 && shear.bits == 0 && y0 <= y && y < y1 && std::max(to, x1) - std::min(from, x0) < 2 * longest_half;
  const std::int32_t lines = std::clamp<std::int32_t>(width / 16, 4, 16);
  if (joins) {
    const std::int32_t joined = std::max(std::min(x0, left), to - 2 * longest_half + 1);
    cover(job, {joined, std::min(std::max(x1, right), joined + 2 * longest_half - 1), y, lines}, from, to);
    if (shear.bits == 0) return;  // else another span may have another plane
  }
  cover(job, {left, right, y, lines}, from, to);
}

void SectionForms::cover(const ShadeJob& job, const Box& box, std::int32_t from, std::int32_t to) {
  x0 = box.left;
  x1 = box.right;
  y0 = box.y;
  y1 = box.y + 2 * box.lines;
  middle = x0 + (x1 - x0) / 2;
  line = box.y + box.lines;
  half = std::max<std::int32_t>(1, x1 - middle);
  half_bits = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(half)));
  load(job, box.lines, from - middle, to - middle);
  const std::int32_t reach = half + box.lines + 1;
  deep_from = (reach + 1) * (reach + 1);
  errors[0] = errors_for(reach + 1 + 4, m);
  errors[1] = errors_for(deep_root_error, m);
}

void SectionForms::load(const ShadeJob& job, std::int32_t lines, std::int32_t from, std::int32_t to) {
  const RootSurface& f = job.face.surface;
  const std::int32_t x = middle - job.face.origin_x;
  const std::int32_t y = line - job.face.origin_y;
  const WideBlock<128> wide_d(f.discriminant, x, y);
  const int root_shift = std::max((wide_d.bits(half, lines) - discriminant_bits + 1) >> 1,
                                  f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
  const WideForms<128> wide{WideBlock<128>(f.square, x, y),
                            WideBlock<128>(f.square_root, x, y),
                            WideBlock<128>(f.light, x, y),
                            f.light_root,
                            0,
                            0};
  const Scale scale(f, job.table.light_bits, root_shift, half, lines,
                    static_cast<std::int32_t>(magnitude(x) + magnitude(y)) + half + lines + 1);
  d = wide_d.quadratic(2 * root_shift);
  static_cast<RootForms&>(*this) = scale.of(wide, 0);
  shear = {};
  if (to - from >= fewest_dots && cancels(-lines, from, to)) {
    shear = shear_for(d, lines, from, to);
    if (shear.bits >= fewest_shear_bits) {
      by_root = *this;
      static_cast<RootForms&>(*this) =
          scale.of(sheared(wide, shear.plane, root_shift, f.square_root_fraction()), shear.bits);
    } else {
      shear = {};
    }
  }
  m_size = static_cast<std::int32_t>(magnitude(m) >> 30) + 1;
  may_be_dark = f.light_root.is_zero() && f.light.q[0].is_zero() && f.light.exponent == 0;
}

// Whether |N|^2 is but a small part of its terms where a span begins and ends, and in its middle.
bool SectionForms::cancels(std::int32_t v, std::int32_t from, std::int32_t to) const {
  const LineForms on_v = on(line + v);
  const auto is_small = [&](std::int32_t t) {
    return on_v.q.at(t) + (on_v.r.linear(t) >> root_fraction) * on_v.d.root(t) < std::int64_t{1}
                                                                                     << (square_bits - lost_bits);
  };
  return is_small(from) && is_small(from + (to - from) / 2) && is_small(to);
}

// quick_root errs by 3; where s >= E, E / (sqrt(D) + sqrt(D~)) is less than 2, and the root of E is at most reach + 1.
SectionErrors SectionForms::errors_for(std::int32_t root_error, std::int32_t of_m) const {
  const std::int64_t light = (static_cast<std::int64_t>(magnitude(of_m)) * root_error >> 30) + 6;
  const std::int64_t square = (std::int64_t{root_error} << 30) + (std::int64_t{1} << 32) + deep_from;
  return {root_error, static_cast<std::int32_t>(light), static_cast<std::int32_t>(square >> 16) + 1};
}

// Newton's step on the root, which is off by 3: its quotient, in 32 bits, by 2^14 / s of itself. Floors, its square and the plane's make 4; D's
// error E makes E / s or, at a limb, its root.
ShearedRoot SectionForms::sheared_root(const LinePolynomial& d_on, const LinePolynomial& plane_on,
                                       std::int32_t t) const {
  const std::int64_t value = d_on.at(t);
  const std::int32_t s = value > 0 ? quick_root(static_cast<std::uint64_t>(value)) : 0;
  const auto rest = static_cast<std::int32_t>((std::max<std::int64_t>(value, 0) - std::int64_t{s} * s) >> 4);
  const std::int32_t step = (rest / std::max<std::int32_t>(s >> 14, 1)) >> (11 - shear.bits);
  const std::int32_t error = (deep_from + (3 << 14)) / std::max<std::int32_t>(s >> shear.bits, 1) + 4;
  return {s, std::int64_t{s} * (1 << shear.bits) + step, Shear::sigma(plane_on, shear.bits, t, s) + step,
          std::min(error, errors[0].root << shear.bits)};
}

Answer SectionForms::reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const {
  const std::int32_t t = x - middle;
  const std::int32_t v = y - line;
  const RootForms* forms = this;
  const LinePolynomial d_on = d.on(v);
  std::int32_t sigma = d_on.root(t);
  SectionErrors e = errors[sigma >= deep_from ? 1 : 0];
  if (shear.bits != 0) {
    const ShearedRoot root = sheared_root(d_on, shear.plane.on(v), t);
    if (root.is_far()) {
      forms = &by_root;
      e = errors_for(e.root, by_root.m);
    } else {
      sigma = static_cast<std::int32_t>(root.sigma);
      e = errors_for(root.error, m);
    }
  }
  const std::int64_t slope = forms->r.on(v).linear(t) >> root_fraction;
  // The error of s can take a small |N|^2 below 0; the true one is not.
  const Light dot{(forms->l.on(v).linear(t) >> light_fraction) + (std::int64_t{forms->m} * sigma >> 30),
                  std::max<std::int64_t>(forms->q.on(v).at(t) + slope * sigma, 0)};
  const auto light = static_cast<std::uint64_t>(e.light);
  const std::uint64_t from_l = (magnitude(dot.l) & 0xffffffffU) * (2 * light) + light * light;
  const std::uint64_t from_n = (std::uint64_t{square} * static_cast<std::uint32_t>(e.square) >> 32) + 1;
  // The rest: a square is rounded by less than 2^-32, its two products by less than 1 each.
  const Margin margin{e.light, static_cast<std::int64_t>(from_l + (from_n << 16)) + (dot.n2 >> 32) + 4};
  return compare(dot, margin, square);
}

}  // namespace halfspace
