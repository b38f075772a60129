#include "firmware/core/level_chord.hpp"

#include <algorithm>

#include "firmware/core/chord_divisor.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t largest = std::int32_t{1} << 30;  // |L| is at most |N|

// Unsigned, so that a job that lies about its widths wraps and nothing worse.
std::int32_t difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
std::uint64_t product(std::int32_t a, std::int32_t b) { return static_cast<std::uint64_t>(std::int64_t{a} * b); }
std::uint64_t second_difference(std::int64_t v2, std::int32_t h) {
  return static_cast<std::uint64_t>(v2) * static_cast<std::uint64_t>(std::int64_t{h} * h);
}

}  // namespace

namespace {

// | |a| - |b| | <= |a^2 - b^2| / |a|; 2^18 > square_error.
std::int32_t error_of_root(std::int32_t square_error, std::int32_t n) {
  return (square_error << 12) / std::max<std::int32_t>(n >> 16, 1) + 4;
}
// And at most the root of |a^2 - b^2|: 2^27, as the error is at most 2^26, in units of 2^28.
std::int32_t wide_error_of_root(std::int32_t square_error, std::int32_t n) {
  if (square_error >> 18 == 0) return error_of_root(square_error, n);
  return (std::min<std::int32_t>((((square_error >> 8) + 1) << 12) / std::max<std::int32_t>(n >> 16, 1), 1 << 19) + 1)
         << 8;
}

}  // namespace

[[gnu::always_inline]] inline void LevelDot::set(const ShortDot& dot, std::int32_t of_n, std::int32_t bar_error) {
  s = dot.s;
  r = dot.r;
  l = std::clamp(dot.l >> 1, -largest / 2, largest / 2);
  root_error = dot.root_error;
  normal_error = of_n;
  error = ((dot.light_error + normal_error + bar_error) >> 1) + 3;
}

LevelDot::LevelDot(const LineSection& line, std::int32_t at, std::int32_t bar_error) : t(at) {
  if (line.by_depth()) {
    set_by_depth(line, bar_error);
  } else {
    const ShortDot dot = line.plain_dot(at);
    n = short_root(std::max<std::int32_t>(dot.square, 1));
    set(dot, error_of_root(dot.square_error, n), bar_error);
  }
}

[[gnu::noinline]] void LevelDot::set_by_depth(const LineSection& line, std::int32_t bar_error) {
  const ShortDot dot = line.depth_dot(t);
  z = dot.z;
  n = short_root(std::max<std::int32_t>(dot.square, 1));
  set(dot, wide_error_of_root(dot.square_error, n), bar_error);
}

// What taking the middle leaves out of F, where |ds| <= (s_a + s_b) / 5, |E| <= (s_a + s_b) / 32, and so for n and J:
//   of u (1-u) E     |E| (|ds| + |E|) / 8 (s_a + s_b), as E's denominator is s_a + s_b + (2u-1) ds + u (1-u) E and
//                    u (1-u) |2u-1| < 0.0963; the roots' errors, and the quotient's, are a quarter of 1.1 root_error + 7 + 2^-13 |E|
//   of u (1-u) J     r times that; r's change, |dr| |E| / 16; r's errors of 16 units in dr ds and r E, and the roots' in dr ds
//   of u (1-u) J/2A  that over 2A >= 4/5 (n_a + n_b); |J/2A| (|dn| + 2 |J/2A|) / 8 (n_a + n_b), the last from the root's series;
//                    a quarter of what dn^2 errs by, 2 (|dn| + normal_error) 2 normal_error
template <bool by_depth>
[[gnu::always_inline]] inline void LevelChord::set(const LineSection& line, const LevelDot& a, const LevelDot& b) {
  const std::int32_t ds = b.s - a.s;
  const std::int32_t dn = b.n - a.n;
  const std::uint32_t s_sum = static_cast<std::uint32_t>(a.s) + static_cast<std::uint32_t>(b.s);
  const std::uint32_t n_sum = static_cast<std::uint32_t>(a.n) + static_cast<std::uint32_t>(b.n);
  const auto root_error = static_cast<std::uint32_t>(std::max(a.root_error, b.root_error));
  const auto normal_error = static_cast<std::uint32_t>(std::max(a.normal_error, b.normal_error));
  if (!dwarfs(n_sum, size(dn), 5) || !dwarfs(n_sum, normal_error, 1 << 10)) return;
  if (!dwarfs(s_sum, size(ds), 5)) {
    if constexpr (!by_depth) set_across(line, a, b);
    return;
  }
  const Divisor s(s_sum);
  const Divisor n(n_sum);
  // Of s or z.
  std::int32_t change = ds;
  std::int64_t bend;
  if constexpr (by_depth) {
    const LineDepth& depth = line.depth();
    change = b.z - a.z;
    const std::int64_t of_s = (depth.a >> 30) * change >> 30;
    const std::int64_t of_b = depth.b.v1 * width_ >> BlockDepth::fraction;
    if (magnitude(of_s) > s_sum / 4 || magnitude(of_b) > s_sum / 2) return;
    bend = static_cast<std::int64_t>(static_cast<std::uint64_t>((2 * of_b + of_s) * change) -
                                     second_difference(depth.c.v2, width_));
  } else {
    bend = static_cast<std::int64_t>(product(ds, ds) - second_difference(line.forms().d.xx, width_));
  }
  if (!s.divides(bend)) return;
  const std::int32_t e = s.quotient(bend);
  const std::int32_t r = (a.r >> 1) + (b.r >> 1);
  const std::int32_t dr = difference(b.r, a.r);
  std::uint64_t bulge_terms =
      second_difference(line.forms().q.xx, width_) + product(dr, change) - product(dn, dn) - product(r, e);
  std::uint32_t bow_of_s = size(e);
  std::uint32_t slope_error = 8;
  std::uint64_t square_left = 0;
  if constexpr (by_depth) {
    const std::int32_t zz = line.forms().zz;
    bulge_terms -= product(static_cast<std::int32_t>(std::int64_t{zz} * change >> 30), change);
    bow_of_s = static_cast<std::uint32_t>(magnitude((line.depth().a >> 30) * e) >> 30) + 1;
    slope_error = 16 + 4 * root_error;
    square_left = std::uint64_t{size(static_cast<std::int32_t>(std::int64_t{zz} * e >> 30)) + 1} * size(e) / 16;
  }
  const auto bulge = static_cast<std::int64_t>(bulge_terms);
  if (!n.divides(bulge)) return;
  const std::int32_t j = n.quotient(bulge);

  const std::uint32_t e_left = s.eighth_part(size(e), size(ds) + bow_of_s) + (size(e) >> 15) +
                               (by_depth ? root_error + size(change) / s_sum + 4 : root_error / 2) + 4;
  const auto bulge_left = static_cast<std::int64_t>(std::uint64_t{size(dr)} * (size(e) / 16 + root_error / 2 + 1) +
                                                    (std::uint64_t{size(r)} + size(dr)) * e_left +
                                                    std::uint64_t{size(change) + size(e)} * slope_error + square_left);
  if (!n.divides(bulge_left)) return;
  const std::int32_t m = line.forms().m;
  bow_ = static_cast<std::int32_t>(std::int64_t{m} * e >> 31);
  normal_bow_ = j;
  const std::uint32_t normal_left = static_cast<std::uint32_t>(n.quotient(bulge_left)) * 5 / 4 +
                                    n.eighth_part(size(j), size(dn) + 2 * size(j)) + (size(j) >> 10);
  const auto light_left = static_cast<std::uint32_t>(std::uint64_t{size(m)} * e_left >> 30);
  keep(std::max(a.error, b.error) + static_cast<std::int32_t>((light_left + normal_left + normal_error / 2) / 2 + 9));
}

// X in 2^-20 of the block's 2^half_bits dots, D' and G in 2^31 a block of these. With |D2 h| and |D2 X| at most M / 8:
//   of u (1-u) X     |X| (|D2 h| + |D2 X|) / 8 M, as M's change is (2u-1) D2 h + u (1-u) D2 X, of which M keeps 27/32 at least; the roots' errors
//                    in ds^2 are a quarter of 4 root_error (|ds| + root_error) / M; the quotient's and those of M's 16 units
//   of u (1-u) J     G times that; G's change, |X| (|q2 h + r' ds / 2| + |q2 X|) / 8, and its errors, 24 units and r' times the root's; dr
//                    and ds as above
[[gnu::noinline]] void LevelChord::set_across(const LineSection& line, const LevelDot& a, const LevelDot& b) {
  const std::int32_t ds = b.s - a.s;
  const std::int32_t dn = b.n - a.n;
  const std::int32_t dr = difference(b.r, a.r);
  const std::uint32_t n_sum = static_cast<std::uint32_t>(a.n) + static_cast<std::uint32_t>(b.n);
  const auto s_sum = static_cast<std::int32_t>(static_cast<std::uint32_t>(a.s) + static_cast<std::uint32_t>(b.s));
  const auto root_error = static_cast<std::uint32_t>(std::max(a.root_error, b.root_error));
  const auto normal_error = static_cast<std::uint32_t>(std::max(a.normal_error, b.normal_error));
  const ShortPolynomial& d = line.d();
  const ShortPolynomial& q = line.q();
  const ShortPolynomial& r = line.r();
  const std::int32_t from = line.tau(a.t) >> 1;
  const std::int32_t to = line.tau(b.t) >> 1;
  const auto slope_of = [&](const ShortPolynomial& p) { return (p.v1 >> 1) + (high_product(p.v2, from + to) << 2); };
  const auto turn_of = [&](const ShortPolynomial& p) { return high_product(p.v2, to - from) << 2; };
  const std::int32_t steepness = slope_of(d);  // D'
  const std::int32_t turn = turn_of(d);
  if (!dwarfs(size(steepness), size(turn), 8)) return;
  const Divisor m(size(steepness));
  const Divisor n(n_sum);
  const auto bend = static_cast<std::int64_t>(product(ds, ds) - second_difference(line.forms().d.xx, width_)) >> 11;
  if (!m.divides(bend)) return;
  const std::int32_t way = m.quotient(steepness < 0 ? bend : -bend);  // X
  const auto way_turn = static_cast<std::uint32_t>(magnitude(std::int64_t{d.v2} * way) >> 20) + 1;
  if (!dwarfs(size(steepness), way_turn, 8)) return;
  const std::int32_t g = slope_of(q) + (high_product(r.v1, s_sum) << 2);
  const auto bulge = static_cast<std::int64_t>(second_difference(line.forms().q.xx, width_) + product(dr, ds) -
                                               product(dn, dn) - (product(way, g) << 11));
  if (!n.divides(bulge)) return;
  const std::int32_t j = n.quotient(bulge);

  const std::uint32_t way_left =
      m.eighth_part(size(way), size(turn) + way_turn) + (size(way) >> 14) +
      static_cast<std::uint32_t>(
          m.quotient(static_cast<std::int64_t>(std::uint64_t{root_error} * (size(ds) + root_error) >> 11))) +
      8;
  const std::uint32_t dg = size(turn_of(q) + (high_product(r.v1, ds) << 2)) +
                           (static_cast<std::uint32_t>(magnitude(std::int64_t{q.v2} * way) >> 20));
  const std::uint32_t g_error = 24 + (high_product(size(r.v1), root_error) << 3);
  const auto bulge_left = static_cast<std::int64_t>(
      std::uint64_t{size(dr)} * (root_error / 2 + 1) + std::uint64_t{size(ds)} * 8 +
      ((std::uint64_t{size(g)} * way_left + std::uint64_t{size(way)} * (dg / 8 + g_error / 4 + 1)) << 11));
  if (!n.divides(bulge_left)) return;
  const std::int32_t l = line.l().v1;
  bow_ = static_cast<std::int32_t>(std::int64_t{l} * way >> 19);
  normal_bow_ = j;
  const std::int32_t shift = line.tau_shift() - 20;
  way_bow_ = (way << 7) >> shift;
  way_error_ = static_cast<std::int32_t>((way_left << 7) >> shift) + 4;
  steepness_ = width_ + (static_cast<std::int32_t>(size(way_bow_)) >> 16) + 1;
  const std::uint32_t normal_left = static_cast<std::uint32_t>(n.quotient(bulge_left)) * 5 / 4 +
                                    n.eighth_part(size(j), size(dn) + 2 * size(j)) + (size(j) >> 10);
  const auto light_left = static_cast<std::uint32_t>(std::uint64_t{size(l)} * way_left >> 18);
  keep(std::max(a.error, b.error) + static_cast<std::int32_t>((light_left + normal_left + normal_error / 2) / 2 + 9));
}

void LevelChord::keep(std::int32_t error) {
  error_ = error;
  if (error_ > 1 << 26) return;
  wide_error_ = static_cast<std::uint32_t>(error_ + error_ / 4 + 1);
  least_ = std::max<std::uint32_t>(32 * static_cast<std::uint32_t>(error_), 1 << 16);
}

LevelChord::LevelChord(const LineSection& line, const LevelDot& a, const LevelDot& b) : LevelChord(b.t - a.t) {
  if (line.by_depth()) {
    set_by_depth(line, a, b);
  } else {
    set<false>(line, a, b);
  }
}

[[gnu::noinline]] void LevelChord::set_by_depth(const LineSection& line, const LevelDot& a, const LevelDot& b) {
  set<true>(line, a, b);
}

}  // namespace halfspace
