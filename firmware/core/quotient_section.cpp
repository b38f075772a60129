#include "firmware/core/quotient_section.hpp"

#include <algorithm>

#include "firmware/core/chord_divisor.hpp"

namespace halfspace {
namespace {

ShortPolynomial shortened(const LinePolynomial& p, int half_bits) {
  constexpr int unit = QuotientForms::fraction;
  const auto cut = [](std::int64_t v, int shift) { return static_cast<std::int32_t>(v >> shift); };
  return {cut(p.v0, unit), cut(p.v1, unit + 2 - half_bits), cut(p.v2, unit + 3 - 2 * half_bits)};
}

}  // namespace

QuotientSection::QuotientSection(const QuotientForms& forms, const QuotientLine& line)
    : forms_(forms),
      tau_shift_(31 - line.half_bits),
      n_{shortened(line.n[0], line.half_bits), shortened(line.n[1], line.half_bits),
         shortened(line.n[2], line.half_bits)},
      l_(shortened(line.l, line.half_bits)) {}

Answer QuotientSection::reaches(std::int32_t t, std::uint32_t square) const {
  const Dot at = dot(t);
  const Light light{at.l, static_cast<std::int64_t>(at.square)};
  std::int64_t sizes = 0;
  for (const std::int32_t n : at.n) sizes += n < 0 ? -n : n;
  return compare(light, lit_margin(light, sizes, value_error), square);
}

QuotientDot::QuotientDot(const QuotientSection& line, std::int32_t at, std::int32_t bar_error) : t(at) {
  const QuotientSection::Dot dot = line.dot(at);
  std::copy(std::begin(dot.n), std::end(dot.n), n_at);
  l = dot.l >> 1;
  n = quick_root(std::max<std::uint64_t>(dot.square, 1));
  error = ((QuotientSection::value_error + QuotientSection::normal_error + bar_error) >> 1) + 3;
}

// What taking the middle leaves out of F. N_i is known to within e = 41 at a and b, and C = N2 h^2 to within f: 2 of the block's, as
// h^2 < 4 reach^2, 8 times h^2 in parts of the cut N2, and 1 of its own; f <= 36.
//   of u (1-u) J     its linear part, |dN . C| u (1-u) |2u-1|, and u (1-u) |2u-1| < 0.0963
//                    |C|^2: its middle's 1/4 leaves u (1-u) (1/4 - u (1-u)) <= 1/64
//                    errors of N and C: of |dN|^2 / 4, e |dN_i| + e^2 a component; of (N_a + N_b) . C / 4, e |C_i| / 2 + f |sum_i| / 4 + e f / 2; of
//                    |C|^2 / 16, f |C_i| / 8 + f^2 / 16; of the linear part 0.0963 (2 e |C_i| + f |dN_i| + 2 e f): less than 48 (|dN_i| + |C_i|),
//                    f |sum_i| / 4 and 2^12
//   of u (1-u) J/2A  that over 2A >= 4/5 (n_a + n_b); |J/2A| (|dn| + 2 |J/2A|) / 8 (n_a + n_b), the last from the root's series;
//                    a quarter of what dn^2 errs by, 2 (|dn| + normal_error) 2 normal_error
//   of u (1-u) l2 h^2  f / 4
QuotientChord::QuotientChord(const QuotientSection& line, const QuotientDot& a, const QuotientDot& b)
    : LevelChord(b.t - a.t) {
  const std::int32_t dn = b.n - a.n;
  const std::uint32_t n_sum = static_cast<std::uint32_t>(a.n) + static_cast<std::uint32_t>(b.n);
  constexpr std::uint32_t normal_error = QuotientSection::normal_error;
  if (!dwarfs(n_sum, size(dn), 5) || !dwarfs(n_sum, normal_error, 1 << 10)) return;
  const std::int32_t part = line.part(width_);
  const std::uint32_t bend_error = (static_cast<std::uint32_t>(part) >> 26) + 4;
  const std::int64_t most = n_sum / 4;
  std::int64_t bulge = -std::int64_t{dn} * dn;
  std::int64_t turn = 0;    // dN . C
  std::int64_t square = 0;  // of C
  std::uint32_t sums = 0;
  std::uint32_t changes = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t bend = line.normal_bend(i, part);
    if (bend > most || bend < -most) return;
    const auto c = static_cast<std::int32_t>(bend);
    const std::int32_t d = b.n_at[i] - a.n_at[i];
    const std::int32_t sum = a.n_at[i] + b.n_at[i];
    bulge += std::int64_t{d} * d + std::int64_t{sum} * c;
    turn += std::int64_t{d} * c;
    square += std::int64_t{c} * c;
    sums += size(sum) / 4;
    changes += size(d) / 4 + size(c) / 4;
  }
  bulge -= square >> 2;
  if (turn < 0) turn = -turn;
  const auto bulge_left =
      static_cast<std::int64_t>(static_cast<std::uint64_t>((turn >> 4) + (turn >> 5) + (turn >> 8) + (square >> 6)) +
                                std::uint64_t{changes} * 192 + std::uint64_t{sums} * bend_error + (1 << 14));
  const Divisor n(n_sum);
  if (!n.divides(bulge) || !n.divides(bulge_left)) return;
  const std::int32_t j = n.quotient(bulge);
  bow_ = static_cast<std::int32_t>(-line.light_bend(part) >> 1);
  normal_bow_ = j;
  const std::uint32_t normal_left = static_cast<std::uint32_t>(n.quotient(bulge_left)) * 5 / 4 +
                                    n.eighth_part(size(j), size(dn) + 2 * size(j)) + (size(j) >> 10);
  keep(std::max(a.error, b.error) +
       static_cast<std::int32_t>((bend_error / 4 + normal_left + normal_error / 2) / 2 + 9));
}

}  // namespace halfspace
