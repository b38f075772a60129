#include "firmware/core/ruling_survey.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "firmware/core/contour.hpp"
#include "firmware/core/cross_arc.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

// --- the face about a point ---

// Coefficients of more would not fit 128 bits about another point.
constexpr int most_coefficient_bits = 80;

// A face's coefficients about a point of the page, as in face.hpp.
struct Quadric {
  std::array<BoundedReal, 10> c;
  std::array<BoundedReal, 3> point;
};

Quadric about_origin(const ActiveFace& face) {
  Quadric q;
  for (std::size_t i = 0; i < 10; ++i) q.c[i] = BoundedReal(face.c[i], 0);
  return q;
}
// About page dot (x, y), at the whole depth nearest to the middle of the two sheets: there D, of two squares, cancels to those of less
// than a dot only.
Quadric about_dot(const ActiveFace& face, std::int32_t page_x, std::int32_t page_y) {
  const std::int32_t x = page_x - face.origin_x;
  const std::int32_t y = page_y - face.origin_y;
  const auto& f = face.c;
  const Wide<128> b = f[5].times(x) + f[4].times(y) + f[8];
  const BoundedReal middle = -BoundedReal(b, 0) / BoundedReal(f[2], 0);
  const std::int32_t z = middle.bits() < coordinate_bits ? static_cast<std::int32_t>(middle.fixed(0)) : 0;
  const Wide<128> w[3] = {f[0].times(x) + f[3].times(y) + f[5].times(z) + f[6],
                          f[3].times(x) + f[1].times(y) + f[4].times(z) + f[7], b + f[2].times(z)};
  Quadric q = about_origin(face);
  q.c[9] = BoundedReal((w[0] + f[6]).times(x) + (w[1] + f[7]).times(y) + (w[2] + f[8]).times(z) + f[9], 0);
  for (std::size_t i = 0; i < 3; ++i) q.c[6 + i] = BoundedReal(w[i], 0);
  q.point = {BoundedReal(page_x), BoundedReal(page_y), BoundedReal(Wide<128>(face.origin_z) + Wide<128>(z), 0)};
  return q;
}

// A form about a dot: at + x X + y Y + xx X^2 + xy X Y + yy Y^2.
struct Form {
  BoundedReal at, x, y, xx, xy, yy;

  // Its determinant, four times: the form's value at the centre times spread().
  [[nodiscard]] std::array<BoundedReal, 5> determinant() const {
    return {BoundedReal(4) * xx * yy * at, xy * x * y, -xx * y * y, -yy * x * x, -at * xy * xy};
  }
  [[nodiscard]] BoundedReal spread() const { return BoundedReal(4) * xx * yy - xy * xy; }
  // Times it: where the gradient is 0, the centre.
  [[nodiscard]] BoundedReal centre_x() const { return xy * y - (yy + yy) * x; }
  [[nodiscard]] BoundedReal centre_y() const { return xy * x - (xx + xx) * y; }
};

Form discriminant_of(const Quadric& q) {
  const auto minor = [&q](std::size_t i, std::size_t j, std::size_t k) { return q.c[i] * q.c[j] - q.c[2] * q.c[k]; };
  const auto twice = [](const BoundedReal& r) { return r + r; };
  return {minor(8, 8, 9), twice(minor(5, 8, 6)), twice(minor(4, 8, 7)),
          minor(5, 5, 0), twice(minor(5, 4, 3)), minor(4, 4, 1)};
}

// --- a line of it, and the pencil of its rulings ---

// Through the ruling at dot X of the line: X + (slope + spread X) lines.
struct Pencil {
  BoundedReal slope, spread;
  BoundedReal drift;  // spread times D where rulings meet, which is 0 on a cone
};

Pencil parallels(const Form& d) { return {-d.xy / (d.xx + d.xx), {}, {}}; }
// Of a face without z^2. Its apex is where rows 0 to 2 vanish, so b and what rows 0 and 1 have beside z; all along a cylinder's axis b keeps its
// value, and the other has none.
struct QuotientCentre {
  BoundedReal w, x, y;  // of the apex's image
  bool is_parallel;

  explicit QuotientCentre(const FaceRows& f) {
    RealVector flat;
    int most = std::numeric_limits<int>::min();
    int left = most;
    for (std::size_t k = 0; k < 3; ++k) {
      const BoundedReal of_x = f.slope[1] * f.row[0][k];
      const BoundedReal of_y = f.slope[0] * f.row[1][k];
      flat[k] = of_x - of_y;
      if (!of_x.is_zero()) most = std::max(most, of_x.bits());
      if (!of_y.is_zero()) most = std::max(most, of_y.bits());
      if (!flat[k].is_zero()) left = std::max(left, flat[k].bits());
    }
    constexpr int cut = 32;
    is_parallel = left == std::numeric_limits<int>::min() || left <= most - cut;
    const RealVector& b = f.row[2];
    w = b[1] * flat[2] - b[2] * flat[1];
    x = b[2] * flat[0] - b[0] * flat[2];
    y = b[0] * flat[1] - b[1] * flat[0];
  }
  [[nodiscard]] Pencil pencil(const RealVector& b) const {
    if (is_parallel) return {-b[2] / b[1], {}, {}};
    return {x / y, -w / y, {}};
  }
};

// Through the centre of D = 0, the apex's image.
Pencil through_centre(const Form& d) {
  const BoundedReal spread = d.spread();
  const BoundedReal x = d.centre_x();
  const BoundedReal y = d.centre_y();
  return {x / y, -spread / y, (spread * d.at + (d.x * x + d.y * y).half()) / y};
}

// The dot of x0 .. x1 nearest to where D is greatest or least on the line: on either side of an apex, about which D cancels least.
std::int32_t middle_of(const ActiveFace& face, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const auto& d = face.surface.discriminant.q;
  const BoundedReal x = -BoundedReal(d[1].times(y - face.origin_y) + d[3], 0) / BoundedReal(d[0] + d[0], 0);
  if (x.bits() > coordinate_bits) return x0 + (x1 - x0) / 2;
  return std::clamp(static_cast<std::int32_t>(x.fixed(0)) + face.origin_x, x0, x1);
}

// To within what a cone, whose apex lies so far off, has in common with a cylinder.
bool is_parallel(const Form& d) {
  const BoundedReal spread = d.spread();
  return spread.sign() == 0 || spread.bits() <= std::max((d.xy * d.xy).bits(), (d.xx * d.yy).bits()) - 24;
}

// Of the lines that a survey is to hold for. Where a cone grows much over them, a power of their number over the growth is as small as if
// there were no more than 1 / spread.
int line_bits_of(const Pencil& p) {
  constexpr int bits = std::bit_width(static_cast<std::uint32_t>(survey_lines)) - 1;
  return p.spread.is_zero() ? bits : std::clamp(1 - p.spread.bits(), 0, bits);
}

// Along the rulings a cone's forms grow, N's as 1 + g with g = spread lines, D as its square, and a cylinder's stay. What a form has
// beside that, as far as the survey is to hold, becomes an error of the form on the line; growth is divided out, and g >= -3/4.

// lines (linear + bend x) + lines^2 square
void hold_along_parallels(Form& d, const Pencil& p) {
  const int lines = line_bits_of(p);
  const BoundedReal linear = d.x * p.slope + d.y;
  const BoundedReal bend = (d.xx + d.xx) * p.slope + d.xy;
  const BoundedReal square = (d.xx * p.slope + d.xy) * p.slope + d.yy;
  d.at = d.at.blurred(linear, lines).blurred(square, 2 * lines);
  d.x = d.x.blurred(bend, lines);
}
// About the centre D is of second degree but for a constant, which should grow as well: 1 - 1 / (1 + g)^2 is at most 2 g, or 32 |g| where
// g < 0.
void hold_through_centre(Form& d, const Pencil& p) { d.at = d.at.blurred(p.drift, line_bits_of(p) + 5); }
// lines linear, divided by 1/4 at least.
void hold_on_all_lines(Form& n, const Pencil& p) {
  n.at = n.at.blurred(n.x * p.slope + n.y - n.at * p.spread, line_bits_of(p) + (p.spread.is_zero() ? 0 : 2));
}

// N = u + v s, a times the gradient's product with the matrix: u_i = -1/2 (M_i0 D_x + M_i1 D_y + M_i3 D_w), D_w = 2 at + x X + y Y;
// v_i = +-(M_i0 c5 + M_i1 c4 + M_i2 c2 + M_i3 c8). The matrix is that of the page's frame, and moved as the gradient is.
void add_normals(CrossLine& line, const ShadeJob& job, const Quadric& q, const Form& d, const Pencil& pencil) {
  static constexpr std::array<std::uint8_t, 4> depth{5, 4, 2, 8};
  const Lighting& g = job.lighting;
  const bool reversed = job.face.light_sign < 0;
  const bool root_reversed = (job.face.sheet < 0) != reversed;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<BoundedReal, 4> m;
    for (std::size_t j = 0; j < 4; ++j) {
      m[j] = BoundedReal(g.matrix[i][j]);
      if (j < 3) m[j] = m[j] - BoundedReal(g.matrix[i][3]) * q.point[j];
    }
    Form n{(m[0] * d.x + m[1] * d.y).half() + m[3] * d.at,
           m[0] * d.xx + (m[1] * d.xy + m[3] * d.x).half(),
           (m[0] * d.xy + m[3] * d.y).half() + m[1] * d.yy,
           {},
           {},
           {}};
    hold_on_all_lines(n, pencil);
    BoundedReal root;
    for (std::size_t j = 0; j < 4; ++j) root = root + m[j] * q.c[depth[j]];
    line.normal[i] = reversed ? n.at : -n.at;
    line.normal_step[i] = reversed ? n.x : -n.x;
    line.normal_root[i] = root_reversed ? -root : root;
  }
}

// The same of a form of second degree, which grows as (1 + g)^2.
void hold_square_on_all_lines(std::array<BoundedReal, 6>& n, const Pencil& p) {
  const int lines = line_bits_of(p);
  const int growth = p.spread.is_zero() ? 0 : 4;
  const BoundedReal square = p.spread * p.spread;
  const BoundedReal bend = n[3] + n[3];
  const BoundedReal turn = bend * p.slope + n[4];
  n[0] = n[0].blurred(n[1] * p.slope + n[2] - (n[0] + n[0]) * p.spread, lines + growth)
             .blurred((n[3] * p.slope + n[4]) * p.slope + n[5] - n[0] * square, 2 * lines + growth);
  n[1] =
      n[1].blurred(turn - n[1] * p.spread, lines + growth).blurred(turn * p.spread - n[1] * square, 2 * lines + growth);
}

// The part of the line that the face, which is at 0, has as far as its limbs; or, where they lie far off or there are none, from -left to
// right. False where D is a square, as on a line through the apex.
bool ends_of_face(const CrossLine& line, std::int32_t left, std::int32_t right, ArcEnd& a, ArcEnd& b) {
  constexpr std::int32_t far = 4096;
  const auto dot = [&line](std::int32_t x) {
    return ArcEnd{BoundedReal(x), (line.d2 + (line.d1 + line.d0 * BoundedReal(x)) * BoundedReal(x)).root()};
  };
  const auto limb_left = [&](const BoundedReal& x) {
    a = (BoundedReal(std::max(left, far)) + x).sign() < 0 ? dot(-left) : ArcEnd{x, {}};
  };
  const auto limb_right = [&](const BoundedReal& x) {
    b = (x - BoundedReal(std::max(right, far))).sign() > 0 ? dot(right) : ArcEnd{x, {}};
  };
  const BoundedReal discriminant = line.d1 * line.d1 - BoundedReal(4) * line.d0 * line.d2;
  const int bend = line.d0.sign();
  if (discriminant.sign() > 0 && bend != 0) {
    const BoundedReal root = discriminant.root();
    const BoundedReal two = line.d0 + line.d0;
    const BoundedReal low = (bend < 0 ? root - line.d1 : -root - line.d1) / two;
    const BoundedReal high = (bend < 0 ? -root - line.d1 : root - line.d1) / two;
    if (bend < 0) {
      limb_left(low);
      limb_right(high);
    } else if (line.d1.sign() > 0) {  // right of both
      limb_left(high);
      b = dot(right);
    } else {
      a = dot(-left);
      limb_right(low);
    }
    return true;
  }
  a = dot(-left);
  b = dot(right);
  return discriminant.sign() < 0;
}

// xA, xB - xA and their slopes; the ends are counted from page dot x. False where a slope is too steep.
bool aim(const Pencil& pencil, std::int32_t x, const ArcEnd& a, const ArcEnd& b, StraightContours& out) {
  const BoundedReal width = b.x - a.x;
  const BoundedReal left = BoundedReal(x) + a.x;
  const BoundedReal slope = pencil.slope + pencil.spread * a.x;
  const BoundedReal width_slope = width * pencil.spread;
  constexpr int steepest = 12;  // bits
  if (slope.bits() > steepest || width_slope.bits() > steepest || left.bits() > 17 || width.bits() > 15) return false;
  // Over all lines less than 1/8 of a place each.
  const auto put = [](std::int64_t& to, const BoundedReal& value, int bits) {
    to = value.fixed(line_bits);
    return value.error_of(line_bits) <= std::int64_t{1} << bits;
  };
  return put(out.left, left, 15) && put(out.left_slope, slope, 4) && put(out.width, width, 15) &&
         put(out.width_slope, width_slope, 4);
}

// --- across the rulings ---

class Survey {
 public:
  Survey(const ShadeJob& job, const CrossArc& arc) : job_(job), arc_(arc), block_(job.contours->block) {
    const Lighting& g = job.lighting;
    per_threshold_ = BoundedReal(1) / BoundedReal(static_cast<std::int64_t>(job.table.levels - 1) * g.parallel);
    const int root_bits = (static_cast<int>(std::bit_width(static_cast<std::uint64_t>(arc.unsure()))) + 1) / 2;
    narrow_ = 1U << std::clamp(narrow_bits(job.contours->straight) - arc.steepness_bits(), 1, 14);
    rim_ = 1U << std::max(8, root_bits + 5);
  }

  bool run() {
    std::uint32_t first = beside_end;
    // Where places are steep beside a limb the nearest tau is still further off: so much less is surveyed.
    while (first > 1 && arc_.place(first) > 2) first /= 2;
    while (0U - last_ > 1 && arc_.place(last_) < (1 << 24) - 3) last_ += (0U - last_) / 2;
    if (!settle_level(first)) return false;
    add(first);
    if (keeps_level()) {
      at_ = last_;
    } else if (!arc_.has_slope()) {
      return false;
    }
    for (int parts = 0; at_ < last_; ++parts) {
      if (parts == most_parts) return false;
      const Stretch next = next_stretch();
      if (!(next.monotone ? climb(next.end) : step_over(next.end))) return false;
    }
    add(last_);
    return count_ <= block_.size();
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  // Units of a place between which a change lies, from the entry's on: the entry's may be one and more too low, the last too high.
  [[nodiscard]] std::int32_t entry_width() const { return widest_ + 3; }

 private:
  // Half of an interval left: what it lets a face of so many lines and dots ask, the number of lines times that of dots of an interval,
  // is then about alike for all faces, and 2^-11 dot where a face is 1000 dots wide.
  static int narrow_bits(const StraightContours& out) {
    return 27 - 2 * static_cast<int>(std::bit_width(static_cast<std::uint64_t>(out.width) >> line_bits));
  }
  // From an end, at most: beside a limb p is 2^-24 there.
  static constexpr std::uint32_t beside_end = 1U << 20;
  static constexpr std::uint32_t near_root = 1U << 19;
  static constexpr int most_parts = 40;
  static constexpr int most_tries = 60;
  static constexpr std::int32_t most_width = 1 << 14;

  struct Stretch {
    std::uint32_t end;
    bool monotone;  // the intensity rises, or falls, from at_ on; else it is not proven to
  };
  [[nodiscard]] Stretch next_stretch() const {
    std::uint32_t end = last_;
    while (end - at_ > 2 * rim_) {
      const int turns = arc_.turns(at_, end);
      if (turns == 0) return {end, true};
      if (turns == 1) {
        const std::uint32_t ridge = ridge_before(end);
        if (ridge - at_ > rim_) return {ridge - rim_, true};
        return {end - ridge > rim_ ? ridge + rim_ : end, false};
      }
      end = at_ + (end - at_) / 2;
    }
    return {end, false};
  }
  // The only ridge between at_ and `end`.
  [[nodiscard]] std::uint32_t ridge_before(std::uint32_t end) const {
    std::uint32_t low = at_;
    const int rise = arc_.rise(low);
    while (end - low > 1) {
      const std::uint32_t middle = low + (end - low) / 2;
      (arc_.rise(middle) == rise ? low : end) = middle;
    }
    return low;
  }

  [[nodiscard]] LevelBar bar(std::int32_t k) const {
    const Lighting& g = job_.lighting;
    const BoundedReal t = BoundedReal(static_cast<std::int64_t>(k) * g.unit -
                                      static_cast<std::int64_t>(job_.table.levels - 1) * g.ambient) *
                          per_threshold_;
    const auto fraction = static_cast<std::uint64_t>(t.fixed(60)) << 2;
    return {static_cast<std::int64_t>(high_product(fraction, fraction)), static_cast<std::int32_t>(fraction >> 32)};
  }
  [[nodiscard]] int sign_of(std::int64_t excess) const {
    return excess > arc_.unsure() ? 1 : (excess < -arc_.unsure() ? -1 : 0);
  }

  // Moves to a point where the level is certain, and finds it from the one before.
  [[nodiscard]] bool settle_level(std::uint32_t tau) {
    at_ = tau;
    light_ = arc_.at(tau);
    bool sure = true;
    level_ = search_level(job_.table, level_, [&](std::int32_t k) {
      const int sign = sign_of(bar(k).excess(light_));
      sure = sure && sign != 0;
      return sign > 0;
    });
    return sure;
  }
  // Over what is not proven: any level may be met there, as an entry says that tells the level before once more.
  [[nodiscard]] bool step_over(std::uint32_t end) {
    if (keeps_level(end - at_)) return settle_level(end);
    // What is proven of a part goes with its square.
    for (const std::uint32_t part = (end - at_ + 7) / 8; keeps_level(part);) {
      at_ = std::min(at_ + part, end);
      light_ = arc_.at(at_);
      if (at_ == end) return true;
    }
    const std::int32_t place = arc_.place(at_);
    std::int32_t level = level_;
    if (!settle_level(end) || !holds(place, arc_.place(at_))) return false;
    add_place(place, level);
    while (level != level_) add_place(place, level += level < level_ ? 1 : -1);
    return true;
  }
  // The level is sure to be the same everywhere; all the way.
  [[nodiscard]] bool keeps_level() const {
    return (level_ <= job_.table.ambient_level || arc_.sign_of_excess(bar(level_)) > 0) &&
           (level_ >= job_.table.top_level || arc_.sign_of_excess(bar(level_ + 1)) < 0);
  }
  [[nodiscard]] bool keeps_level(std::uint32_t way) const {
    return (level_ <= job_.table.ambient_level || holds_off(bar(level_), way) > 0) &&
           (level_ >= job_.table.top_level || holds_off(bar(level_ + 1), way) < 0);
  }
  // The sign of the excess if it is sure to be the same all the way: it changes by the slope times the way and half the bend, 12, times
  // its square at most. The slope's factors are cut to within 2^-28.
  [[nodiscard]] int holds_off(const LevelBar& bar, std::int64_t way) const {
    const std::int64_t excess = bar.excess(light_);
    const std::int64_t slope = bar.slope(light_);
    const std::int64_t change = (((slope < 0 ? -slope : slope) >> 26) + 256) * way / 16 + way * way + arc_.unsure();
    return excess > change ? 1 : (excess < -change ? -1 : 0);
  }
  // A change between two places.
  [[nodiscard]] bool holds(std::int32_t from, std::int32_t to) {
    widest_ = std::max(widest_, to - from);
    return widest_ < most_width;
  }
  // Where the intensity rises, or falls, all the way.
  [[nodiscard]] bool climb(std::uint32_t end) {
    const int rise = arc_.rise(at_ + (end - at_) / 2);
    if (rise == 0) return false;
    const bool up = rise > 0;
    const ArcLight light_at_end = arc_.at(end);
    crossings_ = 0;
    for (;;) {
      const std::int32_t k = up ? level_ + 1 : level_;
      if (k > job_.table.top_level || k <= job_.table.ambient_level) break;
      const LevelBar next = bar(k);
      const int beyond = sign_of(next.excess(light_at_end));
      if (beyond == 0) return false;
      if ((beyond > 0) != up) break;
      if (!cross(next, rise, end)) return false;
      const std::int32_t place = arc_.place(before_);
      if (!holds(place, arc_.place(at_))) return false;
      crossed_ = {at_, crossed_[0], crossed_[1]};
      ++crossings_;
      level_ += rise;
      add_place(place, level_);
    }
    at_ = end;
    light_ = light_at_end;
    return true;
  }
  // From at_, where `next` is not crossed, to just beyond the crossing; before_ is just before it. Newton's steps, each beyond the root
  // by `narrow` once it is near; halves where they lead astray.
  [[nodiscard]] bool cross(const LevelBar& next, int direction, std::uint32_t end) {
    std::int64_t guess = forecast(next);
    before_ = at_;
    at_ = end;
    std::uint32_t half = narrow_;
    for (int tries = 0; tries < most_tries; ++tries) {
      const std::uint32_t x =
          guess > before_ && guess < at_ ? static_cast<std::uint32_t>(guess) : before_ + (at_ - before_) / 2;
      const ArcLight light = arc_.at(x);
      const std::int64_t excess = next.excess(light);
      const int sign = sign_of(excess) * direction;
      if (sign < 0) before_ = x;
      if (sign > 0) {
        at_ = x;
        light_ = light;
      }
      if (at_ - before_ <= 3 * half) return true;
      if (sign == 0) half = std::min(2 * half, near_root);
      std::int64_t step = next.step(light, excess);
      if (step > -std::int64_t{near_root} && step < std::int64_t{near_root}) {
        step += sign > 0 ? -std::int64_t{half} : std::int64_t{half};
      }
      guess = x + step;
    }
    return false;
  }
  // Where the next crossing should be: as the last ways from one to the next changed, or by Newton's step.
  [[nodiscard]] std::int64_t forecast(const LevelBar& next) const {
    if (crossings_ < 3) return at_ + next.step(light_, next.excess(light_));
    return crossed_[2] + 3 * (std::int64_t{crossed_[0]} - crossed_[1]);
  }

  void add(std::uint32_t tau) { add_place(arc_.place(tau), level_); }
  // What lies right of there has the level. Places may be a unit too high, and a limb's is 0; none is less than the one before.
  void add_place(std::int32_t place, std::int32_t level) {
    last_place_ = std::clamp(place - 1, last_place_, largest_place);
    if (count_ < block_.size()) {
      block_[count_] = static_cast<std::uint32_t>(last_place_) << entry_level_bits | static_cast<std::uint32_t>(level);
    }
    ++count_;
  }

  const ShadeJob& job_;
  const CrossArc& arc_;
  std::span<std::uint32_t> block_;
  BoundedReal per_threshold_;
  std::uint32_t at_ = 0, before_ = 0;
  std::array<std::uint32_t, 3> crossed_{};  // of this climb, the latest first
  int crossings_ = 0;
  std::uint32_t last_ = 0U - beside_end;
  std::uint32_t narrow_;  // half of the interval in which a change is left, as a rule
  ArcLight light_{};
  std::uint32_t rim_;  // beside a ridge: a level that only touches it is sure not to be reached so far off
  std::int32_t level_ = -1, widest_ = 2;
  std::int32_t last_place_ = 0;
  static constexpr std::int32_t largest_place = (1 << (32 - entry_level_bits)) - 1;
  std::size_t count_ = 0;
};

}  // namespace

namespace {

bool make_root_arc(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1, CrossArc& arc) {
  const std::int32_t x = middle_of(job.face, y, x0, x1);
  const Quadric quadric = about_dot(job.face, x, y);
  Form d = discriminant_of(quadric);
  const bool parallel = is_parallel(d);
  const Pencil pencil = parallel ? parallels(d) : through_centre(d);
  CrossLine line;
  add_normals(line, job, quadric, d, pencil);
  parallel ? hold_along_parallels(d, pencil) : hold_through_centre(d, pencil);
  line.d0 = d.xx;
  line.d1 = d.x;
  line.d2 = d.at;
  ArcEnd a;
  ArcEnd b;
  // A cone's lines towards its apex need more of its rulings: those of a third of the way.
  if (!ends_of_face(line, 3 * (x - x0) + (x1 - x0) + 64, 3 * (x1 - x) + (x1 - x0) + 64, a, b)) return false;
  return aim(pencil, x, a, b, job.contours->straight) && arc.make(line, a, b, job.lighting);
}

// As far as b = 0, beyond which the face is another side of its surface.
bool make_quotient_arc(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1, CrossArc& arc) {
  const std::int32_t x = x0 + (x1 - x0) / 2;
  const FaceRows rows(job.face, x, y);
  const RealVector& depth = rows.row[2];
  const Pencil pencil = QuotientCentre(rows).pencil(depth);
  ArcEnd a{BoundedReal(-(3 * (x - x0) + 64)), {}};
  ArcEnd b{BoundedReal(3 * (x1 - x) + 64), {}};
  if (const int rise = depth[1].sign() * depth[0].sign(); rise != 0) {
    const BoundedReal limb = -depth[0] / depth[1];
    if (rise > 0 && (limb - a.x).sign() > 0) a.x = limb;
    if (rise < 0 && (b.x - limb).sign() > 0) b.x = limb;
  }
  LitForms<6> forms = lit_forms<6>(job.face, job.lighting, x, y);
  const bool reversed = (quotient_sign(job.face, x, y) < 0) != (job.face.light_sign < 0);
  RealVector na;
  RealVector nt;
  RealVector nb;
  for (std::size_t i = 0; i < 3; ++i) {
    auto& n = forms.normal[i];
    hold_square_on_all_lines(n, pencil);
    na[i] = n[0] + (n[1] + n[3] * a.x) * a.x;
    nt[i] = n[0] + (n[1] * (a.x + b.x)).half() + n[3] * a.x * b.x;
    nb[i] = n[0] + (n[1] + n[3] * b.x) * b.x;
    if (reversed) {
      na[i] = -na[i];
      nt[i] = -nt[i];
      nb[i] = -nb[i];
    }
  }
  return aim(pencil, x, a, b, job.contours->straight) &&
         arc.make(na, nt, nb, {BoundedReal(1), BoundedReal(2)}, job.lighting);
}

}  // namespace

bool survey_rulings(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  StraightContours& out = job.contours->straight;
  out.entries = 0;
  CrossArc arc;
  const auto make_arc = job.face.kind == FaceKind::root ? &make_root_arc : &make_quotient_arc;
  if (!make_arc(job, y, x0, x1, arc)) return false;
  Survey survey(job, arc);
  if (!survey.run()) return false;
  out.line = y;
  out.entry_width = survey.entry_width();
  out.entries = static_cast<std::int32_t>(survey.count());
  return true;
}

// What D's determinant is above 0 for, such as a cylinder written in decimals, becomes an error of the survey's forms; so does, of a face
// without z^2, what is left of row 3 at the centre.
bool has_straight_contours(const ActiveFace& face) {
  BoundedReal sum;
  int most = std::numeric_limits<int>::min();
  const auto add = [&](const BoundedReal& term) {
    sum = sum + term;
    if (!term.is_zero()) most = std::max(most, term.bits());
  };
  if (face.kind == FaceKind::root) {
    for (const BoundedReal& term : discriminant_of(about_origin(face)).determinant()) add(term);
  } else {
    const FaceRows rows(face, face.origin_x, face.origin_y);
    const QuotientCentre centre(rows);
    if (centre.is_parallel) return true;
    // z of the centre times slope: that of the row in which it is larger.
    const std::size_t by = rows.slope[0].bits() >= rows.slope[1].bits() ? 0 : 1;
    const auto flat = [&](const RealVector& row) {
      return std::array<BoundedReal, 3>{row[0] * centre.w, row[1] * centre.x, row[2] * centre.y};
    };
    for (const BoundedReal& term : flat(rows.row[3])) add(rows.slope[by] * term);
    for (const BoundedReal& term : flat(rows.row[by])) add(-rows.slope[3] * term);
  }
  return sum.sign() == 0 || sum.bits() <= most - 16;
}

bool has_wide_coefficients(const ActiveFace& face) {
  return std::any_of(face.c.begin(), face.c.end(),
                     [](const Wide<128>& c) { return c.bit_length() > most_coefficient_bits; });
}

// n lines on the discriminant of D is that here and 2 centre_y n - spread n^2. Where all lines are alike, they have no corner if D hardly changes
// along one of them.
std::int32_t corner_line_of(const ActiveFace& face, std::int32_t x, std::int32_t y) {
  if (face.kind != FaceKind::root) return no_line;
  const Form d = discriminant_of(about_dot(face, x, y));
  const BoundedReal spread = d.spread();
  const BoundedReal centre = d.centre_y();
  constexpr int page_bits = 15;
  if ((d.x * d.x - BoundedReal(4) * d.xx * d.at).blurred(centre, page_bits + 1).blurred(spread, 2 * page_bits).sign() !=
      0) {
    return no_line;
  }
  const BoundedReal lines = centre / spread;
  constexpr int fraction = 8;
  if (lines.error_of(fraction) > 1 << (fraction - 2)) {
    const bool is_level = d.x.is_zero() && d.xx.is_zero();
    return is_level || d.at.blurred(d.x, page_bits).blurred(d.xx, 2 * page_bits).sign() > 0 ? no_line : all_lines;
  }
  if (lines.bits() > page_bits) return no_line;
  const auto nearest = static_cast<std::int32_t>((lines.fixed(1) + 1) >> 1);
  return (lines - BoundedReal(nearest)).sign() == 0 ? y + nearest : no_line;
}

}  // namespace halfspace
