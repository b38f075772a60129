#include "host/resolve/approximate_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "host/resolve/interval_polynomial.hpp"

namespace halfspace {
namespace {

// Up to degree four.
struct Doubles {
  std::array<double, 5> c{};
  std::size_t count = 0;

  void push_back(double value) { c[count++] = value; }
};

double value_at(const Doubles& f, double x) {
  double value = 0;
  for (std::size_t i = f.count; i-- > 0;) value = value * x + f.c[i];
  return value;
}

struct ValueAndSlope {
  double value = 0, slope = 0;
};

ValueAndSlope value_and_slope_at(const Doubles& f, double x) {
  ValueAndSlope at;
  for (std::size_t i = f.count; i-- > 0;) {
    at.slope = at.slope * x + at.value;
    at.value = at.value * x + f.c[i];
  }
  return at;
}

Doubles slope_of(const Doubles& f) {
  Doubles d;
  for (std::size_t i = 1; i < f.count; ++i) d.push_back(f.c[i] * static_cast<double>(i));
  return d;
}

// A sign change in [low, high], by Newton's steps; by halving where one leaves the bracket or is more than half the step before. A step of
// 2^-40 of x leaves no more than rounding does.
double bracketed_root(const Doubles& f, double low, double high, bool rising) {
  constexpr int most_steps = 200;
  double x = low + (high - low) / 2;
  double last_step = high - low;
  for (int i = 0; i < most_steps; ++i) {
    const auto [value, slope] = value_and_slope_at(f, x);
    if (value == 0) return x;
    ((value < 0) == rising ? low : high) = x;
    double next = x - value / slope;
    if (!(next > low && next < high) || std::abs(next - x) > last_step / 2) next = low + (high - low) / 2;
    last_step = std::abs(next - x);
    if (last_step <= std::abs(x) * 0x1p-40) return next;
    x = next;
  }
  return x;
}

Doubles guesses_of_second_order(const Doubles& f) {
  const double d = f.c[1] * f.c[1] - 4 * f.c[2] * f.c[0];
  if (d < 0) return {};
  const double far = -(f.c[1] + std::copysign(std::sqrt(d), f.c[1])) / 2;
  if (far == 0) return {};
  const double x = far / f.c[2];
  const double y = f.c[0] / far;
  return {{std::min(x, y), std::max(x, y)}, 2};
}

// Guesses at the real roots within +-bound: between two extrema a polynomial is monotone.
Doubles guesses(const Doubles& f, double bound) {
  if (f.count == 3) return guesses_of_second_order(f);
  const Doubles turns = guesses(slope_of(f), bound);
  Doubles roots;
  double low = -bound;
  bool below = value_at(f, low) < 0;
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const double high = i < turns.count ? turns.c[i] : bound;
    const bool next_below = value_at(f, high) < 0;
    if (below != next_below) roots.push_back(bracketed_root(f, low, high, below));
    low = high;
    below = next_below;
  }
  return roots;
}

// All real roots are within it: 2 max |a_i / a_n|^(1 / (n - i)) (Fujiwara 1916), the roots rounded up to powers of two. By exponents
// alone, so that no guess, and with it no separator, depends on a libm.
double bound_of_roots(const Doubles& f) {
  const auto order = static_cast<int>(f.count) - 1;
  int most = std::numeric_limits<int>::min();
  for (int i = 0; i < order; ++i) {
    const double ratio = f.c[static_cast<std::size_t>(i)] / f.c[static_cast<std::size_t>(order)];
    if (ratio == 0) continue;
    if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
    const int exponent = std::ilogb(ratio) + 1;
    const int divisor = order - i;
    most = std::max(most, exponent > 0 ? (exponent + divisor - 1) / divisor : exponent / divisor);
  }
  return most < -1000 ? 1 : std::ldexp(2.0, std::min(most, 1000));
}

Interval value_at(const IntervalPolynomial& f, double x) {
  Interval value{};
  for (std::size_t i = f.size; i-- > 0;) value = value * Interval{x, x} + f.c[i];
  return value;
}

bool changes_sign(const IntervalPolynomial& f, const Interval& x) {
  const Interval low = value_at(f, x.low);
  const Interval high = value_at(f, x.high);
  return (low.positive() && high.negative()) || (low.negative() && high.positive());
}

mpz_class multiple(int factor, const mpz_class& a) { return factor * a; }
Interval multiple(int factor, const Interval& a) {
  return Interval{static_cast<double>(factor), static_cast<double>(factor)} * a;
}

std::optional<int> sign_of(const mpz_class& a) { return sgn(a); }
std::optional<int> sign_of(const Interval& a) {
  if (a.may_vanish() && !a.is_zero()) return std::nullopt;
  return a.positive() ? 1 : a.negative() ? -1 : 0;
}

// As count_of_real_roots, of a x^3 + b x^2 + c x + d; nothing where signs are unknown.
template <class Number>
std::optional<int> count_of_third_order(const Number& a, const Number& b, const Number& c, const Number& d) {
  const Number bc = b * c;
  const Number mixed = bc * (multiple(18, a * d) + bc);
  const Number cubes = b * b * b * d + a * c * c * c;
  const Number discriminant = mixed - multiple(4, cubes) - multiple(27, a * a * d * d);
  const auto sign = sign_of(discriminant);
  if (!sign) return std::nullopt;
  return *sign == 0 ? -1 : *sign > 0 ? 3 : 1;
}

// The same of a x^4 + b x^3 + c x^2 + d x + e.
template <class Number>
std::optional<int> count_of_fourth_order(const Number& a, const Number& b, const Number& c, const Number& d,
                                         const Number& e) {
  const Number bb = b * b;
  const Number ac = a * c;
  const Number i = multiple(12, a * e) - multiple(3, b * d) + c * c;
  const Number j =
      multiple(72, ac * e) + multiple(9, b * c * d) - multiple(27, a * d * d + bb * e) - multiple(2, c * c * c);
  const auto discriminant = sign_of(Number(multiple(4, i * i * i) - j * j));
  if (!discriminant) return std::nullopt;
  if (*discriminant <= 0) return *discriminant == 0 ? -1 : 2;
  const auto first = sign_of(Number(multiple(8, ac) - multiple(3, bb)));
  if (first && *first >= 0) return 0;
  const Number aa = a * a;
  const auto second =
      sign_of(Number(multiple(64, aa * a * e) + multiple(16, bb * ac - ac * ac - aa * b * d) - multiple(3, bb * bb)));
  if (second && *second >= 0) return 0;
  if (!first || !second) return std::nullopt;
  return 4;
}

}  // namespace

int count_of_real_roots(const Polynomial& f) {
  const auto count = [order = f.size() - 1](const auto& c) {
    return order == 3 ? count_of_third_order(c[3], c[2], c[1], c[0])
                      : count_of_fourth_order(c[4], c[3], c[2], c[1], c[0]);
  };
  const auto certain = count(enclosed(f).c);
  return certain ? *certain : count(f).value();
}

std::vector<Interval> certain_sign_changes(const Polynomial& f) {
  const IntervalPolynomial near = enclosed(f);
  Doubles rounded;
  for (std::size_t i = 0; i < near.size; ++i) rounded.push_back((near.c[i].low + near.c[i].high) / 2);
  const double bound = bound_of_roots(rounded);
  if (!(bound < 0x1p60)) return {};  // keeps every product in the enclosures finite
  std::vector<Interval> found;
  const Doubles near_roots = guesses(rounded, bound);
  for (std::size_t i = 0; i < near_roots.count; ++i) {
    const double x = near_roots.c[i];
    double radius = std::abs(x) * 0x1p-48 + 0x1p-60;
    for (int attempt = 0; attempt < 6; ++attempt, radius *= 64) {
      const Interval around{x - radius, x + radius};
      if (!found.empty() && !(found.back().high < around.low)) break;
      if (!changes_sign(near, around)) continue;
      found.push_back(around);
      break;
    }
  }
  return found;
}

}  // namespace halfspace
