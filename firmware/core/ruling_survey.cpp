#include "firmware/core/ruling_survey.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "firmware/core/contour.hpp"
#include "firmware/core/cross_arc.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

// --- the face: D before anything was rounded ---

// From coefficients of c bits those of D have at most 2c + 2, and its values 34 more.
constexpr int most_coefficient_bits = 80;
using Coefficient = Wide<256>;
using Product = Wide<512>;  // of three, and three bits for a sum

struct Outline {
  Coefficient q[6];

  explicit Outline(const ActiveFace& f) {
    const auto product = [&f](int i, int j) { return Coefficient(f.c[i]) * Coefficient(f.c[j]); };
    q[0] = product(5, 5) - product(2, 0);
    q[1] = (product(5, 4) - product(2, 3)) << 1;
    q[2] = product(4, 4) - product(2, 1);
    q[3] = (product(5, 8) - product(2, 6)) << 1;
    q[4] = (product(4, 8) - product(2, 7)) << 1;
    q[5] = product(8, 8) - product(2, 9);
  }
  [[nodiscard]] Product product(int i, int j) const { return Product(q[i]) * Product(q[j]); }
  [[nodiscard]] Product product(int i, int j, int k) const { return product(i, j) * Product(q[k]); }
  // 0 where rulings are parallel; the common point times it is (pole_x(), pole_y()).
  [[nodiscard]] Product spread() const { return (product(0, 2) << 2) - product(1, 1); }
  // Of D's matrix, four times.
  [[nodiscard]] std::array<Product, 5> determinant_terms() const {
    return {product(0, 2, 5) << 2, product(1, 3, 4), -product(0, 4, 4), -product(2, 3, 3), -product(5, 1, 1)};
  }
  [[nodiscard]] Product determinant() const {
    Product sum;
    for (const Product& term : determinant_terms()) sum += term;
    return sum;
  }
  [[nodiscard]] Product pole_x() const { return product(1, 4) - (product(2, 3) << 1); }
  [[nodiscard]] Product pole_y() const { return product(1, 3) - (product(0, 4) << 1); }
};

// --- a line of it, and the pencil of its rulings ---

// Through the ruling at dot x of the line, counted from a dot of it: x + (slope + spread x) lines.
struct Pencil {
  Real slope, spread;
  Real excess;  // D where rulings meet: a cone's is 0
};

// Dot (x, y) of the face's frame is on the surveyed line.
Pencil parallels(const Outline& outline) { return {-Real(outline.q[1], 0) / Real(outline.q[0] << 1, 0), {}, {}}; }
// Through the centre of D = 0, the apex's image.
Pencil through_centre(const Outline& outline, std::int32_t x, std::int32_t y) {
  const Product spread = outline.spread();
  const Real below(spread.times(y) - outline.pole_y(), 0);
  return {Real(spread.times(x) - outline.pole_x(), 0) / below, Real(spread, 0) / below,
          Real(outline.determinant(), 0) / Real(spread, 0)};
}

// To within what a cone, whose apex lies so far off, has in common with a cylinder.
bool is_parallel(const Outline& outline) {
  const int spread = outline.spread().bit_length();
  return spread == 0 || spread <= outline.product(1, 1).bit_length() - 24 ||
         spread <= outline.product(0, 2).bit_length() - 24;
}

// Of the lines that a survey is to hold for. Where a cone grows much over them, a power of their number over the growth is as small as if
// there were no more than 1 / spread.
int line_bits_of(const Pencil& p) {
  constexpr int bits = std::bit_width(static_cast<std::uint32_t>(survey_lines)) - 1;
  return p.spread.is_zero() ? bits : std::clamp(1 - p.spread.bits(), 0, bits);
}

// A form about a dot: at + x X + y Y + xx X^2 + xy X Y + yy Y^2.
struct Form {
  Real at, x, y, xx, xy, yy;
};

// Along the rulings a cone's forms grow, N's as 1 + g with g = spread lines, D as its square, and a cylinder's stay. What a form has
// beside that, as far as the survey is to hold, becomes an error of the form on the line; growth is divided out, and g >= -3/4.

// lines (linear + bend x) + lines^2 square
void hold_along_parallels(Form& d, const Pencil& p) {
  const int lines = line_bits_of(p);
  const Real linear = d.x * p.slope + d.y;
  const Real bend = (d.xx + d.xx) * p.slope + d.xy;
  const Real square = (d.xx * p.slope + d.xy) * p.slope + d.yy;
  d.at = d.at.blurred(linear, lines).blurred(square, 2 * lines);
  d.x = d.x.blurred(bend, lines);
}
// About the centre D is of second degree but for the excess, which should grow as well: 1 - 1 / (1 + g)^2 is at most 2 g, or 32 |g| where
// g < 0.
void hold_through_centre(Form& d, const Pencil& p) { d.at = d.at.blurred(p.excess * p.spread, line_bits_of(p) + 5); }
// lines linear, divided by 1/4 at least.
void hold_on_all_lines(Form& n, const Pencil& p) {
  n.at = n.at.blurred(n.x * p.slope + n.y - n.at * p.spread, line_bits_of(p) + (p.spread.is_zero() ? 0 : 2));
}

Form form_of(const Outline& outline, std::int32_t x, std::int32_t y) {
  const auto& q = outline.q;
  return {Real((q[0].times(x) + q[1].times(y) + q[3]).times(x) + (q[2].times(y) + q[4]).times(y) + q[5], 0),
          Real((q[0] << 1).times(x) + q[1].times(y) + q[3], 0),
          Real(q[1].times(x) + (q[2] << 1).times(y) + q[4], 0),
          Real(q[0], 0),
          Real(q[1], 0),
          Real(q[2], 0)};
}

// About dot (x, y) of the face's frame, and good for all lines of the survey.
CrossLine cross_line(const ShadeJob& job, const Outline& outline, const Pencil& pencil, std::int32_t x,
                     std::int32_t y) {
  Form d = form_of(outline, x, y);
  pencil.spread.is_zero() ? hold_along_parallels(d, pencil) : hold_through_centre(d, pencil);
  CrossLine line;
  line.d0 = d.xx;
  line.d1 = d.x;
  line.d2 = d.at;
  const NormalForms forms = normal_forms(job.face, job.lighting);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& u = forms.u[i];
    Form n{Real(u[0].times(x) + u[1].times(y) + u[2], 0), Real(u[0], 0), Real(u[1], 0), {}, {}, {}};
    hold_on_all_lines(n, pencil);
    const bool reversed = job.face.light_sign < 0;
    line.normal[i] = reversed ? -n.at : n.at;
    line.normal_step[i] = reversed ? -n.x : n.x;
    line.normal_root[i] = Real(reversed ? -forms.v[i] : forms.v[i], 0);
  }
  return line;
}

// The part of the line that the face, which is at 0, has as far as its limbs; or, where they lie `far` off or there are none, from
// -beyond to beyond. False where D is a square, as on a line through the apex.
bool ends_of_face(const CrossLine& line, std::int32_t beyond, ArcEnd& a, ArcEnd& b) {
  const Real far(std::max<std::int32_t>(beyond, 4096));
  const auto dot = [&line](std::int32_t x) {
    return ArcEnd{Real(x), (line.d2 + (line.d1 + line.d0 * Real(x)) * Real(x)).root()};
  };
  const auto limb_left = [&](const Real& x) { a = (far + x).sign() < 0 ? dot(-beyond) : ArcEnd{x, {}}; };
  const auto limb_right = [&](const Real& x) { b = (x - far).sign() > 0 ? dot(beyond) : ArcEnd{x, {}}; };
  const Real discriminant = line.d1 * line.d1 - Real(4) * line.d0 * line.d2;
  const int bend = line.d0.sign();
  if (discriminant.sign() > 0 && bend != 0) {
    const Real root = discriminant.root();
    const Real two = line.d0 + line.d0;
    const Real low = (bend < 0 ? root - line.d1 : -root - line.d1) / two;
    const Real high = (bend < 0 ? -root - line.d1 : root - line.d1) / two;
    if (bend < 0) {
      limb_left(low);
      limb_right(high);
    } else if (line.d1.sign() > 0) {  // right of both
      limb_left(high);
      b = dot(beyond);
    } else {
      a = dot(-beyond);
      limb_right(low);
    }
    return true;
  }
  a = dot(-beyond);
  b = dot(beyond);
  return discriminant.sign() < 0;
}

// xA, xB - xA and their slopes; the ends are counted from page dot x. False where a slope is too steep.
bool aim(const Pencil& pencil, std::int32_t x, const ArcEnd& a, const ArcEnd& b, StraightContours& out) {
  const Real width = b.x - a.x;
  const Real left = Real(x) + a.x;
  const Real slope = pencil.slope + pencil.spread * a.x;
  const Real width_slope = width * pencil.spread;
  constexpr int steepest = 12;  // bits
  if (slope.bits() > steepest || width_slope.bits() > steepest || left.bits() > 17 || width.bits() > 15) return false;
  // Over all lines less than 1/8 of a place each.
  const auto put = [](std::int64_t& to, const Real& value, int bits) {
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
    per_threshold_ = Real(1) / Real(static_cast<std::int64_t>(job.table.levels - 1) * g.parallel);
    const int root_bits = (static_cast<int>(std::bit_width(static_cast<std::uint64_t>(arc.unsure()))) + 1) / 2;
    narrow_ = 1U << std::clamp(7 - arc.steepness_bits(), 1, 7);
    rim_ = 1U << std::max(8, root_bits + 5);
  }

  bool run() {
    std::uint32_t first = beside_end;
    while (arc_.place(first) > 2) first /= 2;
    while (arc_.place(last_) < (1 << 24) - 3) last_ += (0U - last_) / 2;
    if (!settle_level(first)) return false;
    add(first);
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
    const Real t =
        Real(static_cast<std::int64_t>(k) * g.unit - static_cast<std::int64_t>(job_.table.levels - 1) * g.ambient) *
        per_threshold_;
    const auto fraction = static_cast<std::uint64_t>(t.fixed(60)) << 2;
    return {static_cast<std::int64_t>(high_product(fraction, fraction))};
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
  // Over what is not proven.
  [[nodiscard]] bool step_over(std::uint32_t end) {
    if (keeps_level(end - at_)) return settle_level(end);
    const std::int32_t place = arc_.place(at_);
    if (!settle_level(end) || !holds(place, arc_.place(at_))) return false;
    add_place(place);
    return true;
  }
  // The level is sure to be the same all the way.
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
    for (;;) {
      const std::int32_t k = up ? level_ + 1 : level_;
      if (k > job_.table.top_level || k <= job_.table.ambient_level) break;
      const LevelBar next = bar(k);
      const int beyond = sign_of(next.excess(light_at_end));
      if (beyond == 0) return false;
      if ((beyond > 0) != up) break;
      if (!cross(next, rise, end)) return false;
      level_ += rise;
      add_place(arc_.place(before_));
    }
    at_ = end;
    light_ = light_at_end;
    return true;
  }
  // From at_, where `next` is not crossed, to just beyond the crossing; before_ is just before it. Newton's steps, each beyond the root
  // by `narrow` once it is near; halves where they lead astray.
  [[nodiscard]] bool cross(const LevelBar& next, int direction, std::uint32_t end) {
    before_ = at_;
    at_ = end;
    std::uint32_t x = before_;
    std::uint32_t half = narrow_;
    ArcLight light = light_;
    for (int tries = 0; tries < most_tries; ++tries) {
      const std::int64_t excess = next.excess(light);
      const int sign = sign_of(excess) * direction;
      if (sign < 0) before_ = x;
      if (sign > 0) {
        at_ = x;
        light_ = light;
      }
      if (at_ - before_ <= 2 * half + 2) return holds(arc_.place(before_), arc_.place(at_));
      if (sign == 0) half = std::min(2 * half, near_root);
      std::int64_t step = next.step(light, excess);
      if (step > -std::int64_t{near_root} && step < std::int64_t{near_root}) {
        step += sign > 0 ? -std::int64_t{half} : std::int64_t{half};
      }
      const std::int64_t guess = x + step;
      x = guess > before_ && guess < at_ ? static_cast<std::uint32_t>(guess) : before_ + (at_ - before_) / 2;
      light = arc_.at(x);
    }
    return false;
  }

  void add(std::uint32_t tau) { add_place(arc_.place(tau)); }
  // What lies right of there has level_. Places may be a unit too high, and a limb's is 0.
  void add_place(std::int32_t place) {
    if (count_ < block_.size()) {
      block_[count_] = static_cast<std::uint32_t>(std::max<std::int32_t>(place - 1, 0)) << entry_level_bits |
                       static_cast<std::uint32_t>(level_);
    }
    ++count_;
  }

  const ShadeJob& job_;
  const CrossArc& arc_;
  std::span<std::uint32_t> block_;
  Real per_threshold_;
  std::uint32_t at_ = 0, before_ = 0;
  std::uint32_t last_ = 0U - beside_end;
  std::uint32_t narrow_;  // half of the interval in which a change is left, as a rule
  ArcLight light_{};
  std::uint32_t rim_;  // beside a ridge: a level that only touches it is sure not to be reached so far off
  std::int32_t level_ = -1, widest_ = 2;
  std::size_t count_ = 0;
};

}  // namespace

bool survey_rulings(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  // A cone's lines towards its apex need more of its rulings: those of a quarter of the way.
  const std::int32_t beyond = 64 + (x1 - x0) * 3 / 2;
  StraightContours& out = job.contours->straight;
  out.entries = 0;
  const Outline outline(job.face);
  const std::int32_t x = x0 + (x1 - x0) / 2;
  const std::int32_t face_x = x - job.face.origin_x;
  const std::int32_t face_y = y - job.face.origin_y;
  const Pencil pencil = is_parallel(outline) ? parallels(outline) : through_centre(outline, face_x, face_y);
  const CrossLine line = cross_line(job, outline, pencil, face_x, face_y);
  ArcEnd a;
  ArcEnd b;
  if (!ends_of_face(line, beyond, a, b)) return false;
  if (!aim(pencil, x, a, b, out)) return false;
  CrossArc arc;
  if (!arc.make(line, a, b, job.lighting)) return false;
  Survey survey(job, arc);
  if (!survey.run()) return false;
  out.line = y;
  out.entry_width = survey.entry_width();
  out.entries = static_cast<std::int32_t>(survey.count());
  return true;
}

// D in Reals: what cancels has a larger error.
bool is_surely_curved(const ActiveFace& face) {
  const auto c = [&face](int i) { return Real(face.c[static_cast<std::size_t>(i)], 0); };
  const auto minor = [&c](int i, int j, int k, int l) { return c(i) * c(j) - c(k) * c(l); };
  const Real a = minor(5, 5, 2, 0);
  const Real b = minor(5, 4, 2, 3);
  const Real d = minor(4, 4, 2, 1);
  const Real e = minor(5, 8, 2, 6);
  const Real f = minor(4, 8, 2, 7);
  const Real g = minor(8, 8, 2, 9);
  const Real bef = b * e * f;
  const Real terms[5] = {a * d * g, bef + bef, -a * f * f, -d * e * e, -g * b * b};
  Real sum;
  int most = std::numeric_limits<int>::min();
  for (const Real& term : terms) {
    sum = sum + term;
    if (!term.is_zero()) most = std::max(most, term.bits());
  }
  return sum.sign() != 0 && sum.bits() > most - 15;  // both are at most a bit too many
}

// The determinant of D's matrix is c2^2 times the quadric's, up to sign; it is taken from integers, as RootSurface's may be rounded.
// What it is above 0 for, such as a cylinder written in decimals, cross_line() makes an error.
bool has_straight_contours(const ShadeJob& job) {
  const Outline d(job.face);
  const std::array<Product, 5> terms = d.determinant_terms();
  Product sum;
  int most = 0;
  for (const Product& term : terms) {
    sum += term;
    most = std::max(most, term.bit_length());
  }
  return sum.is_zero() || sum.bit_length() <= most - 16;
}

bool has_wide_coefficients(const ActiveFace& face) {
  return std::any_of(face.c.begin(), face.c.end(),
                     [](const Wide<128>& c) { return c.bit_length() > most_coefficient_bits; });
}

// The rulings' common point lies there; of parallel rulings, which have none, D is a square on every line or on none.
std::int32_t kinked_line_of(const ActiveFace& face) {
  const Outline d(face);
  const Product spread = d.spread();
  if (spread.is_zero()) return d.product(3, 3) == d.product(0, 5) << 2 ? all_lines : no_line;
  const Real y = Real(d.pole_y(), 0) / Real(spread, 0);
  if (y.bits() > coordinate_bits) return no_line;
  const auto nearest = static_cast<std::int32_t>((y.fixed(1) + 1) >> 1);
  return spread.times(nearest) == d.pole_y() ? nearest + face.origin_y : no_line;
}

}  // namespace halfspace
