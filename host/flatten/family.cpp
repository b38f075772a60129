#include "host/flatten/family.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

constexpr int family_bits = 60;

using Rationals = std::array<mpq_class, 10>;

// By elimination.
int rank_of(const Rationals& c) {
  std::array<std::array<mpq_class, 4>, 4> m;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = c[quadric_index[i][j]];
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 4; ++column) {
    std::size_t pivot = rank;
    while (pivot < 4 && sgn(m[pivot][column]) == 0) ++pivot;
    if (pivot == 4) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < 4; ++i) {
      const mpq_class factor = m[i][column] / m[rank][column];
      for (std::size_t j = column; j < 4; ++j) m[i][j] -= factor * m[rank][j];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

Real ratio_of(const mpq_class& v) { return to_real(v.get_num()) / to_real(v.get_den()); }

const FamilyMember& leader_of(std::span<const FamilyMember> members) {
  return *std::min_element(members.begin(), members.end(),
                           [](const FamilyMember& a, const FamilyMember& b) { return a.kin.rank < b.kin.rank; });
}

}  // namespace

std::vector<Kinship> kinships_of(std::span<const QuadricStatement> quadrics) {
  std::map<std::vector<mpq_class>, std::size_t> families;
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
      kin = {families.emplace(common, families.size()).first->second, ratio_of(*first), ratio_of(c[9] / *first),
             rank_of(c)};
    }
    result.push_back(kin);
  }
  return result;
}

std::optional<std::vector<Quantised>> quantise_family(std::span<const FamilyMember> members, const Matrix4& inverse,
                                                      const Box& box) {
  const FamilyMember& leader = leader_of(members);
  // The precision that a member needs may be more than the leader's own.
  for (int bits = 0; bits <= family_bits; bits += 4) {
    const auto first = quantise(leader.shape, inverse, box, bits);
    if (!first) return std::nullopt;
    std::vector<Quantised> all;
    for (const FamilyMember& member : members) {
      const Real apart = leader.kin.ratio * (member.kin.constant - leader.kin.constant);
      if (apart == 0) {
        all.push_back(*first);
      } else if (const auto sibling = quantise_sibling(*first, leader.shape, apart, inverse, box)) {
        all.push_back(*sibling);
      } else {
        break;
      }
      if ((member.kin.ratio < 0) != (leader.kin.ratio < 0)) all.back().form = negated(all.back().form);
    }
    if (all.size() == members.size()) return all;
  }
  return std::nullopt;
}

}  // namespace halfspace
