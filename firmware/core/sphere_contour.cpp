#include <algorithm>

#include "firmware/core/contour.hpp"
#include "firmware/core/quick_root.hpp"
#include "firmware/core/real.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr int place_bits = 15;
constexpr std::int32_t one_dot = 1 << place_bits;
constexpr std::int32_t deep = 1 << 24;         // a root that is off by little
constexpr std::int64_t least_reach = 1 << 20;  // 2^-30, of a level no more than a radius high

// --- a face's registers ---

// floor(value 2^bits) where that is known to within `error` units.
template <class T>
bool put(T& out, const BoundedReal& value, int bits, std::int64_t error = 2) {
  out = static_cast<T>(value.fixed(bits));
  return value.error_of(bits) <= error;
}

// But for so many bits of fraction.
bool all_zero(std::span<const Wide<128>> coefficients, int fraction) {
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [&](const Wide<128>& c) { return (c >> fraction).is_zero(); });
}

// The chord of line y: D = -d0 (rho^2 - (x - centre)^2), and 4 d0^2 rho^2 = e2 y^2 + e1 y + e0.
struct Outline {
  BoundedReal d0, centre, shear;   // -d0 is the D of design.md; the chord's centre is shear y + centre
  BoundedReal middle, root_kappa;  // eta = root_kappa (y - middle)
  BoundedReal radius;
};

Outline outline_of(const RootSurface& s) {
  BoundedReal d[6];
  for (int i = 0; i < 6; ++i) d[i] = BoundedReal(s.discriminant.q[static_cast<std::size_t>(i)], 0);
  const BoundedReal two_d0 = d[0] + d[0];
  const BoundedReal four_d0 = two_d0 + two_d0;
  const BoundedReal e2 = d[1] * d[1] - four_d0 * d[2];
  const BoundedReal e1 = (d[1] * d[3] - two_d0 * d[4]) * BoundedReal(2);
  const BoundedReal e0 = d[3] * d[3] - four_d0 * d[5];
  const BoundedReal middle = -e1 / (e2 + e2);
  return {-d[0],  -d[3] / two_d0,         -d[1] / two_d0,
          middle, (-e2).root() / -two_d0, (e0 + (e1 * middle).half()).root() / -two_d0};
}

// Of the root s at a dot: chord's error over s, and quick_root's.
std::int32_t root_error(std::int32_t s) {
  return s < 1 << 17 ? 1 << 18 : static_cast<std::int32_t>((1U << 31) / (static_cast<std::uint32_t>(s) >> 3)) + 6;
}

// Of a level in 2^-16, from that of the root.
std::int32_t level_error(const SphereContours& c, std::int32_t ds) {
  const auto dv = static_cast<std::uint32_t>(static_cast<std::int64_t>(c.reach) * ds >> 30);  // |b| <= reach
  return static_cast<std::int32_t>(6 + (std::uint64_t{c.level_slope} * (dv + 12) >> 32));
}

// |N|^2 = q + r sqrt(D) with what rounding may have cut off.
BoundedReal square_of(const RootSurface& s, const Outline& o) {
  const int exponent = s.square.exponent;
  const std::int64_t rounded = exponent > 0 ? 1 : 0;
  return BoundedReal(s.square.q[5], exponent, rounded << quadratic_error_bits) +
         BoundedReal(Wide<128>(), exponent, rounded << linear_error_bits) * o.d0.root() * o.radius;
}

}  // namespace

// |N| constant, but for what its own rounding hides, and D and the light exact.
bool has_constant_normal(const RootSurface& s) {
  return s.discriminant.exponent == 0 && s.light.exponent == 0 && all_zero(std::span(s.square.q).first<5>(), 0) &&
         all_zero(s.square_root.q, s.square_root_fraction()) && s.discriminant.q[0].negative();
}

bool make_sphere(const ShadeJob& job, SphereContours& out) {
  const RootSurface& s = job.face.surface;
  const Outline o = outline_of(s);
  const int radius_bits = o.radius.bits();
  if (o.radius.sign() <= 0 || radius_bits < 3 || radius_bits > 13) return false;
  const int kappa_bits = o.root_kappa.bits();
  if (o.root_kappa.sign() <= 0 || kappa_bits < -1 || kappa_bits > 2) return false;
  const int f = 30 - radius_bits;
  out.fraction = static_cast<std::uint8_t>(f);

  const Lighting& g = job.lighting;
  std::int64_t l2 = 0;
  for (const std::int32_t l : g.light) l2 += static_cast<std::int64_t>(l) * l;
  const BoundedReal scale = o.radius / (BoundedReal(l2) * square_of(s, o)).root();
  const BoundedReal l0(s.light.q[0], 0);
  const BoundedReal a = l0 * scale;
  const BoundedReal b = BoundedReal(s.light_root, 0) * o.d0.root() * scale;
  const BoundedReal c = (BoundedReal(s.light.q[1], 0) + l0 * o.shear) * scale / o.root_kappa;
  const BoundedReal reach = (a * a + b * b).root();

  out.middle = static_cast<std::int32_t>(std::clamp<std::int64_t>(o.middle.fixed(0), -(1 << 18), 1 << 18));
  const BoundedReal above = BoundedReal(out.middle) - o.middle;
  const std::int64_t most = static_cast<std::int64_t>(job.table.levels - 1) * g.parallel;
  const BoundedReal per_level = BoundedReal(most) / BoundedReal(g.unit);
  const BoundedReal radial = o.radius;
  const BoundedReal lift = c * o.root_kappa;
  std::uint64_t bar_slope = 0;
  const bool lit_along_lines =
      put(out.reach, reach, 30) && out.reach >= least_reach && least_reach * g.unit / out.reach <= most &&
      put(out.lift_slope, lift / reach, f + 32, 1 << 17) && put(out.bar_at, above * lift / reach, f + 32, 1 << 30) &&
      put(bar_slope, radial / (BoundedReal(most) * reach), f + 32, (1 << 30) / std::max<std::int64_t>(most, 1)) &&
      put(out.alpha, a / reach, 32 + place_bits - f) &&
      put(out.beta, (b.sign() < 0 ? -b : b) / reach, 32 + place_bits - f);
  const bool good = put(out.eta_slope, o.root_kappa, f + 16) && put(out.eta_at, above * o.root_kappa, f + 16) &&
                    put(out.centre_slope, o.shear, f + 16) &&
                    put(out.centre_at, o.centre + o.shear * BoundedReal(out.middle), f + 16) &&
                    put(out.level_slope, per_level / radial, 48 - f) && put(out.radius, radial, f) &&
                    put(out.a, a, 30) && put(out.b, b, 30) && put(out.c, c, 30);
  out.is_upright = s.is_exact() && s.light_root.is_zero() && s.light.q[1].is_zero() && !job.contours->block.empty();
  if (out.is_upright) std::ranges::fill(job.contours->block, 0);
  const std::int64_t ambient = static_cast<std::int64_t>(job.table.levels - 1) * g.ambient;
  out.bar_step = bar_slope * static_cast<std::uint32_t>(g.unit);
  out.bar_at += bar_slope * static_cast<std::uint64_t>(ambient);
  out.level_error = static_cast<std::int16_t>(level_error(out, root_error(deep)));
  out.level_base = (ambient << 16) / g.unit;
  out.sure = 6 + (40 >> (f - place_bits));
  out.sure_if_narrow = 6 + (520 >> (f - place_bits));
  return good && (lit_along_lines || reach.is_zero()) &&
         out.radius <= (1 << 30) - 4;  // rho^2 stays under 2^60 with eta's error, as quick_root asks
}

namespace {

// --- a span ---

class SphereSpan {
 public:
  SphereSpan(const ShadeJob& job, const SphereContours& c, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job), c_(c), y_(y), x0_(x0), x1_(x1) {
    const std::int64_t up = y - job.face.origin_y - c.middle;
    eta_ = static_cast<std::int32_t>((c.eta_slope * up + c.eta_at) >> 16);
    centre_ = (c.centre_slope * up + c.centre_at) >> 16;
    chord_ = (std::int64_t{c.radius} - eta_) * (std::int64_t{c.radius} + eta_);
    const std::int64_t base =
        (static_cast<std::int64_t>(job.face.origin_x) << place_bits) + (centre_ >> (c.fraction - place_bits));
    constexpr std::int64_t far = std::int64_t{41000} << place_bits;
    is_near_ = base > -far && base < far;
    base_ = static_cast<std::int32_t>(base);
    bar_at_ = c.lift_slope * static_cast<std::uint64_t>(up) + c.bar_at;
  }
  // A line that grazes the sphere, or a job that lies.
  [[nodiscard]] bool is_usable() const { return is_near_ && eta_ < c_.radius && eta_ > -c_.radius; }

  void paint() {
    const std::int32_t ka = level_at(x0_);
    const std::int32_t kb = level_at(x1_);
    // A dot inside level k's interval shows k + shift, one outside shows `step` less.
    const std::int32_t step = is_dark() ? -1 : 1;
    const std::int32_t shift = is_dark() ? -1 : 0;
    const std::int32_t rise = (kb - ka) * step;
    const std::int32_t inside = ka + 1 + shift;
    const std::int32_t risen = inside + std::max<std::int32_t>(rise, 0) * step;
    const std::int32_t fallen = inside + std::min<std::int32_t>(rise, 0) * step;
    Intervals found;
    found.first = edge(inside, step);
    found.beginning = job_.scratch.data();
    Sweep sweep{found.first, risen - step, step};
    found.nested = find<true, false>(sweep, found.beginning);
    sweep.last = last_level(sweep);
    found.ending = find<true, true>(sweep, found.nested);
    found.end = found.ending;
    if (fallen != inside) {
      found.first_ending = edge(inside - step, -step);
      Sweep ending{found.first_ending, fallen, -step};
      found.end = find<false, true>(ending, found.ending);
    }
    job_.painter.is_bilevel() ? paint<BilevelRuns>(found, ka, shift, step) : paint<RunPainter>(found, ka, shift, step);
    const std::ptrdiff_t changes = (found.end - found.beginning) + (found.ending - found.nested);
    job_.counters.level_spans +=
        1 + static_cast<std::uint32_t>(job_.painter.levels_of(static_cast<std::int32_t>(changes)));
  }

 private:
  using Interval = std::int32_t;  // first dot + 2^16 first dot beyond
  // Those that the last dot lies in, but not the first, begin in the span; then come those inside it, nested; those that the first dot lies
  // in, but not the last, end in it. Either the first or the last are none.
  struct Intervals {
    Interval *beginning, *nested, *ending, *end;
    std::int32_t first, first_ending = 0;  // the levels of the first that begins and of the first that ends
  };
  struct Crossing {
    std::int32_t centre, half, error;  // places; error < 0: the line misses the interval
  };

  // Boundaries that show, between levels k - 1 and k, from k on as far as `last`.
  struct Sweep {
    std::int32_t k, last, step;

    [[nodiscard]] bool done() const { return (last - k) * step < 0; }
  };
  // The first at k or beyond it.
  [[nodiscard]] std::int32_t edge(std::int32_t k, std::int32_t step) const {
    return step > 0 ? job_.painter.edges().from(k) : job_.painter.edges().to(k);
  }

  template <class Run>
  void paint(const Intervals& found, std::int32_t level, std::int32_t shift, std::int32_t step) {
    Run run(job_.painter, x0_, level);
    std::int32_t k = found.first;
    for (const Interval* at = found.beginning; at != found.ending; ++at, k = edge(k + step, step)) {
      run.change(*at & 0x7fff, k + shift);
    }
    for (const Interval* at = found.ending; at != found.nested;) {
      k = edge(k - step, -step);
      run.change(*--at >> 16, k + shift - step);
    }
    k = found.first_ending;
    for (const Interval* at = found.ending; at != found.end; ++at, k = edge(k - step, -step)) {
      run.change(*at >> 16, k + shift - step);
    }
    run.end(x1_);
  }

  // The light comes from behind: a level's interval is where it is not reached, and intervals nest downwards.
  [[nodiscard]] bool is_dark() const { return c_.b < 0; }

  // C of level k.
  [[nodiscard]] std::int32_t bar_of(std::int32_t k) const {
    return static_cast<std::int32_t>((c_.bar_step * static_cast<std::uint32_t>(k) - bar_at_) >> 32);
  }
  [[nodiscard]] Crossing crossing(std::int32_t k) const {
    const std::int32_t bar = bar_of(k);
    const std::int64_t w2 = chord_ - static_cast<std::int64_t>(bar) * bar;
    if (w2 < -slack) return {0, 0, -1};
    const std::int32_t w = w2 <= 0 ? 0 : quick_root(static_cast<std::uint64_t>(w2));
    return {base_ + upper(c_.alpha, bar), upper(c_.beta, w), w2 >= wide ? c_.sure : error_of(w)};
  }
  [[nodiscard]] std::int32_t error_of(std::int32_t w) const {
    const std::int32_t dw =
        w < 1 << 18 ? 1 << 19 : static_cast<std::int32_t>((1U << 31) / (static_cast<std::uint32_t>(w) >> 3)) + 6;
    return 6 + ((4 + dw) >> (c_.fraction - place_bits));
  }
  static std::int32_t upper(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(a) * b >> 32);
  }

  // The intervals of a sweep's levels that begin, end, or both, in the span; those that must do both as long as they do.
  template <bool begins, bool ends>
  [[nodiscard]] Interval* find(Sweep& sweep, Interval* out) const {
    while (!sweep.done()) {
      out = find_plain<begins, ends>(sweep, out);
      if (sweep.done()) break;
      const Crossing at = crossing(sweep.k);
      if (at.error < 0 && begins && ends) return out;
      std::int32_t left = begins ? left_of(at, sweep.k) : x0_;
      std::int32_t right = ends ? right_of(at, left, sweep.k) : x1_;
      if (begins && ends && (left <= x0_ || right <= left || right > x1_)) return out;
      *out++ = std::min(right, x1_) << 16 | std::clamp(left, x0_, x1_);
      sweep.k = edge(sweep.k + sweep.step, sweep.step);
    }
    return out;
  }

  // The same as far as ends are certain: the loops that most of a sphere's time goes to, without a call.
  template <bool begins, bool ends>
  [[nodiscard, gnu::noinline]] Interval* find_plain(Sweep& sweep, Interval* out) const {
    out = find_wider<begins, ends>(wide, c_.sure, quick_large_root, sweep, out);
    return find_wider<begins, ends>(narrow, c_.sure_if_narrow, quick_root, sweep, out);
  }
  // The same as far as w^2 is at least `least`, and so an end within `error`.
  template <bool begins, bool ends>
  [[gnu::always_inline]] Interval* find_wider(std::int64_t least, std::int32_t error, const auto& root, Sweep& sweep,
                                              Interval* out) const {
    const std::int32_t unsure = 2 * error;
    const std::int32_t base = base_ + error + one_dot - 1;
    const std::int32_t alpha = c_.alpha, beta = c_.beta, x0 = x0_, x1 = x1_;
    const std::int64_t chord = chord_;
    for (; !sweep.done(); sweep.k = edge(sweep.k + sweep.step, sweep.step)) {
      const std::int32_t c = bar_of(sweep.k);
      const std::int64_t w2 = chord - static_cast<std::int64_t>(c) * c;
      if (w2 < least) break;
      const std::int32_t half = upper(beta, root(static_cast<std::uint64_t>(w2)));
      const std::int32_t centre = base + upper(alpha, c);
      const std::int32_t left = centre - half;
      const std::int32_t right = centre + half + 1;
      if (begins && (left & (one_dot - 1)) < unsure) break;
      if (ends && (right & (one_dot - 1)) < unsure) break;
      const std::int32_t first = begins ? left >> place_bits : x0;
      const std::int32_t behind = ends ? right >> place_bits : x1;
      if (begins ? first <= x0 || behind < first || (ends && behind == first) : behind <= x0) break;
      if (behind > x1) break;
      *out++ = behind << 16 | first;
    }
    return out;
  }

  // The first dot inside.
  [[nodiscard]] std::int32_t left_of(const Crossing& at, std::int32_t k) const {
    const std::int32_t t = at.centre - at.half + at.error + one_dot - 1;
    if ((t & (one_dot - 1)) >= 2 * at.error) return t >> place_bits;
    return first(true, (t - 2 * at.error) >> place_bits, t >> place_bits, k);
  }
  // The first dot beyond, from `left`, the first inside, on: of an interval as narrow as its own error the dots before it are
  // no more inside than those after it.
  [[nodiscard]] std::int32_t right_of(const Crossing& at, std::int32_t left, std::int32_t k) const {
    const std::int32_t t = at.centre + at.half + at.error + one_dot;
    if ((t & (one_dot - 1)) >= 2 * at.error) return t >> place_bits;
    return first(false, std::max(left, (t - 2 * at.error) >> place_bits), t >> place_bits, k);
  }
  // The first dot of from .. to that is, or is not, inside level k's interval; `to` at the latest.
  [[nodiscard, gnu::noinline]] std::int32_t first(bool inside, std::int32_t from, std::int32_t to,
                                                  std::int32_t k) const {
    for (from = std::max(from, x0_); from < to && from <= x1_; ++from) {
      if ((reaches(from, k) != is_dark()) == inside) return from;
    }
    return to;
  }
  [[nodiscard]] bool reaches(std::int32_t x, std::int32_t k) const {
    if (!c_.is_upright) return reaches_level(job_, x, y_, k);
    std::uint32_t& known = job_.contours->block[static_cast<std::size_t>(k)];
    const auto column = static_cast<std::uint32_t>(x + 1);
    if (known >> 1 != column) known = column << 1 | (reaches_level(job_, x, y_, k) ? 1U : 0U);
    return (known & 1) != 0;
  }

  [[nodiscard, gnu::noinline]] std::int32_t level_at(std::int32_t x) const {
    const auto xi =
        static_cast<std::int32_t>((static_cast<std::int64_t>(x - job_.face.origin_x) << c_.fraction) - centre_);
    const Level at = level_of(c_.a, xi, c_.b, chord_ - static_cast<std::int64_t>(xi) * xi);
    const std::int32_t low = clamped((at.level - at.error) >> 16);
    const std::int32_t high = clamped((at.level + at.error) >> 16);
    return low == high ? low : level_between(job_, x, y_, low, high);
  }
  // The last boundary that the line may have: its brightest point, or the darkest one, shows it, be it seen or
  // not. With the light across the line its dots are all alike.
  [[nodiscard]] std::int32_t last_level(const Sweep& sweep) const {
    if (c_.reach == 0) return sweep.k - sweep.step;
    const Level at = level_of(0, 0, is_dark() ? -c_.reach : c_.reach, chord_);
    return is_dark() ? clamped((at.level - at.error) >> 16) + 1 : clamped((at.level + at.error) >> 16);
  }
  struct Level {
    std::int64_t level;  // 2^-16
    std::int32_t error;
  };
  // By a xi + b s + c eta.
  [[nodiscard, gnu::always_inline]] Level level_of(std::int32_t a, std::int32_t xi, std::int32_t b,
                                                   std::int64_t s2) const {
    const std::int32_t s = quick_root(static_cast<std::uint64_t>(std::max<std::int64_t>(s2, 1)));
    const auto v = static_cast<std::int32_t>((static_cast<std::int64_t>(a) * xi + static_cast<std::int64_t>(b) * s +
                                              static_cast<std::int64_t>(c_.c) * eta_) >>
                                             30);
    return {c_.level_base + (static_cast<std::int64_t>(c_.level_slope) * v >> 32),
            s >= deep ? c_.level_error : level_error(c_, root_error(s))};
  }
  [[nodiscard]] std::int32_t clamped(std::int64_t level) const {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(level, job_.table.ambient_level, job_.table.top_level));
  }

  static constexpr std::int64_t slack = std::int64_t{1} << 34;   // error of w^2
  static constexpr std::int64_t wide = std::int64_t{1} << 56;    // w^2 of a quarter of the radius or more
  static constexpr std::int64_t narrow = std::int64_t{1} << 48;  // ... of a 64th

  const ShadeJob& job_;
  const SphereContours& c_;
  std::int32_t y_, x0_, x1_;
  std::int32_t eta_, base_;
  std::int64_t centre_, chord_;
  std::uint64_t bar_at_;  // C of level k is k bar_step - at, with 32 bits of fraction
  bool is_near_;
};

}  // namespace

bool sphere_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  SphereSpan span(job, job.contours->sphere, y, x0, x1);
  if (!span.is_usable()) return false;
  span.paint();
  return true;
}

}  // namespace halfspace
