#include "firmware/core/depth.hpp"

#include <algorithm>

#include "firmware/core/exact.hpp"
#include "firmware/core/quick_root.hpp"

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

DepthSample rational_depth(const ActiveFace& f, std::int32_t x, std::int32_t y) {
  const auto c = [&f](int i) { return Int(f.c[i]); };
  const Int b = c(5).times(x) + c(4).times(y) + c(8);
  const Int linear_x = c(0).times(x) + (c(3).times(y) + c(6)).times(2);
  const Int linear_y = c(1).times(y) + c(7).times(2);
  const Int rest = linear_x.times(x) + linear_y.times(y) + c(9);
  return b.is_zero() ? unrepresentable : quotient(leading(-rest), b + b);
}

int bits_of(std::int32_t length) { return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(length))); }

DepthSample in_page(DepthSample local, const ActiveFace& face) {
  constexpr std::int64_t most = largest_depth >> depth_fraction;
  if (local.error < 0 || face.origin_z > most || face.origin_z < -most) return unrepresentable;
  local.z += face.origin_z * (std::int64_t{1} << depth_fraction);
  return local.z > largest_depth || -local.z > largest_depth ? unrepresentable : local;
}

// Whole dots of page depth between which a face lies.
struct Range {
  std::int32_t low, high;
};

// Between its ends and its middle a face lies within the chords' strips (depth.hpp). Produced by the other half's length and a part in
// `shorter`, a chord rises by no more than it does there, and that part: halves differ by a dot.
Range range_of(const DepthLine& line, std::int32_t a, std::int32_t b) {
  constexpr Range unknown{INT32_MIN, INT32_MAX};
  const std::int32_t shorter = (b - a) / 2;
  const DepthSample middle = line.at(a + shorter);
  std::int64_t low = middle.z;
  std::int64_t high = middle.z;
  std::int64_t error = middle.error;
  if (error < 0) return unknown;
  for (const std::int32_t x : {a, b}) {
    const DepthSample end = line.at(x);
    if (end.error < 0) return unknown;
    error = std::max(error, end.error);
    const std::int64_t rise = end.z - middle.z;
    const std::int64_t produced = shorter == 0 ? 0 : -(rise + (rise >> (bits_of(shorter) - 1)));
    low = std::min({low, end.z, middle.z + produced});
    high = std::max({high, end.z, middle.z + produced});
  }
  low -= 5 * error + 1;  // that of a value produced by twice its length, and of the shift
  high += 5 * error + 1;
  constexpr std::int64_t most = std::int64_t{INT32_MAX} << depth_fraction;
  if (low < -most || high > most) return unknown;
  return {static_cast<std::int32_t>(low >> depth_fraction), static_cast<std::int32_t>(-(-high >> depth_fraction))};
}

// Whether both faces are sheets of one surface and the same one of them: then they tie on every dot. Their polynomials are
// compared in f's frame, where g's p is p - d.
bool coincide(const ActiveFace& f, const ActiveFace& g) {
  if (f.kind != g.kind || f.sheet != g.sheet) return false;
  const bool plane = f.kind == FaceKind::plane;
  if (!std::equal(f.c.begin(), f.c.begin() + (plane ? 3 : 6), g.c.begin())) return false;
  const std::array<Int, 3> d{Int(g.origin_x) - Int(f.origin_x), Int(g.origin_y) - Int(f.origin_y),
                             Int(g.origin_z) - Int(f.origin_z)};
  const auto along = [&d](const ActiveFace& of, int i, int j, int k) {
    return Int(of.c[i]) * d[0] + Int(of.c[j]) * d[1] + Int(of.c[k]) * d[2];
  };
  if (plane) return Int(f.c[3]) == Int(g.c[3]) - along(g, 0, 1, 2);
  const std::array<Int, 3> m{along(g, 0, 3, 5), along(g, 3, 1, 4), along(g, 5, 4, 2)};
  Int constant(g.c[9]);
  for (int i = 0; i < 3; ++i) {
    if (Int(f.c[6 + i]) != Int(g.c[6 + i]) - m[i]) return false;
    constant -= (Int(f.c[6 + i]) + Int(g.c[6 + i])) * d[i];  // d'Md - 2 l.d, where Md is the difference of both l
  }
  return Int(f.c[9]) == constant;
}

// What a face may reach at one end of a half run, times `far`: its depth there, or that of the chord of the other half,
// `far` dots long, produced by the half's `near` dots.
struct Strip {
  std::int64_t low, high;
};

Strip strip(std::int64_t end, std::int64_t middle, std::int64_t other, std::int32_t near, std::int32_t far) {
  const std::int64_t extended = far * middle - near * (other - middle);
  return {std::min(far * end, extended), std::max(far * end, extended)};
}

// Both faces at a dot.
using Pair = DepthPair;

// -1: f is nearer for sure, 1: g is, 0: cannot tell.
int sure_sign(const Pair& at) {
  if (at.f.error < 0 || at.g.error < 0) return 0;
  const std::int64_t difference = at.f.z - at.g.z;
  const std::int64_t error = at.f.error + at.g.error;
  return difference > error ? 1 : (difference < -error ? -1 : 0);
}

// The dot between, where the chords of two faces whose order differs at two dots cross.
std::int32_t chord_crossing(const Pair& left, const Pair& right) {
  const auto apart = [](const Pair& at) { return static_cast<std::uint64_t>(std::abs(at.f.z - at.g.z)); };
  const int shift = std::max(0, static_cast<int>(std::bit_width(apart(left) | apart(right))) - 16);
  const auto a = static_cast<std::uint32_t>(apart(left) >> shift);
  const auto b = static_cast<std::uint32_t>(apart(right) >> shift);
  const auto length = static_cast<std::uint32_t>(right.x - left.x);
  return std::clamp(left.x + static_cast<std::int32_t>(length * a / (a + b)), left.x + 1, right.x - 1);
}

// -1: f nearer on all dots from `end` to `middle`, 1: g, 0: cannot tell. `other` lies beyond the middle.
int nearer_between(const Pair& end, const Pair& middle, const Pair& other) {
  std::int64_t error = 0;
  for (const Pair* pair : {&end, &middle, &other}) {
    if (pair->f.error < 0 || pair->g.error < 0) return 0;
    error = std::max(error, pair->f.error + pair->g.error);
  }
  const std::int64_t difference = middle.f.z - middle.g.z;
  if (std::abs(difference) <= error) return 0;
  const std::int32_t near = end.x < middle.x ? middle.x - end.x : end.x - middle.x;
  const std::int32_t far = other.x < middle.x ? middle.x - other.x : other.x - middle.x;
  const Strip f = strip(end.f.z, middle.f.z, other.f.z, near, far);
  const Strip g = strip(end.g.z, middle.g.z, other.g.z, near, far);
  const std::int64_t ends = error * (far + 2 * near);  // of an extended value, times far
  if (difference < 0) return f.high - g.low < -ends ? -1 : 0;
  return f.low - g.high > ends ? 1 : 0;
}

}  // namespace

DepthLine::DepthLine(const ActiveFace& face, std::int32_t y) : face_(face), y_(y - face.origin_y) {
  const DepthBlock& k = face.block;
  const std::int32_t s = y - k.y0;
  b_ = k.b + k.by * s;
  d_ = k.d + part(k.dy + k.dyy * s, s, k.y_bits);
  dx_ = k.dx + k.dxy * s;
}

DepthSample DepthLine::at(std::int32_t x) const {
  if (face_.kind == FaceKind::rational) return in_page(rational_depth(face_, x - face_.origin_x, y_), face_);
  const DepthBlock& k = face_.block;
  if (k.error < 0) return unrepresentable;
  const std::int32_t t = x - k.x0;
  std::int64_t units = -((b_ + k.bx * t) >> 16);
  std::int64_t error = k.error;
  if (face_.kind == FaceKind::root) {
    const std::int64_t d = d_ + part(dx_ + k.dxx * t, t, k.x_bits);
    const std::int32_t root = d > 0 ? quick_root(static_cast<std::uint64_t>(d)) : 0;
    if (root < k.shallow) error = k.shallow_error;
    units += face_.sheet * root;
  }
  const std::int64_t z = (units * face_.inverse) >> k.shift;
  return {z + face_.origin_z * (std::int64_t{1} << depth_fraction), error + ((z < 0 ? -z : z) >> 29)};
}

void bound_depth(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b, Counters& counters) {
  if (face.kind != FaceKind::rational) return make_block(face, y, a, b);
  counters.depth_samples += 3;
  const Range range = range_of(DepthLine(face, y), a, b);
  face.block.low = range.low;
  face.block.high = range.high;
  face.block.x0 = static_cast<std::int16_t>(a);
  face.block.x1 = static_cast<std::int16_t>(b);
  face.block.y0 = face.block.y1 = static_cast<std::int16_t>(y);
}

std::int32_t find_turn(const ActiveFace& f, const ActiveFace& g, DepthProof& proof, std::int32_t y, std::int32_t a,
                       std::int32_t b, Counters& counters) {
  const DepthLine f_line(f, y);
  const DepthLine g_line(g, y);
  const auto sign_at = [&](std::int32_t x) {
    counters.depth_samples += 2;
    return sure_sign({x, f_line.at(x), g_line.at(x)});
  };
  const std::int32_t guess = std::clamp<std::int32_t>(proof.crossing, a, b);
  const std::int32_t turn = find_change(sign_at, a - 1, b + 1, -proof.turn, guess);
  if (turn < 0) return -1;
  proof.crossing = static_cast<std::int16_t>(turn);
  return turn;
}

DepthOrder::DepthOrder(const ActiveFace& f, const ActiveFace& g, DepthProof& proof, std::int32_t y, std::int32_t a,
                       std::int32_t b, const ExactModule& exact, Counters& counters)
    : f_(f),
      g_(g),
      proof_(proof),
      guess_(proof.crossing),
      f_line_(f, y),
      g_line_(g, y),
      y_(y),
      exact_(exact),
      counters_(counters) {
  proof.crossing = -1;
  push(a, b, 0);
}

void DepthOrder::push(std::int32_t a, std::int32_t b, int known) {
  stack_[depth_++] = {static_cast<std::int16_t>(a), static_cast<std::int16_t>(b), static_cast<std::int8_t>(known)};
}

DepthPair DepthOrder::sample(std::int32_t x) {
  for (const Pair& pair : recent_) {
    if (pair.x == x) return pair;
  }
  counters_.depth_samples += 2;
  return {x, f_line_.at(x), g_line_.at(x)};
}

int DepthOrder::winner(int sign) const {
  if (sign == 0) return f_.order < g_.order ? -1 : 1;
  return sign;
}

bool DepthOrder::one_surface() {
  if (!compared_) one_surface_ = coincide(f_, g_);
  compared_ = true;
  return one_surface_;
}

// The face that shows at a dot.
int DepthOrder::winner_at(std::int32_t x) {
  const int sure = sure_sign(sample(x));
  if (sure != 0) return sure;
  if (one_surface()) return winner(0);
  ++counters_.exact_depths;
  return winner(exact_.compare_depth(f_, g_, x, y_));
}

// Where the ends settle what lies between: two dots, or two planes, whose distance is linear.
DepthOrder::Step DepthOrder::settle_by_ends(const Run& run, Piece& piece) {
  const int left = winner_at(run.a);
  const int right = run.a == run.b ? left : winner_at(run.b);
  piece = {run.b, left < 0};
  if (left == right) return Step::settled;
  if (run.b - run.a > 1) {
    const std::int32_t m = run.a + (run.b - run.a) / 2;
    push(m + 1, run.b, 0);
    push(run.a, m, 0);
    return Step::halved;
  }
  piece.end = run.a;
  push(run.b, run.b, right);
  return Step::settled;
}

// Where to look for the dots between which the order changes: where it did last, on either side of that, then by chords, and every
// third time halfway.
std::int32_t DepthOrder::next_guess(const Pair& left, const Pair& right, int step) const {
  if (step < 2 && left.x <= guess_ && guess_ <= right.x) {
    if (guess_ == left.x) return left.x + 1;
    return guess_ == right.x ? right.x - 1 : guess_;
  }
  return step % 3 == 2 ? left.x + (right.x - left.x) / 2 : chord_crossing(left, right);
}

// Cuts a run, at whose ends the order differs for sure, between the two dots where it changes. If one of the faces is the inner one it
// changes there alone, and not at all where that one shows at both ends.
DepthOrder::Step DepthOrder::cross(const Run& run, Piece& piece) {
  const Pair first = sample(run.a);
  const Pair last = sample(run.b);
  recent_[0] = first;
  recent_[2] = last;
  const int sign = sure_sign(first);
  const int behind = sure_sign(last);
  const bool once = proof_.inner != 0;
  if (once && sign == proof_.inner && behind == sign) {
    piece = {run.b, sign < 0};
    return Step::settled;
  }
  if (sign == 0 || behind != -sign) return Step::none;
  --crossings_;
  Pair left = first;
  Pair right = last;
  for (int step = 0; right.x - left.x > 1; ++step) {
    const std::int32_t x = next_guess(left, right, step);
    counters_.depth_samples += 2;
    const Pair at{x, f_line_.at(x), g_line_.at(x)};
    const int here = sure_sign(at);
    if (here == 0) return Step::none;
    (here == sign ? left : right) = at;
  }
  proof_.crossing = static_cast<std::int16_t>(right.x);
  const int before = once || left.x == run.a ? sign : nearer_between(first, left, right);
  push(right.x, run.b, once || right.x == run.b ? -sign : nearer_between(last, right, left));
  piece = {left.x, before < 0};
  if (before != 0) return Step::settled;
  push(run.a, left.x, 0);
  return Step::halved;
}

// Settles the run's left half, or leaves both halves on the stack.
DepthOrder::Step DepthOrder::halve(const Run& run, Piece& piece) {
  const std::int32_t m = run.a + (run.b - run.a) / 2;
  const Pair last = sample(run.b);
  if (recent_[0].x != run.a) recent_[0] = sample(run.a);
  recent_[1] = sample(m);
  recent_[2] = last;
  const int left = nearer_between(recent_[0], recent_[1], recent_[2]);
  const int right = nearer_between(recent_[2], recent_[1], recent_[0]);
  if (left == right && (left != 0 || one_surface())) {
    piece = {run.b, winner(left) < 0};
    return Step::settled;
  }
  push(m + 1, run.b, right);
  if (left == 0) {
    push(run.a, m, 0);
    return Step::halved;
  }
  piece = {m, left < 0};
  return Step::settled;
}

DepthOrder::Piece DepthOrder::next() {
  Piece piece{};
  const bool planes = f_.kind == FaceKind::plane && g_.kind == FaceKind::plane;
  for (;;) {
    const Run run = stack_[--depth_];
    if (run.known != 0) return {run.b, run.known < 0};
    Step step = Step::none;
    if (run.b - run.a > 1 && crossings_ > 0) step = cross(run, piece);
    if (step == Step::none) step = planes || run.b - run.a < 2 ? settle_by_ends(run, piece) : halve(run, piece);
    if (step == Step::settled) return piece;
  }
}

}  // namespace halfspace
