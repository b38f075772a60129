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
constexpr int place_fraction = 14;

// The leading `bits` bits of a number, at most 32: value ~ top 2^shift.
struct Leading {
  std::uint32_t top;
  int shift;

  Leading(std::uint64_t value, int bits) : top(0), shift(static_cast<int>(std::bit_width(value)) - bits) {
    top = static_cast<std::uint32_t>(shift >= 0 ? value >> shift : value << -shift);
  }
};

// a / b with 14 bits of fraction, to about 2^-14 of itself, and at most 2^29 in size.
std::int32_t quotient(std::int64_t a, std::int64_t b) {
  constexpr std::int32_t most = 1 << 29;
  const bool negative = (a < 0) != (b < 0);
  const Leading dividend(static_cast<std::uint64_t>(a < 0 ? -a : a), 32);
  const Leading divisor(static_cast<std::uint64_t>(b < 0 ? -b : b), 16);
  if (divisor.top == 0) return most;
  const int shift = dividend.shift - divisor.shift + place_fraction;  // of a quotient of 16 or 17 bits
  std::int32_t size = most;
  if (shift < -31) {
    size = 0;
  } else if (shift <= 12) {
    const std::uint32_t q = dividend.top / divisor.top;
    size = static_cast<std::int32_t>(shift < 0 ? q >> -shift : q << shift);
  }
  return negative ? -size : size;
}

// A dot with its level, where a piece may begin or end.
struct Stop {
  LitDot dot;
  RidgeDot ridge;
  std::int32_t level = 0;

  [[nodiscard]] std::int32_t t() const { return dot.t; }
};

// A dot against the bar of a level: g = L^2 - t^2 |N|^2, which is f times something positive.
struct Probe {
  LitDot dot;
  LitSlope slope;
  std::uint32_t square = 0;
  std::int64_t g = 0, g1 = 0;  // and its slope, 0 where it is not known
  std::int64_t margin = 0;
};

// Where the boundaries of a monotone piece are to be expected. Places have 14 bits of fraction, counted from the middle; slopes
// are in 2^-20 level a dot, without their sign.
class Forecast {
 public:
  void add(std::int32_t place, std::int32_t slope) {
    bend_ = known_ ? slope - slope_ : 0;
    run_ = std::max<std::int32_t>(place - place_, 1);
    place_ = place;
    slope_ = slope;
    known_ = true;
  }
  // The next boundary to the right, a level on: the slope changes evenly, as it did between the last two.
  [[nodiscard]] std::int32_t next() const {
    std::int32_t way = dots_for(slope_ + bend_ / 2);
    if (bend_ != 0)
      way = dots_for(slope_ + static_cast<std::int32_t>(
                                  std::int64_t{bend_} * std::min<std::int32_t>(way / ((run_ >> 8) + 1), 1024) >> 9));
    return place_ + way;
  }

 private:
  [[nodiscard]] std::int32_t dots_for(std::int32_t slope) const {
    const auto least = static_cast<std::uint32_t>(std::max<std::int32_t>(std::max(slope, slope_ >> 2), 16));
    return static_cast<std::int32_t>((1U << 31) / least << 3);
  }
  std::int32_t place_ = 0, slope_ = 0, bend_ = 0, run_ = 1;
  bool known_ = false;
};

class SpanTracer {
 public:
  SpanTracer(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job), y_(y), line_(job, y, x0, x1), ridge_(line_), painter_(job.painter, x0, 0) {
    const LinePolynomial& d = line_.discriminant();
    (void)d;
    base_ =
        static_cast<std::int32_t>((std::int64_t{job.table.levels - 1} * job.lighting.ambient << 4) / job.lighting.unit);
  }

  void run(std::int32_t x0, std::int32_t x1);

 private:
  [[nodiscard]] std::uint32_t square(std::int32_t k) const { return job_.table.squares[static_cast<std::size_t>(k)]; }
  [[nodiscard]] bool reaches(const LitDot& dot, std::int32_t k) {
    const Answer answer = compare(dot.light, line_.margin(dot, square(k)), square(k));
    return answer == Answer::unsure ? settle(dot.t, k) : answer == Answer::yes;
  }
  [[nodiscard, gnu::noinline]] bool settle(std::int32_t t, std::int32_t k) {
    ++job_.counters.exact_levels;
    return job_.exact.reaches_level(job_.face, job_.lighting, job_.table.levels, k, line_.middle() + t, y_);
  }
  [[nodiscard]] Stop place_stop(std::int32_t t) const {
    Stop stop;
    stop.dot = line_.dot(t);
    stop.ridge = ridge_.at(stop.dot, line_.root_error(stop.dot));
    return stop;
  }
  // Its level sought from a level near it, or -1.
  void find_level(Stop& stop, std::int32_t near) {
    stop.level = search_level(job_.table, near, [&](std::int32_t k) { return reaches(stop.dot, k); });
  }

  Stop dot_by_dot(const Stop& from, std::int32_t to);
  Stop last_alike(Stop from, RidgeDot other, std::int32_t other_t) const;
  void ridge_between(const Stop& a, const Stop& b);
  void monotone(const Stop& a, const Stop& b);
  std::int32_t boundary(std::int32_t k, std::int32_t in, std::int32_t out, std::int32_t guess, Forecast& forecast);
  bool probe(Probe& p, std::int32_t t, std::int32_t k);
  [[nodiscard]] bool neighbour_fails(const Probe& p, std::int32_t e) const;
  [[nodiscard]] std::int32_t steepness(const Probe& p, std::int32_t k) const;

  void turn(std::int32_t t, std::int32_t level) {
    painter_.change(line_.middle() + t, level);
    ++job_.counters.level_spans;
  }

  const ShadeJob& job_;
  std::int32_t y_;
  LineSection line_;
  RidgeForm ridge_;
  RunPainter painter_;
  std::int32_t base_ = 0;  // levels that ambient light alone gives, in sixteenths
};

// Each dot after `from` up to `to` for itself.
Stop SpanTracer::dot_by_dot(const Stop& from, std::int32_t to) {
  Stop at = from;
  for (std::int32_t t = from.t() + 1; t <= to; ++t) {
    Stop next = place_stop(t);
    find_level(next, at.level);
    if (next.level != at.level) turn(t, next.level);
    at = next;
    ++job_.counters.intensities;
  }
  return at;
}

// The last dot from `from` towards another whose course is surely that of `from`, where the form has one root between them.
Stop SpanTracer::last_alike(Stop from, RidgeDot other, std::int32_t other_t) const {
  std::int64_t w_from = from.ridge.w;
  std::int64_t w_other = other.w;
  for (int tries = 0;; ++tries) {
    const std::int32_t way = other_t - from.t();
    if (way == 1 || way == -1) return from;
    // Regula falsi, an end that stays halved [Dowell, Jarratt 1971]
    const std::int64_t sum = w_from - w_other;
    std::int32_t step = way / 2;
    if (tries < 8 && sum != 0) {
      const std::int32_t part = quotient(w_from, sum);
      step = static_cast<std::int32_t>(std::int64_t{way} * part >> place_fraction);
      step = way > 0 ? std::clamp<std::int32_t>(step, 1, way - 1) : std::clamp<std::int32_t>(step, way + 1, -1);
    }
    const Stop next = place_stop(from.t() + step);
    if (next.ridge.sign() == from.ridge.sign()) {
      from = next;
      w_from = next.ridge.w;
      w_other /= 2;
    } else {
      other_t = next.t();
      w_other = next.ridge.w;
      w_from /= 2;
    }
  }
}

void SpanTracer::ridge_between(const Stop& a, const Stop& b) {
  Stop left = last_alike(a, b.ridge, b.t());
  if (left.t() != a.t()) find_level(left, -1);
  monotone(a, left);
  Stop right = place_stop(left.t() + 1);
  if (right.ridge.sign() != b.ridge.sign()) right = last_alike(b, left.ridge, left.t());
  const Stop end = dot_by_dot(left, right.t());
  monotone(end, b);
}

bool SpanTracer::probe(Probe& p, std::int32_t t, std::int32_t k) {
  if (p.dot.t != t) {
    p.dot = line_.dot(t);
    p.slope = line_.slope(p.dot);
  }
  p.square = square(k);
  const Margin margin = line_.margin(p.dot, p.square);
  const Light& light = p.dot.light;
  p.margin = margin.squares;
  p.g = light.l * light.l - scale_by(p.square, light.n2);
  p.g1 = 0;
  if (p.slope.known) {
    const std::int64_t n2 = p.slope.n2;
    const std::int64_t fall = n2 < 0 ? -scale_by(p.square, -n2) : scale_by(p.square, n2);
    p.g1 = 2 * light.l * p.slope.l - fall;
  }
  if (light.l > margin.light) {
    if (p.g > margin.squares) return true;
    if (p.g < -margin.squares) return false;
  } else if (light.l < -margin.light) {
    return false;
  }
  return settle(t, k);
}

// Whether the dot beside p's, e = -1 or 1 away, surely fails a level that p's reaches.
//   f(X) <= L(X) - t N(X).N / |N|, since |N| is convex; so with s there within eps of its tangent, and |m| <= |v|,
//     f(neighbour) <= f + e f' + 2 |v| eps.
//   Times 2 L, where 2 L f <= g (1 + g / L^2), and 2 L f' is g' but for g |(|N|^2)'| / 2 |N|^2 at most:
//     <= g + g / 16 + e g' + 4 L |v| eps,  where g <= L^2 / 32 and |(|N|^2)'| <= |N|^2 / 16.
//   s' errs by less than 2^7 where LineSection::bent allows it, so L' by 260, (|N|^2)' by 2^38 and g' by 2^10 L + 2^38 t^2.
bool SpanTracer::neighbour_fails(const Probe& p, std::int32_t e) const {
  const std::int64_t l = p.dot.light.l;
  const std::int64_t rise = (e > 0 ? -p.g1 : p.g1) - (l << 10) - (std::int64_t{p.square} << 6);
  const std::int64_t room = rise - p.g - (p.g >> 4) - p.margin;
  if (room <= 0 || p.g > l * l >> 5) return false;
  const std::int64_t n2_slope = p.slope.n2 < 0 ? -p.slope.n2 : p.slope.n2;
  return n2_slope <= p.dot.light.n2 >> 4 && !line_.bent(p.dot, room);
}

// Levels a dot: level k stands at k - base, and f is proportional to it there.
std::int32_t SpanTracer::steepness(const Probe& p, std::int32_t k) const {
  constexpr std::int64_t most = std::int64_t{1} << 56;
  const std::int64_t g1 = std::min(p.g1 < 0 ? -p.g1 : p.g1, most);
  return quotient((g1 >> 6) * (16 * k - base_), p.dot.light.l * p.dot.light.l >> 7);
}

// The last dot from `in`, which reaches level k, towards `out`, which does not, that reaches it. Asked first at `guess`.
std::int32_t SpanTracer::boundary(std::int32_t k, std::int32_t in, std::int32_t out, std::int32_t guess,
                                  Forecast& forecast) {
  const std::int32_t e = out > in ? 1 : -1;
  Probe p;
  p.dot.t = guess - 1;
  for (int tries = 0;; ++tries) {
    const bool reached = probe(p, guess, k);
    const std::int32_t place = p.g1 == 0 ? 0 : (guess << place_fraction) + quotient(-p.g, p.g1);
    (reached ? in : out) = guess;
    if (in + e == out || (reached && neighbour_fails(p, e))) {
      forecast.add(place, steepness(p, k));
      return in;
    }
    guess = e > 0 ? place >> place_fraction : -(-place >> place_fraction);
    if (tries > 3 || p.g1 == 0) guess = in + (out - in) / 2;
    guess = e > 0 ? std::clamp(guess, in + 1, out - 1) : std::clamp(guess, out + 1, in - 1);
  }
}

void SpanTracer::monotone(const Stop& a, const Stop& b) {
  if (a.level == b.level) return;
  const bool rising = a.level < b.level;
  Forecast forecast;
  Probe first;
  first.dot.t = a.t() + 1;
  const std::int32_t first_k = rising ? a.level + 1 : a.level;
  probe(first, a.t(), first_k);
  std::int32_t place = (a.t() << place_fraction) + (first.g1 == 0 ? 1 << 20 : quotient(-first.g, first.g1));
  std::int32_t known = a.t();
  for (std::int32_t k = first_k; k != (rising ? b.level + 1 : b.level); k += rising ? 1 : -1) {
    if (rising) {
      const std::int32_t guess = std::clamp(-(-place >> place_fraction), known + 1, b.t());
      const std::int32_t x = boundary(k, b.t(), known, guess, forecast);
      turn(x, k);
      known = x - 1;
    } else {
      const std::int32_t guess = std::clamp(place >> place_fraction, known, b.t() - 1);
      const std::int32_t x = boundary(k, known, b.t(), guess, forecast);
      turn(x + 1, k - 1);
      known = x;
    }
    place = forecast.next();
  }
}

void SpanTracer::run(std::int32_t x0, std::int32_t x1) {
  if (line_.grazing()) {
    painter_.change(x0, job_.table.ambient_level);
    painter_.end(x1);
    return;
  }
  Stop a = place_stop(x0 - line_.middle());
  Stop last = place_stop(x1 - line_.middle());
  find_level(a, -1);
  find_level(last, -1);
  painter_.change(x0, a.level);
  ++job_.counters.level_spans;
  std::int32_t skip = 1;
  while (a.t() < last.t()) {
    Stop b = last;
    Course course = Course::unsure;
    while (b.t() - a.t() > short_piece && (course = ridge_.course(a.ridge, b.ridge)) == Course::unsure &&
           a.ridge.sign() != 0) {
      b = place_stop(a.t() + (b.t() - a.t()) / 2);
      find_level(b, a.level);
    }
    if (course == Course::unsure) {
      skip = std::min<std::int32_t>(2 * skip, 64);
      a = dot_by_dot(a, a.ridge.sign() == 0 ? std::min(a.t() + skip, last.t()) : b.t());
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
  for (; x0 <= x1; x0 += 2 * longest_half)
    SpanTracer(job, y, x0, std::min(x1, x0 + 2 * longest_half - 1)).run(x0, std::min(x1, x0 + 2 * longest_half - 1));
  return true;
}

}  // namespace halfspace
