#include "host/flatten/kinship.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/flatten/matrix.hpp"
#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

// A quadric's decimals, times one power of ten.
struct WholeQuadric {
  std::array<mpz_class, 10> c;
  long exponent = 0;  // times 10^exponent
};

WholeQuadric whole_quadric(const QuadricStatement& statement) {
  WholeQuadric whole;
  std::array<Decimal, 10> decimals;
  for (std::size_t i = 0; i < 10; ++i) {
    decimals[i] = decimal_of(statement.coefficients[i].text);
    if (decimals[i].digits != 0) whole.exponent = std::min(whole.exponent, decimals[i].exponent);
  }
  for (std::size_t i = 0; i < 10; ++i) {
    if (decimals[i].digits != 0) whole.c[i] = decimals[i].digits * power_of_ten(decimals[i].exponent - whole.exponent);
  }
  return whole;
}

// Of the leading rows and columns of a quadric's matrix, by elimination without fractions (Bareiss): every quotient is whole.
std::size_t rank_of(const std::array<mpz_class, 10>& c, std::size_t size) {
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

// The first `count` coefficients' proportions: without their common factor, the first that is not 0 positive.
std::vector<mpz_class> proportions(const std::array<mpz_class, 10>& c, std::size_t count) {
  std::vector<mpz_class> result(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(count));
  mpz_class common = 0;
  for (const mpz_class& v : result) common = gcd(common, v);
  const auto first = std::find_if(result.begin(), result.end(), [](const mpz_class& v) { return sgn(v) != 0; });
  if (sgn(*first) < 0) common = -common;
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
    const auto [c, exponent] = whole_quadric(statement);
    Kinship kin;
    const auto first = std::find_if(c.begin(), c.end() - 1, [](const mpz_class& v) { return sgn(v) != 0; });
    if (first != c.end() - 1) {
      kin.family = families.emplace(proportions(c, 9), families.size()).first->second;
      kin.ratio = ratio_of(*first, power_of_ten(-exponent));
      kin.constant = ratio_of(c[9], *first);
      kin.squares = rank_of(c, 3);
      kin.rank = rank_of(c, 4);
      if (kin.squares > 0) kin.parallel = parallels.emplace(proportions(c, 6), parallels.size()).first->second;
    }
    result.push_back(kin);
  }
  return result;
}

}  // namespace halfspace
