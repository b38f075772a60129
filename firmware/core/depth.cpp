#include "firmware/core/depth.hpp"

#include <algorithm>

#include "firmware/core/exact.hpp"
#include "firmware/core/isqrt.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

using Int = Wide<256>;

// A number m * 2^shift known to within `error` * 2^shift.
struct Approximate {
  std::int64_t m = 0;
  std::int64_t error = 0;
  int shift = 0;
};

template <int Bits>
Approximate leading(const Wide<Bits>& value) {
  const int shift = std::max(0, value.bit_length() - 62);
  return {scaled(value, shift), shift == 0 ? 0 : 1, shift};
}

constexpr DepthSample unrepresentable{0, -1};
constexpr std::int64_t largest_depth = std::int64_t{1} << 46;  // 2^30 dots: sums of four stay inside 64 bits

// n / d in dots, fixed point. The denominator keeps 31 bits, so the quotient is good to one part in 2^29.
template <int Bits>
DepthSample quotient(Approximate n, const Wide<Bits>& d) {
  const bool negative = d.negative();
  const int d_shift = std::max(0, d.bit_length() - 31);
  const std::int64_t divisor = scaled(d.magnitude(), d_shift);
  const int up = 62 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(n.m < 0 ? -n.m : n.m)));
  const int n_up =
      std::max(0, std::min(up, 62 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(n.error)))));
  std::int64_t z = (n.m << n_up) / divisor;
  std::int64_t error = (n.error << n_up) / divisor + 1;
  const int shift = n.shift - n_up - d_shift + depth_fraction;
  if (shift > 0) {
    const std::int64_t most = shift > 45 ? 0 : largest_depth >> shift;
    if (z > most || -z > most || error >= most) return unrepresentable;
    z <<= shift;
    error = (error + 1) << shift;
  } else {
    z >>= std::min(-shift, 63);
    error = (error >> std::min(-shift, 63)) + 1;
  }
  if (z > largest_depth || -z > largest_depth || error > largest_depth) return unrepresentable;
  error += ((z < 0 ? -z : z) >> 29) + 2;
  return {negative ? -z : z, error};
}

// -b + sheet sqrt(D), both terms on the scale of the larger.
Approximate root_numerator(const ActiveFace& f, std::int32_t x, std::int32_t y) {
  const ScaledQuadratic& form = f.surface.discriminant;
  Wide<128> d = form.at(x, y);
  if (d.negative()) d = Wide<128>();
  const int exponent = form.exponent / 2;
  // A rounded D must be off by less than a unit of what is kept.
  const int least = form.exponent > 0 ? quadratic_error_bits / 2 : -32;
  const Wide<128> b = f.c[5].times(x) + f.c[4].times(y) + f.c[8];
  const int root_shift = std::max({(d.bit_length() - 61) >> 1, least, b.bit_length() - 60 - exponent});
  const auto root = static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(scaled(d, 2 * root_shift))));
  return {-scaled(b, root_shift + exponent) + f.sheet * root, 4, root_shift + exponent};
}

DepthSample local_depth(const ActiveFace& f, std::int32_t x, std::int32_t y) {
  if (f.kind == FaceKind::root) return quotient(root_numerator(f, x, y), f.c[2]);
  if (f.kind == FaceKind::plane) return quotient(leading(-(f.c[0].times(x) + f.c[1].times(y) + f.c[3])), f.c[2]);
  const auto c = [&f](int i) { return Int(f.c[i]); };
  const Int b = c(5).times(x) + c(4).times(y) + c(8);
  const Int linear_x = c(0).times(x) + (c(3).times(y) + c(6)).times(2);
  const Int linear_y = c(1).times(y) + c(7).times(2);
  const Int rest = linear_x.times(x) + linear_y.times(y) + c(9);
  return b.is_zero() ? unrepresentable : quotient(leading(-rest), b + b);
}

// Bounds of f - g at the two ends of a half run, as explained in the header.
struct Strip {
  std::int64_t low, high;
};

Strip strip(const DepthSample& end, const DepthSample& middle, const DepthSample& far) {
  const std::int64_t extended = 2 * middle.z - far.z;
  return {std::min(end.z, extended), std::max(end.z, extended)};
}

// -1: f nearer over the whole half run, +1: g, 0: cannot tell.
int settled(const DepthSample (&f)[3], const DepthSample (&g)[3], int end) {
  const int far = 2 - end;
  std::int64_t error = 0;
  for (int i = 0; i < 3; ++i) {
    if (f[i].error < 0 || g[i].error < 0) return 0;
    error = std::max(error, f[i].error + g[i].error);
  }
  error *= 3;  // an extended value carries three errors
  const Strip sf = strip(f[end], f[1], f[far]);
  const Strip sg = strip(g[end], g[1], g[far]);
  const std::int64_t middle = f[1].z - g[1].z;
  if (sf.high - sg.low < -error && middle < -error) return -1;
  if (sf.low - sg.high > error && middle > error) return 1;
  return 0;
}

}  // namespace

DepthSample sample_depth(const ActiveFace& face, std::int32_t x, std::int32_t y) {
  DepthSample s = local_depth(face, x - face.origin_x, y - face.origin_y);
  if (s.error < 0) return s;
  constexpr std::int64_t most = largest_depth >> depth_fraction;
  if (face.origin_z > most || face.origin_z < -most) return unrepresentable;
  s.z += face.origin_z * (std::int64_t{1} << depth_fraction);
  return s;
}

DepthOrder::DepthOrder(const ActiveFace& f, const ActiveFace& g, std::int32_t y, std::int32_t a, std::int32_t b,
                       const ExactModule& exact, Counters& counters)
    : f_(f), g_(g), y_(y), exact_(exact), counters_(counters) {
  push(a, b, 0);
}

void DepthOrder::push(std::int32_t a, std::int32_t b, int known) {
  stack_[depth_++] = {static_cast<std::int16_t>(a), static_cast<std::int16_t>(b), static_cast<std::int8_t>(known)};
}

DepthSample DepthOrder::sample(const ActiveFace& face, std::int32_t x) {
  ++counters_.depth_samples;
  return sample_depth(face, x, y_);
}

int DepthOrder::winner(int sign) const {
  if (sign == 0) return f_.order < g_.order ? -1 : 1;
  return sign;
}

// sign(z_f - z_g) at a dot.
int DepthOrder::order_at(std::int32_t x) {
  const DepthSample f = sample(f_, x);
  const DepthSample g = sample(g_, x);
  if (f.error >= 0 && g.error >= 0) {
    const std::int64_t difference = f.z - g.z;
    if (difference > f.error + g.error) return 1;
    if (-difference > f.error + g.error) return -1;
  }
  ++counters_.exact_depths;
  return exact_.compare_depth(f_, g_, x, y_);
}

// Two planes: their distance is linear along the run, so equal signs at the ends settle it.
bool DepthOrder::split_planes(const Run& run, Piece& piece) {
  const int left = order_at(run.a);
  const int right = run.a == run.b ? left : order_at(run.b);
  if (left == right) {
    piece = {run.b, winner(left) < 0};
    return true;
  }
  const std::int32_t m = run.a + (run.b - run.a) / 2;
  push(m + 1, run.b, 0);
  push(run.a, m, 0);
  return false;
}

// Settles the run's left half, or leaves both halves on the stack.
bool DepthOrder::halve(const Run& run, Piece& piece) {
  const std::int32_t m = (run.a + run.b) / 2;
  const DepthSample f[3] = {sample(f_, run.a), sample(f_, m), sample(f_, run.b)};
  const DepthSample g[3] = {sample(g_, run.a), sample(g_, m), sample(g_, run.b)};
  const int left = settled(f, g, 0);
  const int right = settled(f, g, 2);
  if (left != 0 && left == right) {
    piece = {run.b, left < 0};
    return true;
  }
  push(m + 1, run.b, right);
  if (left == 0) {
    push(run.a, m, 0);
    return false;
  }
  piece = {m, left < 0};
  return true;
}

DepthOrder::Piece DepthOrder::next() {
  Piece piece{};
  for (;;) {
    const Run run = stack_[--depth_];
    if (run.known != 0) return {run.b, run.known < 0};
    if (f_.kind == FaceKind::plane && g_.kind == FaceKind::plane) {
      if (split_planes(run, piece)) return piece;
    } else if (run.b - run.a < 2) {
      if (run.b > run.a) push(run.b, run.b, 0);
      return {run.a, winner(order_at(run.a)) < 0};
    } else if ((run.b - run.a) % 2 != 0) {
      push(run.b, run.b, 0);
      push(run.a, run.b - 1, 0);
    } else if (halve(run, piece)) {
      return piece;
    }
  }
}

}  // namespace halfspace
