#include "host/resolve/segment_sign.hpp"

#include <algorithm>
#include <cmath>

#include "host/resolve/quartic.hpp"

namespace halfspace {
namespace {

using Coefficients = std::array<double, 5>;

// In powers of t.
Coefficients restricted_to(const std::array<double, 15>& p, std::size_t order, double at, double step, double start) {
  Coefficients sum{};
  for (std::size_t i = order + 1; i-- > 0;) {  // Horner's scheme in x
    const std::size_t rest = order - i;
    for (std::size_t k = rest; k > 0; --k) sum[k] = sum[k] * at + sum[k - 1] * step;
    sum[0] *= at;
    Coefficients c{};  // of x^i
    for (std::size_t j = 0; j <= rest; ++j) c[j] = p[quartic_index(i, j)];
    for (std::size_t k = 0; k < rest; ++k) {
      for (std::size_t j = rest; j-- > k;) c[j] += c[j + 1] * start;
    }
    for (std::size_t j = 0; j <= rest; ++j) sum[j] += c[j];
  }
  return sum;
}

// Those of Bernstein on [0, length], each times a positive number.
Coefficients bernstein(Coefficients q, std::size_t order, double length) {
  double power = 1;
  for (std::size_t i = 0; i <= order; ++i) {
    q[i] *= power;
    power *= length;
  }
  std::reverse(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(order) + 1);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = order; j-- > i;) q[j] += q[j + 1];
  }
  return q;
}

// The same with sizes, at its largest: no coefficient of Bernstein's is above 6 times it.
double largest_size(const std::array<double, 15>& p, std::size_t order, double x, double y) {
  double sum = 0;
  for (std::size_t i = order + 1; i-- > 0;) {
    double c = 0;
    for (std::size_t j = order - i + 1; j-- > 0;) c = c * y + std::abs(p[quartic_index(i, j)]);
    sum = sum * x + c;
  }
  return sum;
}

// What signs Bernstein's coefficients have.
struct Signs {
  bool negative = false, unsure = false, positive = false;

  void add(double value, double error) {
    if (value > error) {
      positive = true;
    } else {
      (value < -error ? negative : unsure) = true;
    }
  }
  // Those of all, or 0 for both; nothing where that is not certain.
  [[nodiscard]] std::optional<int> verdict() const {
    if (negative && positive) return 0;
    if (unsure) return std::nullopt;
    return negative ? -1 : 1;
  }
};

}  // namespace

SegmentSign::SegmentSign(const QuarticForm& p) : order_(degree_of(p)) {
  std::size_t bits = 0;
  for (const mpz_class& c : p.q) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
  for (std::size_t i = 0; i < c_.size(); ++i) {
    long own = 0;
    const double mantissa = mpz_get_d_2exp(&own, p.q[i].get_mpz_t());  // truncated: relative error below 2^-52
    c_[i] = std::ldexp(mantissa, static_cast<int>(std::max(own - static_cast<long>(bits), -1000L)));
  }
}

// Rounding  A term passes fewer than 40 roundings of 2^-53, the coefficient's own counted twice: a coefficient of Bernstein's is within 2^-47
//           of the sum of its terms' sizes, which the same steps with sizes give, as near. Coefficients below 2^-1000 are too large by less
//           than that. Where anything overflows no comparison holds.
std::optional<int> SegmentSign::along(double at, double step, double start, double length) const {
  const Coefficients value = bernstein(restricted_to(c_, order_, at, step, start), order_, length);
  const double most =
      6 * largest_size(c_, order_, std::abs(at) + std::abs(step) * length, std::abs(start) + length) * 0x1p-45 +
      0x1p-800;
  Signs quick;
  for (std::size_t i = 0; i <= order_; ++i) quick.add(value[i], most);
  if (const auto sign = quick.verdict()) return sign;
  std::array<double, 15> sizes{};
  std::transform(c_.begin(), c_.end(), sizes.begin(), [](double c) { return std::abs(c); });
  const Coefficients size =
      bernstein(restricted_to(sizes, order_, std::abs(at), std::abs(step), std::abs(start)), order_, length);
  Signs signs;
  for (std::size_t i = 0; i <= order_; ++i) signs.add(value[i], size[i] * 0x1p-46 + 0x1p-800);
  return signs.verdict();
}

}  // namespace halfspace
