#include "host/resolve/pencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host/flatten/interval.hpp"

namespace halfspace {
namespace {

constexpr int most_cuts = 64;  // each halves the interval at least; spheres a dot apart need about ten
constexpr std::size_t most_bits =
    256;  // of a ratio: what is left lies closer together than integers of the flattener can say

template <typename Number>
using Vector = std::array<Number, 4>;
template <typename Number>
using Symmetric = std::array<std::array<Number, 4>, 4>;
using Matrix = Symmetric<mpz_class>;

Matrix matrix_of(const IntegerHalfSpace& quadric) {
  const auto& c = quadric.c;
  return {{{c[0], c[3], c[5], c[6]}, {c[3], c[1], c[4], c[7]}, {c[5], c[4], c[2], c[8]}, {c[6], c[7], c[8], c[9]}}};
}

// m q - l p
Matrix combined(const mpz_class& m, const Matrix& q, const mpz_class& l, const Matrix& p) {
  Matrix s;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) s[i][j] = m * q[i][j] - l * p[i][j];
  }
  return s;
}

// Squares

bool has_rank_one_by(const Matrix& s, std::size_t pivot) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) {
      if (s[i][j] * s[pivot][pivot] != s[pivot][i] * s[pivot][j]) return false;
    }
  }
  return true;
}

// The linear form whose square s is a multiple of.
std::optional<std::array<mpz_class, 4>> square_root(const Matrix& s) {
  for (std::size_t pivot = 0; pivot < 4; ++pivot) {
    if (sgn(s[pivot][pivot]) == 0) continue;
    if (!has_rank_one_by(s, pivot)) return std::nullopt;
    return s[pivot];
  }
  return std::nullopt;
}

ConstantSign sign_with(const std::array<mpz_class, 4>& form) {
  ConstantSign result;
  if (std::all_of(form.begin(), form.begin() + 3, [](const mpz_class& c) { return sgn(c) == 0; })) return result;
  IntegerHalfSpace& plane = result.touching.emplace();
  std::copy(form.begin(), form.end(), plane.c.begin());
  return result;
}

// Any coefficient that cancels in a square is one of the ten.
std::optional<ConstantSign> sign_by_square(const Matrix& p, const Matrix& q) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) {
      if (sgn(p[i][j]) == 0) continue;
      if (const auto form = square_root(combined(p[i][j], q, q[i][j], p))) return sign_with(*form);
    }
  }
  return std::nullopt;
}

// Semidefinite members

int sign_of(const mpz_class& v) { return sgn(v); }
int sign_of(double v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }

template <typename Number>
Number product(const Vector<Number>& u, const Vector<Number>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] + u[3] * v[3];
}

template <typename Number>
Vector<Number> image(const Symmetric<Number>& s, const Vector<Number>& v) {
  return {product(s[0], v), product(s[1], v), product(s[2], v), product(s[3], v)};
}

template <typename Number>
Number value_at(const Symmetric<Number>& s, const Vector<Number>& v) {
  return product(image(s, v), v);
}

// Only a vector's direction counts.
void shorten(Vector<mpz_class>& v) {
  const mpz_class divisor = gcd(gcd(v[0], v[1]), gcd(v[2], v[3]));
  if (divisor <= 1) return;
  for (mpz_class& x : v) x /= divisor;
}
void shorten(Vector<double>& v) {
  const double size = std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]) + std::abs(v[3]);
  for (double& x : v) x /= size;
}

// m u - n v
template <typename Number>
Vector<Number> combined(const Number& m, const Vector<Number>& u, const Number& n, const Vector<Number>& v) {
  Vector<Number> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = m * u[i] - n * v[i];
  shorten(result);
  return result;
}

// Of vectors with the value 0 (u - mixed v has the value -2 mixed^2).
template <typename Number>
std::optional<Vector<Number>> witness_among(const Symmetric<Number>& s, const std::vector<Vector<Number>>& zeros) {
  for (const Vector<Number>& u : zeros) {
    for (const Vector<Number>& v : zeros) {
      const Number mixed = product(image(s, u), v);
      if (sign_of(mixed) != 0) return combined<Number>(1, u, mixed, v);
    }
  }
  const auto is_finite = [](const Vector<Number>& v) { return sign_of(v[3]) != 0; };
  const auto finite = std::find_if(zeros.begin(), zeros.end(), is_finite);
  if (finite == zeros.end()) return std::nullopt;
  return *finite;
}

// A vector with a negative value, or a finite point with the value 0. None: s is positive in all of finite space.
// Lagrange's reduction to squares, by a basis that becomes orthogonal. In doubles the answer is a guess, to be checked.
template <typename Number>
std::optional<Vector<Number>> witness_against(const Symmetric<Number>& s) {
  std::vector<Vector<Number>> rest{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  while (!rest.empty()) {
    std::vector<Number> values(rest.size());
    std::transform(rest.begin(), rest.end(), values.begin(), [&](const Vector<Number>& v) { return value_at(s, v); });
    const auto least = std::min_element(values.begin(), values.end());
    if (sign_of(*least) < 0) return rest[static_cast<std::size_t>(least - values.begin())];
    const auto most = std::max_element(values.begin(), values.end());
    if (sign_of(*most) == 0) return witness_among(s, rest);
    const auto pivot = rest.begin() + (most - values.begin());
    const Vector<Number> square = *pivot;
    const Vector<Number> polar = image(s, square);
    rest.erase(pivot);
    for (Vector<Number>& v : rest) v = combined<Number>(*most, v, product(polar, v), square);
  }
  return std::nullopt;
}

std::size_t bits_of(const mpz_class& v) { return mpz_sizeinbase(v.get_mpz_t(), 2); }

// The ratios t that are still possible.
class Ratios {
 public:
  // From all witnesses so far: t < bound, or t > bound.
  // False: that was known.
  bool cut_above(const mpq_class& bound) {
    if (high_ && bound >= *high_) return false;
    high_ = bound;
    return true;
  }
  bool cut_below(const mpq_class& bound) {
    if (low_ && bound <= *low_) return false;
    low_ = bound;
    return true;
  }
  // The same for matrices that are scaled otherwise.
  void multiply_by_power_of_two(long exponent) {
    for (auto* bound : {&low_, &high_}) {
      if (!*bound) continue;
      if (exponent >= 0) {
        **bound <<= static_cast<unsigned long>(exponent);
      } else {
        **bound >>= static_cast<unsigned long>(-exponent);
      }
    }
  }
  [[nodiscard]] bool empty() const { return low_ && high_ && *low_ >= *high_; }

  // Near the middle; where there is no end yet, twice as far out each time. Always a short number, for a witness has
  // several times the digits of its t.
  mpq_class next() {
    if (low_ && high_) return short_number((*low_ + *high_) / 2, (*high_ - *low_) / 8);
    step_ *= 2;
    if (low_) return short_number(*low_, 1) + step_;
    return high_ ? mpq_class(short_number(*high_, 1) - step_) : mpq_class(0);
  }

 private:
  // A multiple of a power of two that is at most `grain`, nearest below v.
  static mpq_class short_number(const mpq_class& v, const mpq_class& grain) {
    const auto bits = static_cast<long>(bits_of(grain.get_num())) - static_cast<long>(bits_of(grain.get_den())) - 1;
    mpq_class unit = 1;
    if (bits >= 0) {
      unit <<= static_cast<unsigned long>(bits);
    } else {
      unit >>= static_cast<unsigned long>(-bits);
    }
    const mpq_class count = v / unit;
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), count.get_num_mpz_t(), count.get_den_mpz_t());
    return whole * unit;
  }

  std::optional<mpq_class> low_, high_;
  mpq_class step_ = 1;
};

// The cuts in intervals

// A matrix divided by 2^exponent, so that entries are at most 1.
struct Enclosed {
  long exponent = 0;
  Symmetric<Interval> intervals;
  Symmetric<double> middles;
};

Enclosed enclosed(const Matrix& s) {
  std::size_t bits = 0;
  for (const auto& row : s) {
    for (const mpz_class& v : row) bits = std::max(bits, bits_of(v));
  }
  Enclosed result{static_cast<long>(bits), {}, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Interval entry = enclosure(s[i][j], result.exponent);
      result.intervals[i][j] = entry;
      result.middles[i][j] = (entry.low + entry.high) / 2;
    }
  }
  return result;
}

Interval value_at(const Symmetric<Interval>& s, const Vector<double>& v) {
  const auto exactly = [](double x) { return Interval{x, x}; };
  Interval total;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) total = total + s[i][j] * exactly(v[i]) * exactly(v[j]);
  }
  return total;
}

// Cuts off ratios for which q - t p is certain not to be positive, as far as doubles can tell. Any vector may be a witness, so
// those found in doubles do, if their cuts are rounded outward.
Ratios ratios_left(const Enclosed& p, const Enclosed& q) {
  constexpr double most = 0x1p100;  // keeps the products of intervals finite
  Ratios ratios;
  for (int cuts = 0; cuts < most_cuts && !ratios.empty(); ++cuts) {
    const double t = ratios.next().get_d();
    Symmetric<double> s;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) s[i][j] = q.middles[i][j] - t * p.middles[i][j];
    }
    const auto witness = witness_against(s);
    const auto is_large = [](double x) { return !(std::abs(x) < most); };
    if (!witness || std::any_of(witness->begin(), witness->end(), is_large)) break;
    const Interval slope = value_at(p.intervals, *witness);
    const Interval value = value_at(q.intervals, *witness);
    if (slope.may_vanish()) break;
    const Interval bound = slope.positive() ? value / slope : -value / -slope;
    if (is_large(bound.low) || is_large(bound.high)) break;
    if (!(slope.positive() ? ratios.cut_above(bound.high) : ratios.cut_below(bound.low))) break;
  }
  return ratios;
}

// Is q - t p positive in all of finite space for some t? A witness v against one t says that q(v) > t p(v) must hold.
bool has_positive_member(const Matrix& p, const Matrix& q) {
  const Enclosed near_p = enclosed(p);
  const Enclosed near_q = enclosed(q);
  Ratios ratios = ratios_left(near_p, near_q);
  ratios.multiply_by_power_of_two(near_q.exponent - near_p.exponent);
  for (int cuts = 0; cuts < most_cuts && !ratios.empty(); ++cuts) {
    const mpq_class t = ratios.next();
    if (bits_of(t.get_num()) > most_bits || bits_of(t.get_den()) > most_bits) return false;
    const auto witness = witness_against(combined(t.get_den(), q, t.get_num(), p));
    if (!witness) return true;
    const mpz_class slope = value_at(p, *witness);
    if (sgn(slope) == 0) return false;
    mpq_class bound(value_at(q, *witness), slope);
    bound.canonicalize();
    if (sgn(slope) > 0) {
      ratios.cut_above(bound);
    } else {
      ratios.cut_below(bound);
    }
  }
  return false;
}

Matrix negative(Matrix s) {
  for (auto& row : s) {
    for (mpz_class& v : row) v = -v;
  }
  return s;
}

}  // namespace

std::optional<ConstantSign> constant_sign(const IntegerHalfSpace& on, const IntegerHalfSpace& value) {
  const Matrix p = matrix_of(on);
  const Matrix q = matrix_of(value);
  if (auto sign = sign_by_square(p, q)) return sign;
  if (has_positive_member(p, q) || has_positive_member(p, negative(q))) return ConstantSign{};
  return std::nullopt;
}

}  // namespace halfspace
