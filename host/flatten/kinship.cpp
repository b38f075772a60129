#include "host/flatten/kinship.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/flatten/matrix.hpp"
#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

using Rationals = std::array<mpq_class, 10>;

// Of the leading rows and columns of a quadric's matrix, by elimination.
std::size_t rank_of(const Rationals& c, std::size_t size) {
  std::array<std::array<mpq_class, 4>, 4> m;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) m[i][j] = c[quadric_index[i][j]];
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = rank;
    while (pivot < size && sgn(m[pivot][column]) == 0) ++pivot;
    if (pivot == size) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < size; ++i) {
      const mpq_class factor = m[i][column] / m[rank][column];
      for (std::size_t j = column; j < size; ++j) m[i][j] -= factor * m[rank][j];
    }
    ++rank;
  }
  return rank;
}

Real ratio_of(const mpq_class& v) { return to_real(v.get_num()) / to_real(v.get_den()); }

}  // namespace

std::vector<Kinship> kinships_of(std::span<const QuadricStatement> quadrics) {
  std::map<std::vector<mpq_class>, std::size_t> families, parallels;
  std::vector<Kinship> result;
  for (const QuadricStatement& statement : quadrics) {
    Rationals c;
    std::transform(statement.coefficients.begin(), statement.coefficients.end(), c.begin(),
                   [](const Number& number) { return decimal_to_rational(number.text); });
    Kinship kin;
    const auto first = std::find_if(c.begin(), c.end() - 1, [](const mpq_class& v) { return sgn(v) != 0; });
    if (first != c.end() - 1) {
      std::vector<mpq_class> common;
      for (std::size_t i = 0; i < 9; ++i) common.push_back(c[i] / *first);
      kin.family = families.emplace(common, families.size()).first->second;
      kin.ratio = ratio_of(*first);
      kin.constant = ratio_of(c[9] / *first);
      kin.squares = rank_of(c, 3);
      kin.rank = rank_of(c, 4);
      common.resize(6);
      if (kin.squares > 0) kin.parallel = parallels.emplace(common, parallels.size()).first->second;
    }
    result.push_back(kin);
  }
  return result;
}

}  // namespace halfspace
