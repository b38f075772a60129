#include "firmware/core/straight_contour.hpp"

#include <algorithm>

#include "firmware/core/contour.hpp"
#include "firmware/core/line_section.hpp"
#include "firmware/core/real.hpp"
#include "firmware/core/ridge_form.hpp"

namespace halfspace {
namespace {

constexpr int most_part_bits = 13;
constexpr std::int32_t place_error = 4;  // parts: three roundings down, and the scale's error on a b of 24 bits
constexpr std::int32_t zone_rim = 32;  // parts that a zone takes beyond its right dot, more than what a dot is asked by
constexpr std::int32_t reach_beyond = 64;  // dots traced beyond a span, as far as the face goes
constexpr std::uint32_t least_dots = 32;   // of a span: a shorter one is not worth a trace
constexpr std::uint32_t patience = 3;      // a trace costs some lines shaded otherwise: once in so many

// --- the face ---

// D before anything was rounded: from coefficients of c bits, its own have at most 2c + 2, and its values 34 more.
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
  // 0 where rulings are parallel; the common point's y times it is pole().
  [[nodiscard]] Product spread() const { return (product(0, 2) << 2) - product(1, 1); }
  [[nodiscard]] Product pole() const { return product(1, 3) - (product(0, 4) << 1); }
  [[nodiscard]] bool is_outside(std::int32_t x, std::int32_t y) const {
    const Coefficient d = (q[0].times(x) + q[1].times(y) + q[3]).times(x) + (q[2].times(y) + q[4]).times(y) + q[5];
    return d.negative();
  }
};

bool is_ruled(const ActiveFace& face) {
  const Outline d(face);
  const Product twice = (d.product(0, 2, 5) << 2) + d.product(1, 3, 4);
  return twice == d.product(0, 4, 4) + d.product(2, 3, 3) + d.product(5, 1, 1);
}

// Slope and spread of the lines through the rulings' common point as seen from a dot of the face's frame; false where they run
// along the scan line, or come too near to that for the fixed point.
bool aim(const Outline& outline, std::int32_t x, std::int32_t y, StraightContours& out) {
  Real d[6];
  for (int i = 0; i < 6; ++i) d[i] = Real(outline.q[i], 0);
  const Real two_d0 = d[0] + d[0];
  Real slope;
  Real spread;
  const Product parallel = outline.spread();
  if (parallel.is_zero()) {
    if (outline.q[0].is_zero()) return false;
    slope = -d[1] / two_d0;
  } else {
    const Real w(parallel, 0);
    spread = w / (Real(y) * w - Real(outline.pole(), 0));
    slope = (Real(x) - (d[1] * d[4] - (d[2] + d[2]) * d[3]) / w) * spread;
  }
  out.slope = slope.fixed(32);
  out.spread = spread.fixed(46);
  return slope.bits() <= 12 && slope.error_of(32) <= 8 && spread.bits() <= 0 && spread.error_of(46) <= 8;
}

// --- entries ---

// A zone is soft where the levels on its two sides are the same: it can shrink.
enum class Turn : std::uint8_t { down, zone, up, soft_zone };
constexpr bool is_zone(std::uint32_t entry) { return (entry & 1) != 0; }

struct Entry {
  std::int32_t b, width;
  Turn turn;
};

// With the least width that an entry can hold and that is not less.
std::uint32_t packed(const Entry& e) {
  const std::int32_t width = std::max<std::int32_t>(e.width, 0);
  int exponent = 0;
  while ((width + (1 << exponent) - 1) >> exponent > 7) ++exponent;
  const std::int32_t mantissa = std::max<std::int32_t>((width + (1 << exponent) - 1) >> exponent, 4) - 4;
  return static_cast<std::uint32_t>(e.b) << 8 |
         static_cast<std::uint32_t>(mantissa << 6 | exponent << 2 | static_cast<std::int32_t>(e.turn));
}
std::int32_t width_of(std::uint32_t entry) {
  return static_cast<std::int32_t>((4 + (entry >> 6 & 3)) << (entry >> 2 & 15));
}
Entry unpacked(std::uint32_t entry) {
  return {static_cast<std::int32_t>(entry >> 8), width_of(entry), static_cast<Turn>(entry & 3)};
}

// Certain levels of one line's dots.
class DotLevels {
 public:
  DotLevels(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job), y_(y), line_(job, y, x0, x1) {}

  [[nodiscard]] const LineSection& line() const { return line_; }
  [[nodiscard]] std::uint32_t square(std::int32_t k) const { return job_.table.squares[static_cast<std::size_t>(k)]; }
  [[nodiscard]] LitDot dot(std::int32_t x) const { return line_.dot(x - line_.middle()); }
  [[nodiscard]] bool reaches(const LitDot& dot, std::int32_t k) const {
    const Answer answer = compare(dot.light, line_.margin(dot, square(k)), square(k));
    return answer == Answer::unsure ? reaches_level(job_, line_.middle() + dot.t, y_, k) : answer == Answer::yes;
  }
  // From dot a to b.
  [[nodiscard]] bool is_monotone(const RidgeForm& form, const LitDot& a, const LitDot& b) const {
    const Course course =
        form.course(form.at(a.t, a.s, line_.root_error(a.s)), form.at(b.t, b.s, line_.root_error(b.s)));
    return course == Course::rising || course == Course::falling;
  }
  // Sought from a level near it, or -1.
  [[nodiscard]] std::int32_t level(const LitDot& dot, std::int32_t near) const {
    return search_level(job_.table, near, [&](std::int32_t k) { return reaches(dot, k); });
  }

 private:
  const ShadeJob& job_;
  std::int32_t y_;
  LineSection line_;
};

// --- between dots ---

// A polynomial of the line u 2^-bits right of dot t, less than 2^9 too small; where the section's half is at least 32, so that
// no product overflows and what is lost is small beside the polynomial's own error of half^2.
constexpr std::int32_t least_half = 32;
std::int64_t between(const LinePolynomial& p, std::int32_t t, std::int32_t u, int bits) {
  const std::int64_t slope = p.slope(t) + ((p.v2 >> 8) * u >> (bits - 8));
  return p.at(t) + ((slope >> 8) * u >> (bits - 8));
}

Light light_between(const LineSection& line, std::int32_t t, std::int32_t u, int bits, LitDot& dot) {
  const std::int64_t d = between(line.discriminant(), t, u, bits);
  dot.s = d > 0 ? quick_root(static_cast<std::uint64_t>(d)) : 0;
  dot.r = static_cast<std::int32_t>(between(line.square_root(), t, u, bits) >> 32);
  dot.light.l = (between(line.light(), t, u, bits) >> LineSection::light_fraction) +
                (std::int64_t{line.light_root()} * dot.s >> 30);
  dot.light.n2 = std::max<std::int64_t>(between(line.square(), t, u, bits) + std::int64_t{dot.r} * dot.s, 0);
  return dot.light;
}

// L^2 - t^2 |N|^2, with L's sign.
std::int64_t excess(const Light& light, std::uint32_t square) {
  return light.l * (light.l < 0 ? -light.l : light.l) - scale_by(square, light.n2);
}

// --- tracing a line ---

class Trace {
 public:
  Trace(const ShadeJob& job, std::int32_t y, std::int32_t from, std::int32_t to)
      : out_(job.contours->straight),
        block_(job.contours->block),
        levels_(job, y, from, to),
        form_(levels_.line()),
        to_(to) {
    out_.line = y;
    out_.first = from - 1;
    out_.length = to - from + 2;
    out_.entries = 0;
    out_.part_bits = static_cast<std::uint8_t>(
        std::min(most_part_bits, 24 - static_cast<int>(std::bit_width(static_cast<std::uint32_t>(out_.length)))));
  }
  // False where the block is too short.
  bool run() {
    constexpr std::int32_t stretch = 8;
    LitDot a = levels_.dot(out_.first + 1);
    out_.level = levels_.level(a, -1);
    if (!add_zone(out_.first, Turn::soft_zone)) return false;  // up to a limb
    std::int32_t level = out_.level;
    for (std::int32_t x = out_.first + 1; x < to_;) {
      const std::int32_t end = std::min(x + stretch, to_);
      const LitDot b = levels_.dot(end);
      const bool sure = is_monotone(a, b);
      while (x < end) {
        const LitDot next = ++x == end ? b : levels_.dot(x);
        const std::int32_t before = level;
        level = levels_.level(next, before);
        if (!add_step(x - 1, before, level, a, next, sure || is_monotone(a, next))) return false;
        a = next;
      }
    }
    return add_zone(to_, Turn::soft_zone);
  }

 private:
  [[nodiscard]] bool is_monotone(const LitDot& a, const LitDot& b) const { return levels_.is_monotone(form_, a, b); }
  [[nodiscard]] std::int32_t parts(std::int32_t x) const { return (x - out_.first) << out_.part_bits; }

  bool add(const Entry& entry) {
    if (static_cast<std::size_t>(out_.entries) == block_.size()) return false;
    block_[static_cast<std::size_t>(out_.entries++)] = packed(entry);
    return true;
  }
  bool add_zone(std::int32_t x, Turn turn) { return add({parts(x), (1 << out_.part_bits) + zone_rim, turn}); }
  // From dot x to the next.
  bool add_step(std::int32_t x, std::int32_t from, std::int32_t to, const LitDot& a, const LitDot& b, bool monotone) {
    if (monotone) {
      for (; from < to; ++from) {
        if (!add(narrowed(x, from + 1, Turn::up, a, b))) return false;
      }
      for (; from > to; --from) {
        if (!add(narrowed(x, from, Turn::down, a, b))) return false;
      }
      return true;
    }
    return add_zone(x, from == to ? Turn::soft_zone : Turn::zone) && add_turns({parts(x + 1), 0, Turn::up}, from, to);
  }
  // Where level k begins or ends between dots a and b, by regula falsi: a sign is asked a sixteenth of the interval beyond the
  // root that is expected, so that both ends close in.
  [[nodiscard]] Entry narrowed(std::int32_t x, std::int32_t k, Turn turn, const LitDot& a, const LitDot& b) const {
    const LineSection& line = levels_.line();
    const std::uint32_t square = levels_.square(k);
    std::int32_t low = 0;
    std::int32_t high = 1 << out_.part_bits;
    if (line.half() < least_half) return {parts(x), high, turn};
    std::int64_t low_excess = excess(a.light, square);
    std::int64_t high_excess = excess(b.light, square);
    for (int tries = 0; tries < 6 && high - low > 8; ++tries) {
      const std::int32_t u = expected(low, high, low_excess, high_excess);
      LitDot dot = a;
      const Light light = light_between(line, a.t, u, out_.part_bits, dot);
      const Margin margin = line.margin(dot, square);
      const Answer answer = compare(light, {2 * margin.light, 2 * margin.squares}, square);
      if (answer == Answer::unsure) break;
      const bool beyond = (answer == Answer::yes) == (turn == Turn::up);
      (beyond ? high : low) = u;
      (beyond ? high_excess : low_excess) = excess(light, square);
    }
    return {parts(x) + low, high - low, turn};
  }
  static std::int32_t expected(std::int32_t low, std::int32_t high, std::int64_t low_excess, std::int64_t high_excess) {
    const std::uint64_t a =
        low_excess < 0 ? -static_cast<std::uint64_t>(low_excess) : static_cast<std::uint64_t>(low_excess);
    const std::uint64_t b =
        high_excess < 0 ? -static_cast<std::uint64_t>(high_excess) : static_cast<std::uint64_t>(high_excess);
    const int shift = std::max(0, static_cast<int>(std::bit_width(a | b)) - 16);
    const auto part = static_cast<std::uint32_t>(a >> shift);
    const auto whole = part + static_cast<std::uint32_t>(b >> shift) + 1;
    const std::int32_t width = high - low;
    const auto root = static_cast<std::int32_t>(static_cast<std::uint32_t>(width) * part / whole);
    return low +
           std::clamp<std::int32_t>(2 * root < width ? root + width / 16 + 1 : root - width / 16 - 1, 1, width - 1);
  }
  bool add_turns(Entry entry, std::int32_t from, std::int32_t to) {
    entry.turn = from < to ? Turn::up : Turn::down;
    for (std::int32_t n = from < to ? to - from : from - to; n > 0; --n) {
      if (!add(entry)) return false;
    }
    return true;
  }

  StraightContours& out_;
  std::span<std::uint32_t> block_;
  DotLevels levels_;
  RidgeForm form_;
  std::int32_t to_;
};

// The farthest dot from x towards `limit` up to which the face has points on the line; where D is convex, x.
std::int32_t end_of_face(const Outline& outline, const ActiveFace& face, std::int32_t y, std::int32_t x,
                         std::int32_t limit) {
  if (outline.q[0].sign() > 0) return x;
  std::int32_t beyond = limit + (limit > x ? 1 : -1);
  while (beyond - x > 1 || x - beyond > 1) {
    const std::int32_t middle = x + (beyond - x) / 2;
    (outline.is_outside(middle - face.origin_x, y - face.origin_y) ? beyond : x) = middle;
  }
  return x;
}

bool trace(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  StraightContours& out = job.contours->straight;
  out.length = 0;
  const Outline outline(job.face);
  const std::int32_t from = end_of_face(outline, job.face, y, x0, x0 - reach_beyond);
  const std::int32_t to = end_of_face(outline, job.face, y, x1, x1 + reach_beyond);
  if (to == from || to - from >= 2 * longest_half) return false;
  const bool traced =
      aim(outline, from - 1 - job.face.origin_x, y - job.face.origin_y, out) && Trace(job, y, from, to).run();
  if (!traced) out.length = 0;
  return traced;
}

// --- a span ---

class StraightSpan {
 public:
  StraightSpan(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job),
        s_(job.contours->straight),
        block_(job.contours->block),
        y_(y),
        x0_(x0),
        x1_(x1),
        run_(job.painter, x0, 0) {
    const std::int64_t down = y - s_.line;
    const std::int64_t scale = (std::int64_t{1} << 24) + (s_.spread * down >> 22);
    const std::int64_t base = (std::int64_t{s_.first} << s_.part_bits) + (s_.slope * down >> (32 - s_.part_bits));
    is_near_ = s_.length > 0 && scale >= 1 << 22 && scale <= 1 << 25 && base > -(1 << 29) && base < 1 << 29;
    scale_ = static_cast<std::uint32_t>(scale);
    base_ = static_cast<std::int32_t>(base);
    widen_ = scale > 1 << 24 ? 1 : 0;
    from_ = x0;
    level_ = s_.level;
  }
  // The traced line covers the span.
  [[nodiscard]] bool is_usable() const {
    if (!is_near_ || x1_ - x0_ >= 2 * longest_half) return false;
    const std::int32_t last = base_ + upper(static_cast<std::uint32_t>(s_.length) << (s_.part_bits + 8));
    return x0_ << s_.part_bits >= base_ + place_error && x1_ << s_.part_bits <= last - place_error;
  }

  void paint() {
    const std::int32_t asked = paint_certain(0);
    if (asked < s_.entries) paint_asking(asked);
    if (from_ <= x1_) run_.change(from_, level_);
    run_.end(x1_);
    job_.counters.level_spans += runs_ + 1;
  }

 private:
  // b scaled, given b 2^8.
  [[nodiscard]] std::int32_t upper(std::uint32_t b) const {
    return static_cast<std::int32_t>(std::uint64_t{b} * scale_ >> 32);
  }
  [[nodiscard]] std::int32_t one_dot() const { return 1 << s_.part_bits; }

  // Entries from i on, as far as their dots are certain: the loop that most of the time goes to. Returns the entry to ask about, or
  // the number of entries.
  std::int32_t paint_certain(std::int32_t i) {
    RunPainter run = run_;
    std::int32_t from = from_, level = level_;
    std::uint32_t runs = runs_;
    const std::uint32_t scale = scale_;
    const int bits = s_.part_bits, widen = widen_;
    const std::int32_t base = base_ + place_error + (1 << bits) - 1, mask = (1 << bits) - 1, x1 = x1_;
    const std::uint32_t* const entries = block_.data();
    const std::int32_t end = s_.entries;
    for (; i < end; ++i) {
      const std::uint32_t entry = entries[i];
      const std::int32_t width = width_of(entry) << widen;
      const std::int32_t t = base + static_cast<std::int32_t>(std::uint64_t{entry & ~0xffU} * scale >> 32) + width;
      if ((t & mask) < width + 2 * place_error) break;
      if (is_zone(entry)) continue;
      const std::int32_t x = t >> bits;
      if (x > from) {
        if (x > x1) {
          i = end;
          break;
        }
        run.change(from, level);
        ++runs;
        from = x;
      }
      level += static_cast<std::int32_t>(entry & 3) - 1;
    }
    run_ = run;
    from_ = from;
    level_ = level;
    runs_ = runs;
    return i;
  }

  // Between certain entries the uncertain ones from i on.
  [[gnu::noinline]] void paint_asking(std::int32_t i) {
    const DotLevels levels(job_, y_, x0_, x1_);
    for (; i < s_.entries; i = paint_certain(i + 1)) {
      const std::uint32_t entry = block_[static_cast<std::size_t>(i)];
      const std::int32_t width = width_of(entry) << widen_;
      const std::int32_t at = base_ + upper(entry & ~0xffU);
      const std::int32_t least = std::max((at - place_error + one_dot() - 1) >> s_.part_bits, x0_);
      const std::int32_t beyond = (at + width + place_error + one_dot() - 1) >> s_.part_bits;
      if (is_zone(entry)) {
        show_zone(levels, i, least, beyond);
      } else {
        block_[static_cast<std::size_t>(i)] = turn_at(levels, unpacked(entry), least, beyond);
      }
    }
  }

  // A crossing among dots least .. beyond - 1 or right of them; returns its entry, which may have shrunk.
  std::uint32_t turn_at(const DotLevels& levels, Entry known, std::int32_t least, std::int32_t beyond) {
    const bool up = known.turn == Turn::up;
    const std::int32_t end = known.b + known.width;
    std::int32_t x = least;
    for (; x < beyond && x <= x1_; ++x) {
      if (levels.reaches(levels.dot(x), up ? level_ + 1 : level_) == up) {
        known.width = std::min(end, back(x) + back_error()) - known.b;
        break;
      }
      known.b = std::max(known.b, back(x) - back_error());
      known.width = end - known.b;
    }
    if (x > from_ && x <= x1_) {
      run_.change(from_, level_);
      ++runs_;
      from_ = x;
    } else if (x > x1_) {
      show_rest();
    }
    level_ += up ? 1 : -1;
    return packed(known);
  }
  // Nothing right of the span's last dot is shown.
  void show_rest() {
    if (from_ <= x1_) run_.change(from_, level_);
    from_ = x1_ + 1;
  }

  // Dots of zone i, whose levels are all asked.
  void show_zone(const DotLevels& levels, std::int32_t& i, std::int32_t least, std::int32_t beyond) {
    Entry zone = unpacked(block_[static_cast<std::size_t>(i)]);
    std::int32_t level = level_;
    for (std::int32_t x = std::max(least, from_); x < std::min(beyond, x1_ + 1); ++x) {
      if (x > from_) run_.change(from_, level_);
      level = levels.level(levels.dot(x), level);
      run_.change(x, level);
      ++runs_;
      from_ = x + 1;
      if (zone.turn == Turn::soft_zone) shrink(levels, zone, i, x, beyond, level);
    }
    block_[static_cast<std::size_t>(i)] = packed(zone);
  }
  // A zone loses what lies between one of its dots and one of its ends where the intensity is monotone there. The level may change
  // there at a limb only, as nothing lies beyond: the changes become crossings.
  // The end itself is where an earlier dot was, known to back_error <= zone_rim / 2 and by a width rounded up to at most 5/4: so the
  // dot must surely lie on the zone's side of that one.
  void shrink(const DotLevels& levels, Entry& zone, std::int32_t& i, std::int32_t x, std::int32_t beyond,
              std::int32_t level) {
    const std::int32_t b = back(x);
    const std::int32_t e = back_error();
    const std::int32_t end = zone.b + zone.width;
    if (e > zone_rim / 2) return;
    if ((level == level_ || i == 0) && b + e <= zone.b + zone.width / 4 * 3 - zone_rim && x + 1 >= beyond &&
        is_monotone(levels, x)) {
      if (!insert(i + 1, std::max(b - e, zone.b), end, level, level_)) return;
      zone.width = b + e - zone.b;
      if (i == 0) s_.level = level_ = level;
    } else if ((level == level_ || i == s_.entries - 1) && b - e >= zone.b + zone_rim && is_left_of(x - 1, zone.b) &&
               is_monotone(levels, x - 1)) {
      const std::int32_t before = s_.entries;
      if (!insert(i, zone.b, std::min(b + e, end), level_, level)) return;
      i += s_.entries - before;
      level_ = level;
      zone.b = b - e;
      zone.width = end - zone.b;
    }
  }
  // From dot x to the next, both of the span.
  [[nodiscard]] bool is_monotone(const DotLevels& levels, std::int32_t x) const {
    if (x < x0_ || x >= x1_) return false;
    return levels.is_monotone(RidgeForm(levels.line()), levels.dot(x), levels.dot(x + 1));
  }
  [[nodiscard]] bool is_left_of(std::int32_t x, std::int32_t b) const {
    return x << s_.part_bits <= base_ + upper(static_cast<std::uint32_t>(b) << 8) - place_error;
  }
  // Crossings between b and end, from level to level, before entry i. False where the block is too short.
  bool insert(std::int32_t i, std::int32_t b, std::int32_t end, std::int32_t from, std::int32_t to) {
    const std::int32_t count = from < to ? to - from : from - to;
    if (static_cast<std::size_t>(s_.entries + count) > block_.size()) return false;
    std::uint32_t* const at = block_.data() + i;
    std::copy_backward(at, block_.data() + s_.entries, block_.data() + s_.entries + count);
    std::fill(at, at + count, packed({b, end - b, from < to ? Turn::up : Turn::down}));
    s_.entries += count;
    return true;
  }

  // The b of a dot, to within back_error: the place's error and a rounding, over the scale, and another rounding.
  [[nodiscard]] std::int32_t back(std::int32_t x) const {
    return static_cast<std::int32_t>((static_cast<std::int64_t>((x << s_.part_bits) - base_) * (1 << 24)) / scale_);
  }
  [[nodiscard]] std::int32_t back_error() const {
    return static_cast<std::int32_t>(((place_error + 1U) << 24) / scale_) + 2;
  }

  const ShadeJob& job_;
  StraightContours& s_;
  std::span<std::uint32_t> block_;
  std::int32_t y_, x0_, x1_;
  RunPainter run_;
  bool is_near_;
  std::uint32_t scale_;        // 2^24
  std::int32_t base_;          // of the traced line's b = 0 on this line: parts
  int widen_;                  // log2 of what a width may grow by
  std::int32_t from_, level_;  // from that dot on that level, not shown yet
  std::uint32_t runs_ = 0;
};

}  // namespace

bool straight_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  StraightContours& s = job.contours->straight;
  if (job.contours->block.empty()) return false;
  const auto dots = static_cast<std::uint32_t>(x1 - x0 + 1);
  StraightSpan span(job, y, x0, x1);
  if (span.is_usable()) {
    if (static_cast<std::uint32_t>(s.entries) > 4 * dots + 128) return false;
    span.paint();
    return true;
  }
  s.waited += dots;
  const FaceContours& face = *job.contours;
  const bool crowded = 20 * face.runs > (face.by_dots ? 19 : 80) * face.dots;  // too many entries to a dot
  if (s.waited < patience * dots || dots < least_dots || crowded) return false;
  s.waited = 0;
  if (!trace(job, y, x0, x1)) return false;
  StraightSpan traced(job, y, x0, x1);
  if (!traced.is_usable()) return false;
  traced.paint();
  return true;
}

bool has_wide_coefficients(const ActiveFace& face) {
  return std::any_of(face.c.begin(), face.c.end(),
                     [](const Wide<128>& c) { return c.bit_length() > most_coefficient_bits; });
}

// The rulings' common point lies on the line; of parallel rulings, which have none, D is a square on every line or on none.
bool is_kinked(const ActiveFace& face, std::int32_t y) {
  const Outline d(face);
  const Product spread = d.spread();
  if (spread.is_zero()) return d.product(3, 3) == d.product(0, 5) << 2;
  return spread.times(y - face.origin_y) == d.pole();
}

bool has_straight_contours(const ShadeJob& job) { return is_ruled(job.face); }

}  // namespace halfspace
