#include "firmware/core/quotient_ridge.hpp"

#include <algorithm>
#include <bit>

namespace halfspace {
namespace {

// Product of two numbers of 30 bits of fraction.
std::int32_t times(std::int32_t a, std::int32_t b) { return static_cast<std::int32_t>(std::int64_t{a} * b >> 30); }

// A polynomial in tau: its terms at tau = 1.
struct Terms {
  std::array<std::int64_t, 3> c;

  Terms(const LinePolynomial& p, int half_bits)
      : c{p.v0, p.v1 * (std::int64_t{1} << half_bits), p.v2 * (std::int64_t{1} << 2 * half_bits)} {}
  // Bits of its terms' sum.
  [[nodiscard]] int bits() const {
    return static_cast<int>(std::bit_width(magnitude(c[0]) + magnitude(c[1]) + magnitude(c[2])));
  }
  [[nodiscard]] std::array<std::int32_t, 3> cut(int shift) const {
    const auto at = [&](std::size_t i) { return static_cast<std::int32_t>(c[i] >> shift); };
    return {at(0), at(1), at(2)};
  }
};

using Quadratic = std::array<std::int32_t, 3>;

// l' n - l n'
Quadratic wronskian(const Quadratic& l, const Quadratic& n) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    return std::int64_t{l[i]} * n[k] - std::int64_t{l[k]} * n[i];
  };
  return {static_cast<std::int32_t>(minor(1, 0) >> 30), static_cast<std::int32_t>(minor(2, 0) >> 29),
          static_cast<std::int32_t>(minor(2, 1) >> 30)};
}

// The polar form of degree `n` with one of its points given: of degree n - 1 in the others.
template <std::size_t N>
void fix_point(std::array<std::int32_t, N>& c, std::size_t n, std::int32_t tau) {
  for (std::size_t i = 0; i < n; ++i) c[i] += times(c[i + 1], tau);
}

}  // namespace

// The sizes of terms add up to at most 1/2 in L and in each N_i: light and normal may be scaled at will. So those of a wronskian add up to
// 1/2 and w's to 3/4. A term is off by 2 units, 1 of the block's and 1 of its cut; a wronskian's by 3, 5 and 3, the 1 of its own cut counted; w's
// by less than 26 and 5 cuts in sum, and w by 4 products more. The polar form's terms are off by as much but for 14 of their quotients'
// cuts, and it by 15 products' more.
QuotientRidge::QuotientRidge(const QuotientLine& line) : tau_shift_(30 - line.half_bits) {
  const Terms light(line.l, line.half_bits);
  const Terms normal[] = {{line.n[0], line.half_bits}, {line.n[1], line.half_bits}, {line.n[2], line.half_bits}};
  const int least = line.error_bits + 2;
  const Quadratic l = light.cut(std::max(light.bits() - 29, least));
  const int shift = std::max(std::max({normal[0].bits(), normal[1].bits(), normal[2].bits()}) - 29, least);
  std::array<std::int64_t, 5> sum{};
  for (const Terms& terms : normal) {
    const Quadratic n = terms.cut(shift);
    const Quadratic rise = wronskian(l, n);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum[i + k] += std::int64_t{n[i]} * rise[k];
    }
  }
  static constexpr std::int32_t binomials[] = {1, 4, 6, 4, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    w_[i] = static_cast<std::int32_t>(sum[i] >> 30);
    polar_[i] = w_[i] / binomials[i];
  }
}

auto QuotientRidge::at(std::int32_t t) const -> Dot {
  Dot dot{static_cast<std::int32_t>(static_cast<std::uint32_t>(t) << tau_shift_), w_[4]};
  for (std::size_t i = 4; i-- > 0;) dot.w = w_[i] + times(dot.w, dot.tau);
  return dot;
}

// The polar form at a four times, three times and so on.
Course QuotientRidge::course(const Dot& a, const Dot& b) const {
  std::array<int, 5> signs{a.sign(), 0, 0, 0, b.sign()};
  Quartic at_a = polar_;
  for (std::size_t of_b = 3; of_b > 0; --of_b) {
    fix_point(at_a, of_b + 1, a.tau);
    Quartic mixed = at_a;
    for (std::size_t n = of_b; n > 0; --n) fix_point(mixed, n, b.tau);
    signs[of_b] = mixed[0] > polar_error ? 1 : mixed[0] < -polar_error ? -1 : 0;
  }
  return course_of(signs);
}

}  // namespace halfspace
