#include "firmware/core/cross_arc.hpp"

#include <algorithm>
#include <bit>

#include "firmware/core/quick_root.hpp"

namespace halfspace {
namespace {

constexpr int form_bits = 60;
constexpr int weight_bits = 30;
constexpr int most_weight_bits = 10;  // with 24 of a place, and a quarter of one, 62

// floor(a t 2^-32)
std::int64_t product(std::int64_t a, std::uint32_t t) {
  if constexpr (limb_bits == 64) return static_cast<std::int64_t>(static_cast<SignedDoubleLimb>(a) * t >> 32);
  return (a >> 32) * t + static_cast<std::int64_t>((static_cast<std::uint64_t>(a) & 0xffffffffU) * t >> 32);
}
// a b 2^-60 for 0 <= a, b <= 2^60.
std::int64_t product(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::int64_t>(high_product(a << 2, b << 2));
}
std::uint64_t magnitude(std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); }

template <std::size_t N>
std::int64_t value_of(const std::array<std::int64_t, N>& c, std::uint32_t tau) {
  std::int64_t value = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) value = product(value, tau) + c[i];
  return value;
}
template <std::size_t N>
void value_and_slope(const std::array<std::int64_t, N>& c, std::uint32_t tau, std::int64_t& value,
                     std::int64_t& slope) {
  value = c[N - 1];
  slope = 0;
  for (std::size_t i = N - 1; i-- > 0;) {
    slope = product(slope, tau) + value;
    value = product(value, tau) + c[i];
  }
}

BoundedReal dot(const RealVector& a, const RealVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Powers of tau from the coefficients of sigma^i tau^j, binomials taken in.
std::array<BoundedReal, 3> powers(const BoundedReal& a, const BoundedReal& b, const BoundedReal& c) {
  return {a, b - (a + a), a - b + c};
}
std::array<BoundedReal, 5> powers(const BoundedReal& a, const BoundedReal& b, const BoundedReal& c,
                                  const BoundedReal& d, const BoundedReal& e) {
  const BoundedReal three(3);
  const BoundedReal four(4);
  return {a, b - four * a, BoundedReal(6) * a - three * b + c, three * b - four * a - (c + c) + d, a - b + c - d + e};
}

// The least b such that all are below 2^b.
template <std::size_t N>
int bits_of(const std::array<BoundedReal, N>& values) {
  int bits = -1000;
  for (const BoundedReal& v : values) bits = std::max(bits, v.bits());
  return bits;
}

// Returns the sum of the errors.
template <std::size_t N>
std::int64_t put(std::array<std::int64_t, N>& out, const std::array<BoundedReal, N>& values, int bits) {
  std::int64_t error = 0;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = values[i].fixed(bits);
    error += std::min(values[i].error_of(bits), CrossArc::most_error);
  }
  return error;
}

// A form's first half, in place; returns the other [de Casteljau].
template <std::size_t N>
std::array<std::int64_t, N> halved(std::array<std::int64_t, N>& c) {
  std::array<std::int64_t, N> right = c;
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t j = N - 1; j >= i; --j) c[j] = (c[j - 1] + c[j]) / 2;
    right[N - 1 - i] = c[N - 1];
  }
  return right;
}

}  // namespace

bool CrossArc::make(const CrossLine& line, const ArcEnd& a, const ArcEnd& b, const Lighting& lighting) {
  const BoundedReal ss = a.s * b.s;
  const BoundedReal polar = line.d2 + (line.d1 * (a.x + b.x)).half() + line.d0 * a.x * b.x;
  // polar + ss without cancellation: where it has one, by way of polar - ss and their product polar^2 - ss^2.
  const BoundedReal width = b.x - a.x;
  const BoundedReal product = (line.d1.half() * line.d1.half() - line.d0 * line.d2) * width * width;
  const BoundedReal whole = polar.sign() < 0 ? product / (polar - ss) : polar + ss;
  if (whole.sign() <= 0) return false;
  const BoundedReal root = (whole + whole).root();
  const BoundedReal kappa = BoundedReal(1) / root;
  const BoundedReal height = root.half();  // of kappa T along s: kappa (P + sA sB)

  RealVector na;
  RealVector nb;
  RealVector nt;
  for (std::size_t i = 0; i < 3; ++i) {
    const BoundedReal flat_a = line.normal[i] + line.normal_step[i] * a.x;
    const BoundedReal flat_b = line.normal[i] + line.normal_step[i] * b.x;
    na[i] = flat_a + line.normal_root[i] * a.s;
    nb[i] = flat_b + line.normal_root[i] * b.s;
    nt[i] = kappa * (b.s * flat_a + a.s * flat_b) + height * line.normal_root[i];
  }
  const BoundedReal twice = kappa + kappa;
  return make(na, nt, nb, {twice * a.s, twice * (a.s + b.s)}, lighting);
}

bool CrossArc::make(const RealVector& na, const RealVector& nt, const RealVector& nb,
                    const std::array<BoundedReal, 2>& places, const Lighting& lighting) {
  RealVector towards;  // the light: of length 1
  std::int64_t light_squared = 0;
  for (const std::int32_t l : lighting.light) light_squared += static_cast<std::int64_t>(l) * l;
  const BoundedReal length = BoundedReal(light_squared).root();
  for (std::size_t i = 0; i < 3; ++i) towards[i] = BoundedReal(lighting.light[i]) / length;
  const BoundedReal l0 = dot(towards, na);
  const BoundedReal l1 = dot(towards, nt);
  const BoundedReal l2 = dot(towards, nb);
  const BoundedReal n0 = dot(na, na);
  const BoundedReal n1 = dot(na, nt);
  const BoundedReal pole = dot(nt, nt);
  const BoundedReal n2 = dot(na, nb) + pole + pole;  // three times Bernstein's
  const BoundedReal n3 = dot(nt, nb);
  const BoundedReal n4 = dot(nb, nb);

  const std::array<BoundedReal, 3> light = powers(l0, l1 + l1, l2);
  const std::array<BoundedReal, 5> square = powers(n0, BoundedReal(4) * n1, n2 + n2, BoundedReal(4) * n3, n4);
  // Sums of three and of five stay below 1.
  const int scale = std::max((bits_of(square) + 4) >> 1, bits_of(light) + 2);
  const std::array<BoundedReal, 5> slope{l1 * n0 - l0 * n1, l1 * n1 * BoundedReal(2) + l2 * n0 - l0 * n2,
                                         BoundedReal(3) * (l2 * n1 - l0 * n3),
                                         l2 * n2 - l1 * n3 * BoundedReal(2) - l0 * n4, l2 * n3 - l1 * n4};
  const std::array<BoundedReal, 5> slope_powers = powers(slope[0], slope[1], slope[2], slope[3], slope[4]);
  const int slope_bits = form_bits - 3 - std::max(bits_of(slope), bits_of(slope_powers));
  const BoundedReal quarter = BoundedReal(1).half().half();
  const std::array<BoundedReal, 5> points{slope[0], slope[1] * quarter, slope[2] / BoundedReal(6), slope[3] * quarter,
                                          slope[4]};
  std::array<std::int64_t, 2> weights{};
  // A place's divisor is at least weight_ sigma tau, and 1/2.
  const int steepness = bits_of(places);
  if (steepness > most_weight_bits) return false;
  if (put(weights, places, weight_bits) > std::int64_t{4} << std::max(0, steepness)) return false;
  weight_a_ = weights[0];
  weight_ = weights[1];
  // Products are rounded by less than 1 a power, t^2 and the squares by 8 in all; |L| < 1 and t^2 <= 1.
  const std::int64_t light_error = put(light_, light, form_bits - scale) + 2;
  const std::int64_t square_error = put(square_, square, form_bits - 2 * scale) + 4;
  unsure_ = 3 * light_error + square_error + 8;
  slope_error_ = std::max(put(slope_, slope_powers, slope_bits), put(slope_points_, points, slope_bits)) + 8;
  return unsure_ < most_error;
}

ArcLight CrossArc::at(std::uint32_t tau) const {
  ArcLight at{};
  value_and_slope(light_, tau, at.light, at.light_slope);
  value_and_slope(square_, tau, at.square, at.square_slope);
  at.square = std::max<std::int64_t>(at.square, 0);
  return at;
}

// (tau^2 + 2 kappa sA sigma tau) / (1 - (2 - 2 kappa (sA + sB)) sigma tau): two numbers off by less than 4 parts of the latter in 2^30.
std::int32_t CrossArc::place(std::uint32_t tau) const {
  const std::uint64_t mixed = std::uint64_t{tau} * -tau;
  const std::uint64_t squared = std::uint64_t{tau} * tau >> (64 - weight_bits);
  const std::uint64_t from_a = squared + high_product(static_cast<std::uint64_t>(weight_a_), mixed);
  constexpr std::int64_t one = std::int64_t{1} << weight_bits;
  const std::int64_t beyond = weight_ - 2 * one;
  const auto more = static_cast<std::int64_t>(high_product(magnitude(beyond), mixed));
  return static_cast<std::int32_t>((from_a << 24) / static_cast<std::uint64_t>(beyond < 0 ? one - more : one + more));
}

int CrossArc::rise(std::uint32_t tau) const {
  const std::int64_t w = value_of(slope_, tau);
  return w > slope_error_ ? 1 : (w < -slope_error_ ? -1 : 0);
}

// w as a form in four points, `of_b` of them b and the others a: a coefficient of w on the interval from a to b.
std::int64_t CrossArc::blossom(std::uint32_t a, std::uint32_t b, int of_b) const {
  std::array<std::int64_t, 5> c = slope_points_;
  for (int n = 4; n > 0; --n) {
    const std::uint32_t at = n <= of_b ? b : a;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) c[i] += product(c[i + 1] - c[i], at);
  }
  return c[0];
}

int CrossArc::turns(std::uint32_t a, std::uint32_t b) const {
  int turns = 0;
  int last = 0;
  for (int i = 0; i <= 4; ++i) {
    const std::int64_t w = blossom(a, b, i);
    if (w <= slope_error_ && w >= -slope_error_) return many;
    const int sign = w < 0 ? -1 : 1;
    turns += sign == -last ? 1 : 0;
    last = sign;
  }
  return turns;
}

// L and |N|^2 in Bernstein form, whose errors are below unsure(), on either half: on the whole of a half circle the middle of L is 0.
int CrossArc::sign_of_excess(const LevelBar& bar) const {
  const auto& [l0, l1, l2] = light_;
  const auto& [n0, n1, n2, n3, n4] = square_;
  std::array<std::int64_t, 3> light{l0, l0 + l1 / 2, l0 + l1 + l2};
  std::array<std::int64_t, 5> square{n0, n0 + n1 / 4, n0 + n1 / 2 + n2 / 6, n0 + (n1 * 3 + n3) / 4 + n2 / 2,
                                     n0 + n1 + n2 + n3 + n4};
  const std::array<std::int64_t, 3> right_light = halved(light);
  const std::array<std::int64_t, 5> right_square = halved(square);
  const int sign = sign_of_excess(bar, light, square);
  return sign != 0 && sign == sign_of_excess(bar, right_light, right_square) ? sign : 0;
}

int CrossArc::sign_of_excess(const LevelBar& bar, const std::array<std::int64_t, 3>& light,
                             const std::array<std::int64_t, 5>& square) const {
  const auto [least, most] = std::ranges::minmax(light);
  if (most < -unsure_) return -1;
  if (least < 0) return 0;
  const auto times = [&light](std::size_t i, std::size_t j) {
    return product(static_cast<std::uint64_t>(light[i]), static_cast<std::uint64_t>(light[j]));
  };
  const std::array<std::int64_t, 5> light2{times(0, 0), times(0, 1), (times(0, 2) + 2 * times(1, 1)) / 3, times(1, 2),
                                           times(2, 2)};
  int signs = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto normal = static_cast<std::uint64_t>(std::max<std::int64_t>(square[i], 0));
    const std::int64_t excess = light2[i] - product(static_cast<std::uint64_t>(bar.square), normal);
    signs += excess > 2 * unsure_ ? 1 : (excess < -2 * unsure_ ? -1 : 0);
  }
  return signs / 5;
}

std::int64_t LevelBar::excess(const ArcLight& at) const {
  const std::int64_t l2 = product(magnitude(at.light), magnitude(at.light));
  return (at.light < 0 ? -l2 : l2) - product(static_cast<std::uint64_t>(square), static_cast<std::uint64_t>(at.square));
}

std::int64_t LevelBar::slope(const ArcLight& at) const {
  const std::int64_t l = at.light < 0 ? -at.light : at.light;
  return 2 * ((l >> 31) * (at.light_slope >> 31)) - (square >> 31) * (at.square_slope >> 31);
}

// Newton's step on L - t |N|, which unlike the squares' difference is steep where L is near 0, to some 15 bits:
//   -(excess + 2 min(L, 0) t |N|) / ((|L| + t |N|) (L' - t |N|'))    in units of tau; 2^32 where it would be more.
std::int64_t LevelBar::step(const ArcLight& at, std::int64_t excess) const {
  constexpr std::int64_t far = std::int64_t{1} << 32;
  const std::int32_t root = quick_root(static_cast<std::uint64_t>(std::max<std::int64_t>(at.square, 1)));  // 2^-30
  const std::int64_t light = at.light >> 30, normal = std::int64_t{threshold} * root >> 30;
  // |N|' in 2^-15, where it is steep less.
  const std::int32_t normal_slope = std::clamp<std::int32_t>(
      static_cast<std::int32_t>(at.square_slope >> 31) / ((root >> 15) + 1), -(1 << 20), 1 << 20);
  const std::int64_t slope = (at.light_slope >> 34) - (std::int64_t{threshold} * normal_slope >> 19);  // 2^-26
  const std::int64_t product = ((light < 0 ? -light : light) + normal) * slope;
  const std::int64_t lead = excess + std::min<std::int64_t>(light, 0) * normal * 2;
  const std::uint64_t d = magnitude(product);
  const std::uint64_t n = magnitude(lead);
  if (n >> 4 >= d) return far;
  // n / 16 d with the divisor cut to 16 bits and the dividend to 32.
  const int cut_d = std::max(0, static_cast<int>(std::bit_width(d)) - 16);
  const int cut_n = static_cast<int>(std::bit_width(n)) - 32;
  const auto dividend = static_cast<std::uint32_t>(cut_n >= 0 ? n >> cut_n : n << -cut_n);
  const std::int64_t quotient = dividend / static_cast<std::uint32_t>(d >> cut_d);
  const int shift = 28 + cut_n - cut_d;
  const std::int64_t step = shift >= 0 ? quotient << std::min(shift, 31) : quotient >> std::min(-shift, 63);
  return (lead < 0) == (product < 0) ? -step : step;
}

}  // namespace halfspace
