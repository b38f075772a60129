#include "firmware/core/section_forms.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 59, discriminant_bits = 59;
constexpr int root_bits = 30;
// Forms by z are worth their cost on spans of so many dots, where |N|^2 lacks so many bits.
constexpr std::int32_t fewest_dots = 64;
constexpr int lost_bits = 10;

// A face's polynomial about a dot, before it is scaled.
struct WideBlock {
  Wide<128> c, x, y, xx, xy, yy;

  WideBlock() = default;
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

// L and |N|^2 by a root.
struct WideForms {
  WideBlock q, r, l;
  Wide<128> m;
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

  [[nodiscard]] RootForms of(const WideForms& w) const {
    const int r_shift = root_shift_ - f_.square_root_fraction();
    const int r_bits = w.r.bits(half_, lines_) + r_shift + root_bits;
    int square_shift = std::max(w.q.bits(half_, lines_), r_bits) + 1 - square_bits;
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
    const int light_terms = std::max(w.l.bits(half_, lines_), w.m.bit_length() + root_shift_ + root_bits);
    square_shift = std::max(square_shift, 2 * (light_terms - 31) - balance);
    square_shift += (square_shift + balance) & 1;
    const int light_shift = (square_shift + balance) / 2;
    const std::int64_t m = scaled(w.m, light_shift - root_shift_ - 58);
    return {w.q.quadratic(square_shift),
            w.r.linear(square_shift - r_shift - SectionForms::root_fraction),
            w.l.linear(light_shift - SectionForms::light_fraction),
            m,
            static_cast<std::int32_t>(m >> 28),
            0};
  }

 private:
  const RootSurface& f_;
  int light_bits_, root_shift_;
  std::int32_t half_, lines_;
  int error_bits_;
};

// Bits of the largest |z| at both ends of a span and its middle, on the block's first line and half of it down, to within 1; -1 where two
// of the first line are not known. `a_bits` of a. At a limb b may have either sign; where b < 0 half of the block down, the face may lie
// anywhere if it is not seen there.
int depth_bits(const BlockQuadratic& d, const BlockDepth& depth, int a_bits, std::int32_t lines, std::int32_t from,
               std::int32_t to) {
  const auto bits = [](std::int64_t v) { return static_cast<int>(std::bit_width(magnitude(v))); };
  int most = 0;
  int unknown = 0;
  for (const std::int32_t v : {-lines, std::int32_t{0}}) {
    const LinePolynomial d_on = d.on(v);
    const LineDepth on = depth.on(v);
    for (const std::int32_t t : {from, from + (to - from) / 2, to}) {
      const std::int64_t s = d_on.root(t);
      const std::int64_t b = on.b.linear(t) >> BlockDepth::fraction;
      if (s > 0 && 2 * b >= -s) {
        most = std::max(most, bits(on.c.at(t)) + 1 - bits(s + b));
      } else if (s > 0 && v < 0) {
        most = std::max(most, bits(s - b) + 1 - a_bits);
      } else if (v < 0 && ++unknown == 2) {
        return -1;
      }
    }
  }
  return most;
}

// Of forms in 62 bits, at so many bits of fraction, and the largest error of their terms.
class Terms {
 public:
  [[nodiscard]] std::int64_t one(const BoundedReal& value, int bits) {
    error_ = std::max(error_, value.error_of(bits));
    return value.fixed(bits);
  }
  [[nodiscard]] BlockLinear linear(const RealVector& p, int bits) {
    return {one(p[0], bits), one(p[1], bits), one(p[2], bits)};
  }
  [[nodiscard]] BlockQuadratic quadratic(const std::array<BoundedReal, 6>& p, int bits) {
    return {one(p[0], bits), one(p[1], bits), one(p[2], bits), one(p[3], bits), one(p[4], bits), one(p[5], bits)};
  }
  // With a floor's.
  [[nodiscard]] std::int64_t error() const { return error_ + 1; }

 private:
  std::int64_t error_ = 0;
};

}  // namespace

// 32 lines, or those that the face has left, and a quarter of the span and as many dots as half of them on either side; what the last block
// had beside, too, where this line crosses it: a face may be seen in several spans.
void SectionForms::cover(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to) {
  const std::int32_t width = to - from + 1;
  const std::int32_t lines = std::min<std::int32_t>((lines_left(job.face, y) + 1) / 2, 16);  // half of them
  const std::int32_t spare = std::min(width / 4 + lines, (2 * longest_half - width) / 2);
  const std::int32_t left = from - spare;
  const std::int32_t right = to + spare;
  const bool joins =
      half != 0 && !by_depth && y0 <= y && y < y1 && std::max(to, x1) - std::min(from, x0) < 2 * longest_half;
  if (joins) {
    const std::int32_t joined = std::max(std::min(x0, left), to - 2 * longest_half + 1);
    cover(job, {joined, std::min(std::max(x1, right), joined + 2 * longest_half - 1), y, lines}, from, to);
    if (!by_depth) return;  // else another span may lie elsewhere in depth
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
  const WideBlock wide_d(f.discriminant, x, y);
  const int root_shift = std::max((wide_d.bits(half, lines) - discriminant_bits + 1) >> 1,
                                  f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
  const WideForms wide{WideBlock(f.square, x, y), WideBlock(f.square_root, x, y), WideBlock(f.light, x, y),
                       f.light_root};
  const Scale scale(f, job.table.light_bits, root_shift, half, lines,
                    static_cast<std::int32_t>(magnitude(x) + magnitude(y)) + half + lines + 1);
  d = wide_d.quadratic(2 * root_shift);
  static_cast<RootForms&>(*this) = scale.of(wide);
  by_depth = to - from >= fewest_dots && job.face.kind == FaceKind::root && cancels(-lines, from, to) &&
             load_depth(job, root_shift, lines, from, to);
  m_size = static_cast<std::int32_t>(magnitude(m) >> 30) + 1;
  has_wide_slopes = f.light.exponent == 0 && f.square_root.exponent <= f.discriminant.exponent / 2;
  may_be_dark = f.light_root.is_zero() && f.light.q[0].is_zero() && f.light.exponent == 0;
}

// |z| is below 2^28 where depth_bits() looks, and known below 2^29; there each term of |N|^2 is at most 2^56.
bool SectionForms::load_depth(const ShadeJob& job, int root_shift, std::int32_t lines, std::int32_t from,
                              std::int32_t to) {
  const ActiveFace& face = job.face;
  const FaceRows rows(face, middle, line);
  const int sign = face.sheet < 0 ? -1 : 1;
  const auto with_sign = [sign](const BoundedReal& v) { return sign < 0 ? -v : v; };
  const int unit = root_shift + face.surface.discriminant.exponent / 2;  // of s
  Terms terms;
  BlockDepth at;
  const RealVector& b = rows.row[2];
  at.b = terms.linear({with_sign(b[0]), with_sign(b[1]), with_sign(b[2])}, BlockDepth::fraction - unit);
  std::array<BoundedReal, 6> c;
  for (std::size_t i = 0; i < 6; ++i) c[i] = with_sign(-rows.c[i]);
  int c_shift = discriminant_bits - size_of(c, half, lines).bits();
  at.c = terms.quadratic(c, c_shift);
  const BoundedReal& a = rows.slope[2];
  const int most_bits = depth_bits(d, at, a.bits() - c_shift - 2 * unit, lines, from, to);
  if (most_bits < 0) return false;
  c_shift += std::min(28 - most_bits, 1);
  at.c = terms.quadratic(c, c_shift);
  const int z_shift = c_shift + unit;
  if (a.bits() - z_shift - unit > 1) return false;
  at.a = terms.one(with_sign(a), 60 - z_shift - unit);

  const DepthLight lit = light_by_depth(rows, face, job.lighting);
  const auto linear_bits = [&](const RealVector& p) {
    return size_of({p[0], p[1], p[2], BoundedReal(), BoundedReal(), BoundedReal()}, half, lines).bits();
  };
  const int square_bits_needed = std::max(
      {size_of(lit.q, half, lines).bits(), linear_bits(lit.r) + 29 - z_shift, lit.square.bits() + 2 * (29 - z_shift)});
  const int light_bits_needed = std::max(linear_bits(lit.l), lit.m.bits() + 29 - z_shift) - job.table.light_bits;
  const int shift = std::min((56 - square_bits_needed) >> 1, 30 - light_bits_needed);
  const int light_shift = shift - job.table.light_bits;
  const std::int64_t light_root = terms.one(lit.m, light_shift - z_shift + 58);
  at.zz = terms.one(lit.square, 2 * (shift - z_shift) + 60);
  const RootForms forms{terms.quadratic(lit.q, 2 * shift),
                        terms.linear(lit.r, 2 * shift - z_shift + root_fraction),
                        terms.linear(lit.l, light_shift + light_fraction),
                        light_root,
                        static_cast<std::int32_t>(light_root >> 28),
                        static_cast<std::int32_t>(at.zz >> 30)};
  if (terms.error() > BlockDepth::term_error) return false;
  depth = at;
  by_root = *this;
  static_cast<RootForms&>(*this) = forms;
  return true;
}

// Whether |N|^2 is but a small part of its terms where a span begins and ends, and in its middle.
bool SectionForms::cancels(std::int32_t v, std::int32_t from, std::int32_t to) const {
  const LinePolynomial d_on = d.on(v), q_on = q.on(v), r_on = r.on(v);
  const auto is_small = [&](std::int32_t t) {
    return q_on.at(t) + (r_on.linear(t) >> root_fraction) * d_on.root(t) < std::int64_t{1} << (square_bits - lost_bits);
  };
  return is_small(from) && is_small(from + (to - from) / 2) && is_small(to);
}

// quick_root errs by 3; where s >= E, E / (sqrt(D) + sqrt(D~)) is less than 2, and the root of E is at most reach + 1.
SectionErrors SectionForms::errors_for(std::int32_t root_error, std::int32_t of_m) const {
  const std::int64_t light = (static_cast<std::int64_t>(magnitude(of_m)) * root_error >> 30) + 6;
  const std::int64_t square = (std::int64_t{root_error} << 30) + (std::int64_t{1} << 32) + deep_from;
  return {root_error, static_cast<std::int32_t>(light), static_cast<std::int32_t>(square >> 16) + 1};
}

// |a| is told to 1 / 2^30 of itself, which with what it is rounded by makes 3 in z; what s and b are off by is over |a|.
DotDepth SectionForms::depth_behind(DotDepth dot, std::int64_t b, std::int64_t a) {
  const std::int64_t way = dot.s - b;
  const int zeros = std::countl_zero(magnitude(a));                               // at least 2
  if (static_cast<int>(std::bit_width(magnitude(way))) + zeros > 32) return dot;  // |z| < 2^29
  const std::int64_t value = way * (std::int64_t{1} << (zeros + 27));
  const std::int32_t size = depth_quotient(value, static_cast<std::uint32_t>(magnitude(a) << zeros >> 33));
  const std::int64_t error = (std::int64_t{dot.root_error + 2} << std::max(zeros - 3, 0)) + 8;
  if (error >> 15 != 0) return dot;
  dot.z = a < 0 ? -size : size;
  dot.error = static_cast<std::int32_t>(error);
  return dot;
}

Answer SectionForms::reaches(std::int32_t x, std::int32_t y, std::uint32_t square) const {
  const std::int32_t t = x - middle;
  const std::int32_t v = y - line;
  const RootForms* forms = this;
  const LinePolynomial d_on = d.on(v);
  std::int32_t sigma = d_on.root(t);
  SectionErrors e = errors[sigma >= deep_from ? 1 : 0];
  if (by_depth) {
    const DotDepth at = depth_at(d_on, depth.on(v), t);
    if (at.is_far()) {
      forms = &by_root;
      e = errors_for(e.root, by_root.m);
    } else {
      sigma = at.z;
      e = errors_for(at.error, m);
      e.square += 1 << 18;
    }
  }
  const std::int64_t slope = (forms->r.on(v).linear(t) >> root_fraction) + (std::int64_t{forms->zz} * sigma >> 30);
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
