// Any face with z^2: a scan line is cut into pieces on which the intensity is proven monotone (ridge_form.hpp), and in each the
// boundaries between levels are found one after the other, as the changes of a certain sign between neighbouring dots.
//   Where    The last boundary's place and the intensity's slope there and at the one before predict the next one to a fraction
//            of a dot.
//   Proof    Level k is reached in (x, s) where f = L - t |N| >= 0: f is concave, so its tangent plane at a dot that reaches k
//            bounds it from above, and shows as a rule that the neighbour does not reach k. Otherwise the neighbour is asked.
// State   None between lines.
#include <algorithm>

#include "firmware/core/contour.hpp"
#include "firmware/core/line_section.hpp"
#include "firmware/core/ridge_form.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t short_piece = 6;  // dots that are asked one by one, rather than cut further
constexpr int place_fraction = 14;       // of places and ways, in dots
constexpr int squares_unit = 24;         // squares and their slopes are cut to 2^24 where they predict

// 1 / value in its leading 16 bits: 2^31 / inverse is value 2^-shift. Known from 2^15 on.
struct Reciprocal {
  std::int32_t inverse = 0;
  int shift = 0;
  bool negative;
  bool known;

  explicit Reciprocal(std::int32_t value) : negative(value < 0) {
    const auto size = static_cast<std::uint32_t>(negative ? -value : value);
    known = size >= 1U << 15;
    if (!known) return;
    shift = 16 - std::countl_zero(size);
    inverse = static_cast<std::int32_t>((1U << 31) / (size >> shift) - 1);
  }
  // dividend / value with place_fraction bits, to about 2^-15 of itself.
  [[nodiscard]] std::int32_t times(std::int32_t dividend) const {
    const auto quotient = static_cast<std::int32_t>(std::int64_t{dividend >> shift} * inverse >> (31 - place_fraction));
    return negative ? -quotient : quotient;
  }
};

// In units of 2^squares_unit, at most 2^30 in size.
std::int32_t cut(std::int64_t square) {
  constexpr std::int32_t most = 1 << 30;
  const std::int64_t value = square >> squares_unit;
  const auto low = static_cast<std::int32_t>(value);
  if (value == low && low < most && low > -most) return low;
  return value < 0 ? -most : most;
}

// A dot with its level, where a piece may begin or end.
struct Stop {
  std::int32_t t;
  RidgeDot ridge;
  std::int32_t level;
};

// A dot against the bar of a level: g = L^2 - t^2 |N|^2, and its slope; cut, and 0 where that is not known.
struct Probe {
  LitDot dot;
  LitSlope slope;
  std::uint32_t square;
  std::int32_t g, g1;
};

// Where the boundaries of a monotone piece are to be expected, from left to right.
class Forecast {
 public:
  // A boundary's place, and the way from level to level there.
  void add(std::int32_t place, std::int32_t way) {
    last_way_ = known_ ? way_ : way;
    place_ = place;
    way_ = way;
    known_ = true;
  }
  // The way changes evenly from boundary to boundary [Adams, Bashforth].
  [[nodiscard]] std::int32_t next() const {
    return place_ + std::clamp(way_ + (way_ - last_way_) / 2, way_ / 2, 2 * way_);
  }

 private:
  std::int32_t place_ = 0, way_ = 0, last_way_ = 0;
  bool known_ = false;
};

class SpanTracer {
 public:
  SpanTracer(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job),
        y_(y),
        line_(job, y, x0, x1),
        ridge_(line_),
        painter_(job.painter, x0, 0),
        proof_margin_(static_cast<std::int32_t>(line_.quick_margin().squares >> squares_unit) +
                      (1 << (36 - squares_unit))),
        base_(static_cast<std::int32_t>((std::int64_t{job.table.levels - 1} * job.lighting.ambient << 4) /
                                        job.lighting.unit)) {}

  void run(std::int32_t x0, std::int32_t x1);

 private:
  [[nodiscard]] std::uint32_t square(std::int32_t k) const { return job_.table.squares[static_cast<std::size_t>(k)]; }
  // Whether a quick dot reaches level k, its g = L^2 - t^2 |N|^2 given or not.
  [[nodiscard]] bool reaches(const LitDot& dot, std::int32_t k, std::int64_t g) const {
    const Margin& sure = line_.quick_margin();
    if (line_.deep(dot) && dot.light.l > sure.light) {
      if (g > sure.squares) return true;
      if (g < -sure.squares) return false;
    }
    return settle(dot.t, k);
  }
  [[nodiscard]] bool reaches(const LitDot& dot, std::int32_t k) const {
    return reaches(dot, k, dot.light.l * dot.light.l - scale_by(square(k), dot.light.n2));
  }
  [[nodiscard, gnu::noinline]] bool settle(std::int32_t t, std::int32_t k) const {
    const LitDot dot = line_.dot(t);
    const Answer answer = compare(dot.light, line_.margin(dot, square(k)), square(k));
    return answer == Answer::unsure ? reaches_level(job_, line_.middle() + t, y_, k) : answer == Answer::yes;
  }
  [[nodiscard]] RidgeDot ridge_at(std::int32_t t) const {
    const std::int32_t s = line_.root(t);
    return ridge_.at(t, s, line_.root_error(s));
  }
  // Its level sought from a level near it, or -1.
  [[nodiscard]] Stop stop_at(std::int32_t t, const RidgeDot& ridge, std::int32_t near) const {
    const LitDot dot = line_.quick_dot(t);
    return {t, ridge, search_level(job_.table, near, [&](std::int32_t k) { return reaches(dot, k); })};
  }
  [[nodiscard]] Stop stop_at(std::int32_t t, std::int32_t near) const { return stop_at(t, ridge_at(t), near); }

  [[nodiscard]] Course next_piece(const Stop& a, Stop& b) const;
  Stop dot_by_dot(const Stop& from, std::int32_t to);
  struct RidgeStop {
    std::int32_t t;
    RidgeDot ridge;
  };
  RidgeStop last_alike(RidgeStop from, RidgeStop other) const;
  void ridge_between(const Stop& a, const Stop& b);
  void monotone(const Stop& a, const Stop& b);
  std::int32_t boundary(std::int32_t k, std::int32_t in, std::int32_t out, std::int32_t guess,
                        Forecast& forecast) const;
  bool probe(Probe& p, std::int32_t t, std::int32_t k) const;
  [[gnu::always_inline]] std::int64_t measure(Probe& p, std::uint32_t square) const;
  [[nodiscard]] bool neighbour_fails(const Probe& p, std::int32_t e) const;
  [[nodiscard]] std::int32_t way(const Probe& p, const Reciprocal& slope, std::int32_t k) const;

  void turn(std::int32_t t, std::int32_t level) {
    painter_.change(line_.middle() + t, level);
    ++job_.counters.level_spans;
  }

  const ShadeJob& job_;
  std::int32_t y_;
  LineSection line_;
  RidgeForm ridge_;
  RunPainter painter_;
  std::int32_t proof_margin_;  // of g', for neighbour_fails
  std::int32_t base_;          // levels that ambient light alone gives, in sixteenths
};

// Each dot after `from` up to `to` for itself.
Stop SpanTracer::dot_by_dot(const Stop& from, std::int32_t to) {
  std::int32_t level = from.level;
  for (std::int32_t t = from.t + 1; t <= to; ++t) {
    const LitDot dot = line_.quick_dot(t);
    const std::int32_t next = search_level(job_.table, level, [&](std::int32_t k) { return reaches(dot, k); });
    if (next != level) turn(t, next);
    level = next;
    ++job_.counters.intensities;
  }
  return {to, ridge_at(to), level};
}

// The last dot from `from` towards another whose course is surely that of `from`, where the form has one root between them.
SpanTracer::RidgeStop SpanTracer::last_alike(RidgeStop from, RidgeStop other) const {
  const int sign = from.ridge.sign();
  for (int tries = 0;; ++tries) {
    const std::int32_t way = other.t - from.t;
    if (way == 1 || way == -1) return from;
    // Regula falsi, an end that stays halved [Dowell, Jarratt 1971]
    const Reciprocal slope((from.ridge.w >> 1) - (other.ridge.w >> 1));
    std::int32_t step = way / 2;
    if (tries < 8 && slope.known) {
      step = static_cast<std::int32_t>(std::int64_t{way} * slope.times(from.ridge.w >> 1) >> place_fraction);
    }
    step = way > 0 ? std::clamp<std::int32_t>(step, 1, way - 1) : std::clamp<std::int32_t>(step, way + 1, -1);
    const RidgeStop next{from.t + step, ridge_at(from.t + step)};
    if (next.ridge.sign() == sign) {
      from = next;
      other.ridge.w /= 2;
    } else {
      other = next;
      from.ridge.w /= 2;
    }
  }
}

void SpanTracer::ridge_between(const Stop& a, const Stop& b) {
  const RidgeStop first = last_alike({a.t, a.ridge}, {b.t, b.ridge});
  const Stop left = first.t == a.t ? a : stop_at(first.t, first.ridge, -1);
  monotone(a, left);
  RidgeStop last{left.t + 1, ridge_at(left.t + 1)};
  if (last.ridge.sign() != b.ridge.sign()) last = last_alike({b.t, b.ridge}, first);
  monotone(dot_by_dot(left, last.t), b);
}

// Returns g itself.
inline std::int64_t SpanTracer::measure(Probe& p, std::uint32_t square) const {
  const auto l = static_cast<std::int32_t>(p.dot.light.l);
  const std::int64_t g = std::int64_t{l} * l - scale_by(square, p.dot.light.n2);
  p.square = square;
  p.g = cut(g);
  p.g1 = 0;
  if (!p.slope.known) return g;
  const std::int32_t fall = high_product(static_cast<std::int32_t>(square >> 1), p.slope.n2);  // of 2^29
  p.g1 = cut(2 * std::int64_t{l} * p.slope.l - std::int64_t{fall} * (1 << 29));
  return g;
}

// Whether dot t reaches level k.
bool SpanTracer::probe(Probe& p, std::int32_t t, std::int32_t k) const {
  p.dot = line_.quick_dot(t);
  p.slope = line_.slope(p.dot);
  return reaches(p.dot, k, measure(p, square(k)));
}

// Whether the dot beside p's, e = -1 or 1 away, surely fails a level that p's reaches.
//   f(X) <= L(X) - t N(X).N / |N|, since |N| is convex; so with s there within eps of its tangent
//     f(neighbour) <= f + e f' + (|m| + |v|) eps.
//   Times 2 L, where with t |N| = sqrt(L^2 - g) and g <= L^2 / 8
//     2 L f = g (1 + f / (L + t |N|)) <= g (1 + 1/29),  and 2 L f' is g' but for g |(|N|^2)'| / 2 |N|^2 at most,
//   so it is <= g + g / 16 + e g' + 2 L (|m| + |v|) eps where |(|N|^2)'| <= |N|^2 / 32.
//   s' errs by less than 2^7, so L' by 260, (|N|^2)' by 2^38 and g' by 2^10 L + 2^38 t^2; L, by 34, and what is cut add less than
//   2^36. |N|^2 errs by 2^35, so it must be larger than 2^39.
bool SpanTracer::neighbour_fails(const Probe& p, std::int32_t e) const {
  if (!p.slope.steady || p.dot.light.l <= 0) return false;
  const auto l = static_cast<std::uint32_t>(p.dot.light.l);
  const std::int32_t room = (e > 0 ? -p.g1 : p.g1) - p.g - (p.g >> 4) -
                            static_cast<std::int32_t>((l >> 14) + (p.square >> 18)) - proof_margin_;
  if (room <= 0 || p.g >> 5 > static_cast<std::int32_t>(high_product(l, l))) return false;
  const auto n2 = static_cast<std::int32_t>(p.dot.light.n2 >> 33);
  return n2 >= 1 << 6 && p.slope.n2 <= n2 && -p.slope.n2 <= n2 && line_.straight(p.dot, room);
}

// Dots from level to level: f' / f0 a dot, f0 = t |N| / (k - base) a level, and 2 L f' ~ g'.
std::int32_t SpanTracer::way(const Probe& p, const Reciprocal& slope, std::int32_t k) const {
  const auto l = static_cast<std::uint32_t>(p.dot.light.l);
  const std::int32_t all = slope.times(static_cast<std::int32_t>(high_product(l, l)));  // in 2^8 dots, and twice
  const std::int32_t sixteenths = std::max<std::int32_t>(16 * k - base_, 1);
  const std::int32_t size = std::min<std::int32_t>(all < 0 ? -all : all, 1 << 22);
  return std::min<std::int32_t>((size << 8) / sixteenths, 1 << 19) << 5;
}

// The last dot from `in`, which reaches level k, towards `out`, which does not, that reaches it. Asked first at `guess`; then
// where the slope points, or in the middle where that is outside.
std::int32_t SpanTracer::boundary(std::int32_t k, std::int32_t in, std::int32_t out, std::int32_t guess,
                                  Forecast& forecast) const {
  const std::int32_t e = out > in ? 1 : -1;
  Probe p;
  for (int tries = 0;; ++tries) {
    const bool reached = probe(p, guess, k);
    const Reciprocal slope(p.g1);
    const std::int32_t place = (guess << place_fraction) - slope.times(p.g);
    (reached ? in : out) = guess;
    guess = e > 0 ? place >> place_fraction : -(-place >> place_fraction);
    if (reached && in + e != out && (guess - in) * e < 2) {
      if (neighbour_fails(p, e) || !reaches(line_.quick_dot(in + e), k)) {
        out = in + e;
      } else {
        in += e;
      }
    }
    if (in + e == out) {
      forecast.add(place, way(p, slope, k));
      return in;
    }
    const bool inside = slope.known && (guess - in) * e >= 0 && (out - guess) * e >= 0;
    if (!inside || tries % 4 == 3) guess = in + (out - in) / 2;
    guess = std::clamp(guess, std::min(in, out) + 1, std::max(in, out) - 1);
  }
}

void SpanTracer::monotone(const Stop& a, const Stop& b) {
  if (a.level == b.level) return;
  const bool rising = a.level < b.level;
  const std::int32_t first = rising ? a.level + 1 : a.level;
  const std::int32_t past = rising ? b.level + 1 : b.level;
  Probe p;
  p.dot = line_.quick_dot(a.t);
  p.slope = line_.slope(p.dot);
  measure(p, square(first));
  std::int32_t place = (a.t << place_fraction) - Reciprocal(p.g1).times(p.g);
  std::int32_t known = a.t;  // fails the next level if rising, else reaches it
  Forecast forecast;
  for (std::int32_t k = first; k != past; k += rising ? 1 : -1) {
    std::int32_t guess = rising ? -(-place >> place_fraction) : place >> place_fraction;
    if (k == first && (guess <= a.t || guess >= b.t)) guess = a.t + (b.t - a.t) / 2;
    if (rising) {
      known = boundary(k, b.t, known, std::clamp(guess, known + 1, b.t), forecast);
      turn(known--, k);
    } else {
      known = boundary(k, known, b.t, std::clamp(guess, known, b.t - 1), forecast);
      turn(known + 1, k - 1);
    }
    place = forecast.next();
  }
}

// The course from a to b, b drawn nearer until it is sure, or short, or a's own course is not sure.
Course SpanTracer::next_piece(const Stop& a, Stop& b) const {
  while (b.t - a.t > short_piece) {
    const Course course = ridge_.course(a.ridge, b.ridge);
    if (course != Course::unsure || a.ridge.sign() == 0) return course;
    b = stop_at(a.t + (b.t - a.t) / 2, a.level);
  }
  return Course::unsure;
}

void SpanTracer::run(std::int32_t x0, std::int32_t x1) {
  if (line_.dark()) {
    painter_.change(x0, job_.table.ambient_level);
    painter_.end(x1);
    ++job_.counters.level_spans;
    return;
  }
  Stop a = stop_at(x0 - line_.middle(), -1);
  const Stop last = stop_at(x1 - line_.middle(), -1);
  painter_.change(x0, a.level);
  ++job_.counters.level_spans;
  std::int32_t skip = 1;
  while (a.t < last.t) {
    Stop b = last;
    const Course course = next_piece(a, b);
    if (course == Course::unsure) {
      // Where the form vanishes, as on a ruling, ever longer runs go dot by dot.
      skip = std::min<std::int32_t>(2 * skip, 64);
      a = dot_by_dot(a, a.ridge.sign() == 0 ? std::min(a.t + skip, last.t) : b.t);
      continue;
    }
    skip = 1;
    if (course == Course::ridge) {
      ridge_between(a, b);
    } else {
      monotone(a, b);
    }
    a = b;
  }
  painter_.end(x1);
}

}  // namespace

bool general_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  while (x0 <= x1) {
    const std::int32_t end = std::min(x1, x0 + 2 * longest_half - 1);
    SpanTracer(job, y, x0, end).run(x0, end);
    x0 = end + 1;
  }
  return true;
}

}  // namespace halfspace
