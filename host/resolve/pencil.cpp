#include "host/resolve/pencil.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace halfspace {
namespace {

constexpr int most_cuts = 64;  // each halves the interval at least; spheres a dot apart need about ten
constexpr std::size_t most_bits =
    256;  // of a ratio: what is left lies closer together than integers of the flattener can say

using Vector = std::array<mpq_class, 4>;
using Matrix = std::array<std::array<mpz_class, 4>, 4>;

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

mpq_class value_at(const Matrix& s, const Vector& u, const Vector& v) {
  mpq_class total = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) total += s[i][j] * u[i] * v[j];
  }
  return total;
}

// u + factor v
Vector sum(Vector u, const mpq_class& factor, const Vector& v) {
  for (std::size_t i = 0; i < 4; ++i) u[i] += factor * v[i];
  return u;
}

// A vector with a negative value, or a finite point with the value 0. None: s is positive in all of finite space.
// Lagrange's reduction to squares, by a basis that becomes orthogonal.
std::optional<Vector> witness_against(const Matrix& s) {
  std::vector<Vector> rest{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  while (!rest.empty()) {
    for (const Vector& v : rest) {
      if (sgn(value_at(s, v, v)) < 0) return v;
    }
    const auto pivot =
        std::find_if(rest.begin(), rest.end(), [&](const Vector& v) { return sgn(value_at(s, v, v)) > 0; });
    if (pivot == rest.end()) break;
    const Vector square = *pivot;
    const mpq_class own = value_at(s, square, square);
    rest.erase(pivot);
    for (Vector& v : rest) v = sum(v, -value_at(s, square, v) / own, square);
  }
  for (const Vector& u : rest) {
    for (const Vector& v : rest) {
      const mpq_class mixed = value_at(s, u, v);  // (u - mixed v) has the value -2 mixed^2
      if (sgn(mixed) != 0) return sum(u, -mixed, v);
    }
  }
  const auto finite = std::find_if(rest.begin(), rest.end(), [](const Vector& v) { return sgn(v[3]) != 0; });
  if (finite == rest.end()) return std::nullopt;
  return *finite;
}

std::size_t bits_of(const mpz_class& v) { return mpz_sizeinbase(v.get_mpz_t(), 2); }

// The ratios t that are still possible.
class Ratios {
 public:
  // From all witnesses so far: t < bound, or t > bound.
  void cut_above(const mpq_class& bound) {
    if (!high_ || bound < *high_) high_ = bound;
  }
  void cut_below(const mpq_class& bound) {
    if (!low_ || bound > *low_) low_ = bound;
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

// Is q - t p positive in all of finite space for some t? A witness v against one t says that q(v) > t p(v) must hold.
bool has_positive_member(const Matrix& p, const Matrix& q) {
  Ratios ratios;
  for (int cuts = 0; cuts < most_cuts && !ratios.empty(); ++cuts) {
    const mpq_class t = ratios.next();
    if (bits_of(t.get_num()) > most_bits || bits_of(t.get_den()) > most_bits) return false;
    const auto witness = witness_against(combined(t.get_den(), q, t.get_num(), p));
    if (!witness) return true;
    const mpq_class slope = value_at(p, *witness, *witness);
    if (sgn(slope) == 0) return false;
    const mpq_class bound = value_at(q, *witness, *witness) / slope;
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
