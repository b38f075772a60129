#include "host/flatten/kinship.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "host/flatten/matrix.hpp"
#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

// A quadric's decimals, times one power of ten.
std::array<mpz_class, 10> whole_quadric(const QuadricStatement& statement) {
  std::array<mpz_class, 10> whole;
  long least = 0;
  std::array<Decimal, 10> decimals;
  for (std::size_t i = 0; i < 10; ++i) {
    decimals[i] = decimal_of(statement.coefficients[i].text);
    if (decimals[i].digits != 0) least = std::min(least, decimals[i].exponent);
  }
  for (std::size_t i = 0; i < 10; ++i) {
    if (decimals[i].digits == 0) continue;
    const long shift = decimals[i].exponent - least;
    whole[i] = shift == 0 ? std::move(decimals[i].digits) : mpz_class(decimals[i].digits * power_of_ten(shift));
  }
  return whole;
}

// What is not 0 modulo a prime is not 0.
constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

std::uint64_t product_modulo(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>(Bits128{a} * b % prime);
}

// Do the leading rows and columns of a quadric's matrix have full rank modulo the prime? Then they have it, and nearly always the reverse.
bool is_regular_modulo(const std::array<std::uint64_t, 10>& c, std::size_t size) {
  std::array<std::array<std::uint64_t, 4>, 4> m{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) m[i][j] = c[quadric_index[i][j]];
  }
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    while (pivot < size && m[pivot][k] == 0) ++pivot;
    if (pivot == size) return false;
    std::swap(m[pivot], m[k]);
    for (std::size_t i = k + 1; i < size; ++i) {
      for (std::size_t j = k + 1; j < size; ++j) {
        m[i][j] = (product_modulo(m[k][k], m[i][j]) + prime - product_modulo(m[i][k], m[k][j])) % prime;
      }
    }
  }
  return true;
}

// By elimination without fractions (Bareiss): every quotient is whole.
std::size_t rank_by_elimination(const std::array<mpz_class, 10>& c, std::size_t size) {
  std::array<std::array<mpz_class, 4>, 4> m;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) m[i][j] = c[quadric_index[i][j]];
  }
  std::size_t rank = 0;
  mpz_class former = 1;
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = rank;
    while (pivot < size && sgn(m[pivot][column]) == 0) ++pivot;
    if (pivot == size) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < size; ++i) {
      for (std::size_t j = column + 1; j < size; ++j) {
        m[i][j] = (m[rank][column] * m[i][j] - m[i][column] * m[rank][j]) / former;
      }
    }
    former = m[rank][column];
    ++rank;
  }
  return rank;
}

struct Ranks {
  std::size_t squares, all;
};

Ranks ranks_of(const std::array<mpz_class, 10>& c) {
  std::array<std::uint64_t, 10> rest{};
  std::transform(c.begin(), c.end(), rest.begin(),
                 [](const mpz_class& v) { return mpz_fdiv_ui(v.get_mpz_t(), prime); });
  const auto rank_of = [&](std::size_t size) {
    return is_regular_modulo(rest, size) ? size : rank_by_elimination(c, size);
  };
  return {rank_of(3), rank_of(4)};
}

// The first `count` coefficients' proportions: without their common factor, the first that is not 0 positive.
std::vector<mpz_class> proportions(const std::array<mpz_class, 10>& c, std::size_t count) {
  std::vector<mpz_class> result(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(count));
  mpz_class common = 0;
  for (const mpz_class& v : result) {
    common = gcd(common, v);
    if (common == 1) break;
  }
  const auto first = std::find_if(result.begin(), result.end(), [](const mpz_class& v) { return sgn(v) != 0; });
  if (sgn(*first) < 0) common = -common;
  if (common == 1) return result;
  for (mpz_class& v : result) mpz_divexact(v.get_mpz_t(), v.get_mpz_t(), common.get_mpz_t());
  return result;
}

Real ratio_of(const mpz_class& a, const mpz_class& b) {
  const mpz_class common = gcd(a, b);
  const mpz_class numerator = sgn(b) < 0 ? mpz_class(-a / common) : mpz_class(a / common);
  return to_real(numerator) / to_real(abs(b) / common);
}

}  // namespace

std::vector<Kinship> kinships_of(std::span<const QuadricStatement> quadrics) {
  std::map<std::vector<mpz_class>, std::size_t> families, parallels;
  std::vector<Kinship> result;
  for (const QuadricStatement& statement : quadrics) {
    const std::array<mpz_class, 10> c = whole_quadric(statement);
    Kinship kin;
    const auto first = std::find_if(c.begin(), c.end() - 1, [](const mpz_class& v) { return sgn(v) != 0; });
    if (first != c.end() - 1) {
      kin.family = families.emplace(proportions(c, 9), families.size()).first->second;
      kin.constant = ratio_of(c[9], *first);
      const Ranks ranks = ranks_of(c);
      kin.squares = ranks.squares;
      kin.rank = ranks.all;
      if (kin.squares > 0) kin.parallel = parallels.emplace(proportions(c, 6), parallels.size()).first->second;
    }
    result.push_back(kin);
  }
  return result;
}

}  // namespace halfspace
