#include "firmware/core/track_fit.hpp"

#include <algorithm>
#include <bit>

#include "firmware/core/line_section.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t smallest_root = 1 << 25;  // of S and |N| at the middle, whose largest are near 2^29
constexpr std::int32_t largest_error = 1 << 15;  // of a path, 2^-16 dot
constexpr std::int32_t worth_another = 1 << 12;  // from the guess: what it is off by makes part of the error

std::int32_t size(std::int32_t v) { return v < 0 ? -v : v; }
// a b 2^-30, to within 4.
std::int32_t product30(std::int32_t a, std::int32_t b) { return high_product(a, b) << 2; }

// A form along the guess: w0 + w1 w + .. + w4 w^4 + xi (x0 + x1 w + x2 w^2), to within error + |xi| beside + xi^2 bulge.
struct FormAlong {
  std::int32_t w0, w1, w2, w3, w4;
  std::int32_t x0, x1, x2;
  std::int32_t error, beside, bulge;
};

// w0 + w1 w + w2 w^2 + w3 w^3 + xi (x0 + x1 w), to within the same.
struct RootAlong {
  std::int32_t w0, w1, w2, w3, x0, x1;
  std::int32_t error, beside, bulge;
};

// The guess in parts of tau, 31 bits of fraction.
struct Curve {
  std::int32_t x, slope, bend;
  int dot_bits;  // a dot is 2^(31 - dot_bits)

  [[nodiscard]] std::int32_t per_dot(std::int32_t v) const { return v >> dot_bits; }
};

// Products with parts of tau are off by less than 2 and their multiples; all of it by less than 64 units for |w|, |xi| <= 1.
[[gnu::always_inline]] inline FormAlong along(const StripQuadratic& p, const Curve& x) {
  FormAlong f;
  const std::int32_t half_slope = (p.v1 >> 1) + (high_product(p.v2, x.x) << 2);  // of dP / d tau
  const std::int32_t turned = high_product(p.v2, x.slope) << 2;
  const std::int32_t cross = p.xy + turned;
  const std::int32_t cross_slope = cross + turned;
  f.w0 = p.v0 + (high_product(p.v1 + (high_product(p.v2, x.x) << 2), x.x) << 1);
  f.w1 = p.y + (high_product(p.xy, x.x) << 1) + (high_product(half_slope, x.slope) << 2);
  f.w2 = p.yy + (high_product(half_slope, x.bend) << 2) + (high_product(cross, x.slope) << 1);
  f.w3 = high_product(cross_slope, x.bend) << 1;
  const std::int32_t bend_slope = high_product(p.v2, x.bend) << 3;
  f.w4 = high_product(bend_slope, x.bend);
  f.x0 = x.per_dot(half_slope) << 1;
  f.x1 = x.per_dot(cross_slope);
  f.x2 = x.per_dot(bend_slope);
  f.error = 64;
  f.beside = 0;
  f.bulge = size(p.v2 >> (2 * x.dot_bits - 1)) + 1;
  return f;
}

// sqrt(2^30 f), where it changes by less than half of itself; S + s is then more than S in the middle. Of the 1024, 700 are for its
// coefficients: each is off by 32 and 2^-21 of itself.
bool root_along(const FormAlong& f, RootAlong& root) {
  if (f.w0 <= 0 || f.w0 >= 1 << 29) return false;
  const std::int32_t w0 = short_root(std::max<std::int32_t>(f.w0 << 2, 1));
  if (w0 <= smallest_root) return false;
  // 2^56 / w0: to 2^-14 of itself, and by Newton's step to 2^-22.
  const int zeros = std::countl_zero(static_cast<std::uint32_t>(w0));
  auto inverse = static_cast<std::int32_t>(~0U / (static_cast<std::uint32_t>(w0) << zeros >> 16) << (8 + zeros));
  inverse += high_product(inverse, ((1 << 24) - high_product(w0, inverse)) << 8);
  const auto part = [&](std::int32_t v) { return high_product(v, inverse); };  // 2^-5 v 2^29 / w0
  const std::uint32_t most = 7 * (static_cast<std::uint32_t>(w0) >> 9);  // what makes coefficients 7/16 of the root
  std::uint32_t change = 0;  // of the root by them; a part is below 2^30, so that two more are no overflow
  const auto next = [&](std::int32_t v) {
    const std::int32_t p = part(v);
    change += static_cast<std::uint32_t>(size(p));
    return p << 5;
  };
  const std::int32_t w1 = next(f.w1);
  const std::int32_t x0 = next(f.x0);
  if (change > most) return false;
  const std::int32_t w2 = next(f.w2 - product30(w1, w1));
  const std::int32_t x1 = next(f.x1 - (product30(w1, x0) << 1));
  if (change > most) return false;
  const std::int32_t w3 = next(f.w3 - (product30(w1, w2) << 1));
  if (change > most) return false;
  const std::int32_t across = size(x0) + size(x1);
  const std::int32_t high = size(w3);
  const std::int32_t left = size(f.w4 - product30(w2, w2) - (product30(w1, w3) << 1)) +
                            (product30(size(w2) + high, high) << 1) + f.error + 64;
  const std::int32_t beside = size(f.x2 - ((product30(w1, x1) + product30(w2, x0)) << 1)) +
                              ((product30(size(w2), size(x1)) + product30(high, across)) << 1) + f.beside + 32;
  const std::int32_t bulge = product30(across, across) + f.bulge + 8;
  const std::int32_t part_left = part(left);
  const std::int32_t part_beside = part(beside);
  const std::int32_t part_bulge = part(bulge);
  if (part_left + part_beside + part_bulge > w0 >> 11) return false;
  // So |S^2 - D| is below w0^2 / 32: S is at least 9/16 of w0 and s 1/2; where the parts beside w0 add up to less than an eighth, their
  // sum is at least 12/7 of it.
  const bool is_even = change < static_cast<std::uint32_t>(w0) >> 8;
  root = {
      w0, w1, w2, w3, x0, x1, part_left * (is_even ? 38 : 64) + 1024, (part_beside << 6) + 64, (part_bulge << 6) + 64};
  return true;
}

// q + r S.
FormAlong normal_along(const StripQuadratic& q, const StripLinear& r, const Curve& x, const RootAlong& s) {
  FormAlong f = along(q, x);
  const std::int32_t r0 = r.v0 + (high_product(r.v1, x.x) << 1);
  const std::int32_t r1 = r.y + (high_product(r.v1, x.slope) << 1);
  const std::int32_t r2 = high_product(r.v1, x.bend) << 1;
  const std::int32_t rx = x.per_dot(r.v1);
  f.w0 += product30(r0, s.w0);
  f.w1 += product30(r0, s.w1) + product30(r1, s.w0);
  f.w2 += product30(r0, s.w2) + product30(r1, s.w1) + product30(r2, s.w0);
  f.w3 += product30(r0, s.w3) + product30(r1, s.w2) + product30(r2, s.w1);
  f.w4 += product30(r1, s.w3) + product30(r2, s.w2);
  f.x0 += product30(r0, s.x0) + product30(rx, s.w0);
  f.x1 += product30(r0, s.x1) + product30(r1, s.x0) + product30(rx, s.w1);
  f.x2 += product30(r1, s.x1) + product30(r2, s.x0) + product30(rx, s.w2);
  const std::int32_t slope = size(r0) + size(r1) + size(r2) + 2 * size(rx);
  f.error += product30(slope, s.error) + size(product30(r2, s.w3)) + 128;
  f.beside += product30(slope, s.beside) + size(product30(r2, s.x1)) + 16;
  f.bulge += product30(slope, s.bulge) + size(product30(rx, s.x0)) + size(product30(rx, s.x1)) + 16;
  return f;
}

}  // namespace

FittedTrack fit_track(const SectionForms& forms, const TrackStrip& strip, std::uint32_t bar, std::int32_t bar_error,
                      int sign, const TrackCurve& guess) {
  constexpr FittedTrack none{{}, 0, FittedTrack::State::failed};
  const int shift = 15 - forms.half_bits;
  const std::int32_t most = forms.half << 15;  // half of it, 16 bits of fraction
  if (size(guess.x) >= 2 * most || size(guess.slope) > most || size(guess.bend) > most) return none;
  const Curve x{guess.x << shift, guess.slope << shift, guess.bend << shift, forms.half_bits};
  RootAlong s;
  RootAlong n;
  if (!root_along(along(strip.d, x), s) || !root_along(normal_along(strip.q, strip.r, x, s), n)) return none;

  // A quarter of F, with its sign such that it rises.
  const std::int32_t m = forms.m;
  const auto light = [&](std::int32_t l, std::int32_t of_s, std::int32_t of_n) {
    const std::int32_t f = l + high_product(m, of_s) - (high_product(static_cast<std::int32_t>(bar), of_n) >> 1);
    return sign > 0 ? f : -f;
  };
  const std::int32_t f0 = light(strip.l.v0 + (high_product(strip.l.v1, x.x) << 1), s.w0, n.w0);
  // w^3 is 3/4 w to within 1/4: no line through 0 is nearer [Chebyshev].
  const std::int32_t f3 = light(0, s.w3, n.w3);
  const std::int32_t f1 = light(strip.l.y + (high_product(strip.l.v1, x.slope) << 1), s.w1, n.w1) + 3 * (f3 >> 2);
  const std::int32_t f2 = light(high_product(strip.l.v1, x.bend) << 1, s.w2, n.w2);
  const std::int32_t g0 = light(x.per_dot(strip.l.v1), s.x0, n.x0);
  const std::int32_t g1 = light(0, s.x1, n.x1);
  if (g0 <= 1 << 10) return none;
  // Quotients by g0 with 16 bits of fraction, of numbers up to twice the largest.
  const std::int32_t largest = std::max({size(f0), size(f1), size(f2), g0});
  const int up = std::clamp(std::countl_zero(static_cast<std::uint32_t>(largest)) - 3, 0, 16);
  const std::int32_t divisor = g0 >> (16 - up);
  if (divisor < 64) return none;
  const auto moved = [&](std::int32_t f) { return -(f << up) / divisor; };
  const auto times = [](std::int32_t f, std::int32_t dots) {
    return static_cast<std::int32_t>(std::int64_t{f} * dots >> 16);
  };
  const std::int32_t x0 = moved(f0);
  const std::int32_t rest1 = f1 + times(g1, x0);
  if (size(rest1) / 2 > largest) return none;
  const std::int32_t x1 = moved(rest1);
  const std::int32_t rest2 = f2 + times(g1, x1);
  if (size(rest2) / 2 > largest) return none;
  const std::int32_t x2 = moved(rest2);
  FittedTrack fitted{{guess.x + x0, guess.slope + x1, guess.bend + x2}, 0, FittedTrack::State::guess};
  const std::int32_t way = size(x0) + size(x1) + size(x2);
  if (way > (1 << 16) - largest_error) return fitted;
  const std::int32_t off =
      size(f0 + times(g0, x0)) + size(rest1 + times(g0, x1)) + size(rest2 + times(g0, x2)) + size(times(g1, x2));
  // |xi| is at most the way and the error itself, which is at most half a dot.
  const auto of_both = [&](std::int32_t of_s, std::int32_t of_n) {
    return static_cast<std::int32_t>((std::int64_t{forms.m_size} * of_s + of_n) >> 2) + 1;
  };
  const std::int32_t beside = of_both(s.beside, n.beside);
  const std::int32_t bulge = of_both(s.bulge, n.bulge);
  const std::int32_t unsure = of_both(s.error, n.error) + (bar_error >> 2) + off + (size(f3) >> 2) + 68 +
                              times(beside + times(bulge, way), way);
  const std::int32_t least = g0 - size(g1) - beside - times(bulge, 2 * way + largest_error);
  if (least <= 1 << 9 || unsure > least >> 1) return way > worth_another ? fitted : none;
  const int down = std::max(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(unsure))) - 15, 0);
  fitted.error = static_cast<std::int32_t>(((static_cast<std::uint32_t>(unsure >> down) + 1) << 16) /
                                           static_cast<std::uint32_t>(least >> down)) +
                 1;
  fitted.state = FittedTrack::State::sure;
  return fitted;
}

}  // namespace halfspace
