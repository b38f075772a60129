// On a scan line  L = l(x) + m s(x),  |N|^2 = q(x) + r(x) s(x),  s = sqrt(D(x)):  l and r linear, q and D quadratic.
// Registers  D scaled under 2^60, so s < 2^30; q and r s under 2^60; l and m s under 2^31.
// Errors     D's registers round by at most n^2/2 + n + 2 over n dots: s by its root, n + 3 units in all, but by less than
//            3 units where s >= n^2 + 2n; and s itself is found to within root_tolerance. The others follow linearly (`margin`).
// Cost       Per dot 6 additions, 5 products for L and |N|^2, one division for s, as a rule two comparisons.

#include <algorithm>

#include "firmware/core/isqrt.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/reaches_level.hpp"
#include "firmware/core/root_surface.hpp"
#include "firmware/core/root_walk.hpp"
#include "firmware/core/stride.hpp"

namespace halfspace {
namespace {

constexpr int square_bits = 60;  // D, q and r s
constexpr int light_fraction = 28;
constexpr int root_fraction = 32;
constexpr std::int32_t longest_walk =
    512;  // dots from fresh registers: errors grow with the length, a load costs a few dots

struct Registers {
  std::int64_t d, d1, d2;  // D
  std::int64_t q, q1, q2;  // q
  std::int64_t r, r1;      // r, 32 bits of fraction
  std::int64_t l, l1;      // l, 28 bits of fraction
  std::int64_t m;          // 30 bits of fraction

  void step() {
    add(d, d1);
    add(d1, d2);
    add(q, q1);
    add(q1, q2);
    add(r, r1);
    add(l, l1);
  }
  void skip(std::int32_t t) {
    skip(d, d1, d2, t);
    skip(q, q1, q2, t);
    skip(r, r1, 0, t);
    skip(l, l1, 0, t);
  }
  [[nodiscard]] Light at(std::int64_t s) const {
    // The error of s can take a small |N|^2 below 0; the true one is not.
    const std::int64_t n2 = q + (r >> root_fraction) * s;
    return {(l >> light_fraction) + (m * s >> 30), std::max<std::int64_t>(n2, 0)};
  }

 private:
  // Modulo 2^64: on a short span a second difference, not used, may not fit.
  static void add(std::int64_t& a, std::int64_t b) {
    a = static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
  }
  static void skip(std::int64_t& value, std::int64_t& first, std::int64_t second, std::int32_t t) {
    auto v = static_cast<std::uint64_t>(value);
    auto f = static_cast<std::uint64_t>(first);
    jump(v, f, static_cast<std::uint64_t>(second), t);
    value = static_cast<std::int64_t>(v);
    first = static_cast<std::int64_t>(f);
  }
};

// The second-order registers of a polynomial at (x, y): value, first and second difference along the line.
struct LineQuadratic {
  Wide<128> v, d1, d2;

  LineQuadratic(const ScaledQuadratic& p, std::int32_t x, std::int32_t y)
      : v(p.at(x, y)), d1(p.at(x + 1, y) - v), d2(p.q[0] + p.q[0]) {}

  // Bits that hold the values on n dots: a quadratic exceeds the largest of three equally spaced values by at most a
  // quarter.
  [[nodiscard]] int bits(std::int32_t n) const {
    return 1 + std::max({v.bit_length(), at(n / 2).bit_length(), at(n).bit_length()});
  }

 private:
  [[nodiscard]] Wide<128> at(std::int32_t t) const {
    const Wide<128> pairs = t % 2 == 0 ? d2.times(t / 2).times(t - 1) : d2.times(t).times((t - 1) / 2);
    return v + d1.times(t) + pairs;
  }
};

class SpanShader {
 public:
  SpanShader(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job), y_(y), x0_(x0), x1_(x1), n_(x1 - x0 + 1) {
    load(job.face.surface, x0 - job.face.origin_x, y - job.face.origin_y);
    deep_from_ = static_cast<std::int64_t>(n_) * n_ + 2 * n_;
    deep_ = margin(root_tolerance + 3);
    shallow_ = margin(n_ + root_tolerance + 3);
  }

  void run(Shader shader) {
    if (grazing_) {
      job_.painter.fill(x0_, x1_, job_.table.ambient_level);
      ++job_.counters.level_spans;
    } else if (shader == Shader::jordan) {
      const Margin coarse = margin((std::int64_t{1} << depth_shift_) / 2 + n_ + 3);
      sweep(JordanWalk(at_.d, depth_shift_), [&coarse](std::int64_t) -> const Margin& { return coarse; });
    } else {
      sweep(RootWalk(), [this](std::int64_t s) -> const Margin& { return fine(s); });
    }
  }

  // The levels at the first dot, every `stride` dots from there, and at the last.
  void sample(std::int32_t stride, SampledLevels& samples) {
    Registers at = at_;
    RootWalk walk;
    std::int32_t x = x0_;
    for (;;) {
      const Light light = at.at(walk.next(at.d));
      const Margin& sure = fine(walk.root());
      const auto asks = [&](std::int32_t candidate) { return reaches(at, light, sure, x, candidate); };
      samples.add(x, grazing_ ? job_.table.ambient_level : search_level(job_.table, samples.level(), asks));
      if (x == x1_) return;
      const std::int32_t t = std::min(stride, x1_ - x);
      at.skip(t);
      x += t;
    }
  }

 private:
  // Scales follow from the largest values that the span reaches. Where coefficients were rounded (exponent > 0) a scale keeps
  // their error under one unit.
  void load(const RootSurface& f, std::int32_t x, std::int32_t y) {
    const LineQuadratic d(f.discriminant, x, y);
    const int root_shift =
        std::max((d.bits(n_) - square_bits + 1) >> 1, f.discriminant.exponent > 0 ? quadratic_error_bits / 2 : -32);
    const LineQuadratic q(f.square, x, y);
    const Wide<128> r = f.square_root.at(x, y);
    const Wide<128> r_end = f.square_root.at(x + n_, y);
    const int r_shift = root_shift - f.square_root_fraction();  // of r s from a unit of |N|^2
    const int r_bits = std::max(r.bit_length(), r_end.bit_length()) + r_shift + square_bits / 2;
    int square_shift = std::max(q.bits(n_), r_bits) + 1 - square_bits;
    if (f.square.exponent > 0) square_shift = std::max(square_shift, quadratic_error_bits);
    // L / (|N| 2^light_bits) must come out as in LevelTable: twice light's scale is square's.
    const int balance = f.square.exponent - 2 * f.light.exponent + 2 * job_.table.light_bits;
    if (f.light.exponent > 0) square_shift = std::max(square_shift, 2 * linear_error_bits - balance);
    // The factors of s, too, may have been rounded: by 1 and by 2^linear_error_bits, times s 2^root_shift.
    const int half_exponent = f.discriminant.exponent / 2;
    if (f.light.exponent > half_exponent) square_shift = std::max(square_shift, 2 * (root_shift + 30) - balance);
    if (f.square_root.exponent > half_exponent) {
      square_shift = std::max(square_shift, r_shift + 30 + linear_error_bits - 31);
    }
    // |L| <= |light| |N| keeps l and m s under 2^31 as a rule; where N is nearly 0, or the line's end lies outside, this does.
    const Wide<128> l = f.light.at(x, y);
    const Wide<128> l_end = f.light.at(x + n_, y);
    const int light_terms =
        std::max({l.bit_length(), l_end.bit_length(), f.light_root.bit_length() + root_shift + square_bits / 2});
    square_shift = std::max(square_shift, 2 * (light_terms - 31) - balance);
    square_shift += (square_shift + balance) & 1;
    const int light_shift = (square_shift + balance) / 2;

    at_ = {scaled(d.v, 2 * root_shift),
           scaled(d.d1, 2 * root_shift),
           scaled(d.d2, 2 * root_shift),
           scaled(q.v, square_shift),
           scaled(q.d1, square_shift),
           scaled(q.d2, square_shift),
           scaled(r, square_shift - r_shift - root_fraction),
           scaled(f.square_root.q[0], square_shift - r_shift - root_fraction),
           scaled(l, light_shift - light_fraction),
           scaled(f.light.q[0], light_shift - light_fraction),
           scaled(f.light_root, light_shift - root_shift - 30)};
    grazing_ = f.light_root.is_zero() && f.light.q == std::array<Wide<128>, 3>{};
    depth_shift_ = std::clamp(job_.face.c[2].bit_length() - root_shift - half_exponent - 2, 8, 24);
  }

  // What comparisons must exceed when s is off by `root_error`.
  [[nodiscard]] Margin margin(std::int64_t root_error) const {
    const std::int64_t n = n_;
    const std::int64_t m = at_.m < 0 ? -at_.m : at_.m;
    const std::int64_t light = (m * root_error >> 30) + 6;
    const std::int64_t square = (root_error << 30) + (std::int64_t{1} << 32) + n * n + 2 * n + 4;
    return Margin::of(light, square);
  }
  [[nodiscard]] const Margin& fine(std::int64_t s) const { return s >= deep_from_ ? deep_ : shallow_; }

  // Dot after dot, the registers in a copy that stays in the processor's; settle() finds them in at_.
  template <class Walk, class MarginAt>
  void sweep(Walk walk, MarginAt margin_at) {
    Registers at = at_;
    LevelWindow window;
    std::int32_t level = -1;
    std::int32_t from = x0_;
    std::uint32_t runs = 1;
    std::int32_t steps = 0;
    for (std::int32_t x = x0_; x <= x1_; ++x, at.step()) {
      const Light light = at.at(walk.next(at.d));
      const Margin& sure = margin_at(walk.root());
      if (level >= 0 && window.holds(light, sure)) continue;
      const std::int32_t k = search_level(
          job_.table, level, [&](std::int32_t candidate) { return reaches(at, light, sure, x, candidate); });
      if (k == level) continue;
      if (level >= 0) {
        job_.painter.fill(from, x - 1, level);
        ++runs;
        steps += k > level ? k - level : level - k;
      }
      from = x;
      level = k;
      window = LevelWindow::of(job_.table, level);
    }
    job_.painter.fill(from, x1_, level);
    job_.counters.level_spans += runs;
    job_.counters.level_steps += static_cast<std::uint32_t>(steps);
    job_.counters.intensities += static_cast<std::uint32_t>(n_);
  }

  // Inline, or the registers would not stay in the processor's.
  [[nodiscard, gnu::always_inline]] bool reaches(const Registers& at, const Light& light, const Margin& sure,
                                                 std::int32_t x, std::int32_t k) {
    const Answer answer = compare(light, sure, job_.table.squares[static_cast<std::size_t>(k)]);
    if (answer != Answer::unsure) return answer == Answer::yes;
    at_ = at;
    return settle(x, k);
  }

  // The integer square root first: Jordan's walk asks here often.
  [[nodiscard, gnu::noinline]] bool settle(std::int32_t x, std::int32_t k) {
    const std::int64_t s = isqrt(static_cast<std::uint64_t>(std::max<std::int64_t>(at_.d, 0)));
    const Answer answer = compare(at_.at(s), fine(s), job_.table.squares[static_cast<std::size_t>(k)]);
    if (answer != Answer::unsure) return answer == Answer::yes;
    return reaches_level(job_, x, y_, k);
  }

  const ShadeJob& job_;
  std::int32_t y_, x0_, x1_, n_;
  Registers at_{};
  bool grazing_ = false;  // L = 0 on the whole face: a cylinder lit along its axis
  int depth_shift_ = 0;   // log2 of the units of s in a quarter dot of z, about: Jordan's step
  std::int64_t deep_from_ = 0;
  Margin deep_, shallow_;
};

// In walks that begin and end on dots of the stride: a jump of registers errs as its steps would.
void sample_span(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const std::int32_t stride = stride_in(x0, x1, job.stride);
  const std::int32_t walk = (longest_walk - 1) / stride * stride;
  SampledLevels samples(job, x0);
  std::int32_t last = x0 - stride;
  while (last < x1) {
    const std::int32_t first = std::min(x1, last + stride);
    last = std::min(x1, first + walk);
    SpanShader(job, y, first, last).sample(stride, samples);
  }
  samples.finish();
}

}  // namespace

void shade_root_span(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (shader == Shader::stride) return sample_span(job, y, x0, x1);
  for (; x0 <= x1; x0 += longest_walk) SpanShader(job, y, x0, std::min(x1, x0 + longest_walk - 1)).run(shader);
}

const FaceModule root_faces{&make_root_surface, &shade_root_span};

}  // namespace halfspace
