// Roots on a scan line, and the lines between which roots lie, where equality is the hard case.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "host/resolve/line_root.hpp"
#include "host/resolve/root_marks.hpp"
#include "tests/resolve/body_maker.hpp"

namespace halfspace::test {
namespace {

TEST(LineRoot, EqualNumbersWrittenDifferentlyAreEqual) {
  const LineRoot a = real_roots({-1, -2, 1})[1];     // 1 + sqrt(2)
  const LineRoot b = real_roots({-49, -98, 49})[1];  // the same, times 49
  const LineRoot c = real_roots({-2, 0, 1})[1];      // sqrt(2)
  EXPECT_EQ(compare(a, b), 0);
  EXPECT_EQ(compare(b, a), 0);
  EXPECT_EQ(compare(a, c), 1);
  EXPECT_EQ(compare(c, a), -1);
  EXPECT_EQ(compare(real_roots({-9, 0, 1})[0], rational_root(3, -1)), 0);
}

// Against the definition: the sign of a polynomial at a rational says on which side of its roots the rational lies.
TEST(LineRoot, OrderOfCloseRootsFollowsThePolynomials) {
  const mpz_class big = mpz_class(1) << 90;
  const LineRoot a = real_roots({-2 * big * big, 0, 1})[1];      // sqrt(2) 2^90
  const LineRoot b = real_roots({-2 * big * big - 1, 0, 1})[1];  // larger by about 2^-92
  EXPECT_EQ(compare(a, b), -1);
  EXPECT_EQ(compare(b, a), 1);
  const LineRoot middle = rational_between(a, b);
  EXPECT_EQ(compare(a, middle), -1);
  EXPECT_EQ(compare(middle, b), -1);
}

// (x - r) (x - s) and its multiples vanish at both roots; what is a hair off does not.
TEST(LineRoot, SignsAtRootsOfSecondOrder) {
  const mpz_class big = mpz_class(1) << 80;
  for (const int sign : {-1, 1}) {
    const Polynomial f{-2 * big * big * sign, 0, sign};  // +-sqrt(2) 2^80
    const std::vector<LineRoot> roots = real_roots(f);
    EXPECT_EQ(sign_at(times(f, {7, -3, 5}), roots[0]), 0);
    EXPECT_EQ(sign_at(minus(times(f, {7, -3, 5}), {0, 1}), roots[0]), 1);
    EXPECT_EQ(sign_at(minus(times(f, {7, -3, 5}), {0, 1}), roots[1]), -1);
    EXPECT_EQ(sign_at(plus(times(f, {0, 0, 1}), {-1}), roots[1]), -1);
    EXPECT_EQ(sign_at(plus(times(f, f), {0, 0, 0, 0, 0}), roots[1]), 0);
  }
  const LineRoot close = real_roots({-2 * big * big - 1, 0, 1})[1];
  EXPECT_EQ(sign_at({-2 * big * big, 0, 1}, close), 1);
  EXPECT_EQ(sign_at({-2 * big * big - 2, 0, 1}, close), -1);
  const LineRoot low = real_roots({big * big - 1, -2 * big, 1})[0];  // 2^80 - 1, and 2^80 + 1
  EXPECT_EQ(sign_at({1 - big, 1}, low), 0);
  EXPECT_EQ(sign_at({-1 - big, 1}, low), -1);
}

TEST(LineRoot, FloorAndCeiling) {
  const std::vector<LineRoot> roots = real_roots({-2, 0, 1});
  EXPECT_EQ(floor_of(roots[0]), -2);
  EXPECT_EQ(ceiling_of(roots[0]), -1);
  EXPECT_EQ(floor_of(roots[1]), 1);
  EXPECT_EQ(ceiling_of(roots[1]), 2);
  const std::vector<LineRoot> whole = real_roots({9, 0, -1});
  EXPECT_EQ(floor_of(whole[0]), -3);
  EXPECT_EQ(ceiling_of(whole[0]), -3);
  EXPECT_EQ(floor_of(whole[1]), 3);
}

// (x^2 - 2)(x^2 - 3): roots in order, equal to those of other polynomials, signs at them.
TEST(LineRoot, OfFourthDegreeAreThoseOfTheFactors) {
  const std::vector<LineRoot> roots = real_roots({6, 0, -5, 0, 1});
  ASSERT_EQ(roots.size(), 4U);
  EXPECT_EQ(compare(roots[2], real_roots({-2, 0, 1})[1]), 0);
  EXPECT_EQ(compare(roots[3], real_roots({-3, 0, 1})[1]), 0);
  EXPECT_EQ(compare(roots[0], real_roots({-3, 0, 1})[0]), 0);
  EXPECT_EQ(compare(roots[2], roots[3]), -1);
  EXPECT_EQ(sign_at({-2, 0, 1}, roots[2]), 0);
  EXPECT_EQ(sign_at({-2, 0, 1}, roots[3]), 1);
  EXPECT_EQ(sign_at({1414213, -1000000}, roots[2]), -1);  // 1.414213 < sqrt(2)
  EXPECT_EQ(sign_at({}, roots[2]), 0);
}

TEST(LineRoot, MultipleRootsOfFourthDegreeAreGivenOnce) {
  EXPECT_EQ(real_roots({4, 0, -4, 0, 1}).size(), 2U);      // (x^2 - 2)^2
  EXPECT_EQ(real_roots({16, -32, 24, -8, 1}).size(), 1U);  // (x - 2)^4
  EXPECT_EQ(real_roots({4, 0, 5, 0, 1}).size(), 0U);
  EXPECT_EQ(real_roots({0, 0, 0, -1, 1}).size(), 2U);  // x^3 (x - 1)
  EXPECT_EQ(floor_of(real_roots({16, -32, 24, -8, 1})[0]), 2);
  EXPECT_EQ(ceiling_of(real_roots({16, -32, 24, -8, 1})[0]), 2);
}

// Roots a 2^-120 apart, far below what doubles can tell.
TEST(LineRoot, CloseRootsOfFourthDegreeAreTold) {
  const mpz_class big = mpz_class(1) << 120;
  const Polynomial close = times({-3 * big, big}, {-3 * big - 1, big});
  const Polynomial f = times(close, {7, 0, 1});
  const std::vector<LineRoot> roots = real_roots(f);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(compare(roots[0], rational_root(3, 1)), 0);
  EXPECT_EQ(compare(roots[1], rational_root(3, 1)), 1);
  EXPECT_EQ(floor_of(roots[1]), 3);
  EXPECT_EQ(ceiling_of(roots[1]), 4);
  const LineRoot middle = rational_between(roots[0], roots[1]);
  EXPECT_EQ(compare(roots[0], middle), -1);
  EXPECT_EQ(compare(middle, roots[1]), -1);
}

// Products of linear factors: all roots, in order, with the sign of a polynomial at each.
TEST(LineRoot, OfProductsAreTheirFactors) {
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    Polynomial f{1};
    std::set<long> twice;
    for (long k = dice.between(1, 4); k > 0; --k) {
      const long root = dice.between(-9, 9);
      twice.insert(root);
      f = times(f, {-root, 2});
    }
    const std::vector<LineRoot> roots = real_roots(f);
    ASSERT_EQ(roots.size(), twice.size());
    std::size_t next = 0;
    for (const long root : twice) {
      EXPECT_EQ(compare(roots[next], rational_root(root, 2)), 0);
      EXPECT_EQ(sign_at({-1, 2}, roots[next]), (root > 1) - (root < 1));
      ++next;
    }
  }
}

TEST(RootMarks, WholeRootsHaveEvenMarks) {
  EXPECT_EQ(root_marks({21, -13, 2}, -9, 9), (std::vector<Mark>{6, 7}));  // (y - 3)(2y - 7)
  EXPECT_EQ(root_marks({25, -20, 4}, -9, 9), (std::vector<Mark>{5}));     // (2y - 5)^2
  EXPECT_EQ(root_marks({9, 6, 1}, -9, 9), (std::vector<Mark>{-6}));       // (y + 3)^2
  EXPECT_EQ(root_marks({1, 2}, -9, 9), (std::vector<Mark>{-1}));          // 2y + 1
  EXPECT_EQ(root_marks({0, -16, 0, 1}, -9, 9), (std::vector<Mark>{-8, 0, 8}));
  EXPECT_EQ(root_marks({0, 0, 0, 0, 7}, -9, 9), (std::vector<Mark>{0}));
}

TEST(RootMarks, NoRootNoMarkFarFromZero) {
  EXPECT_TRUE(root_marks({10, 0, 1}, -9, 9).empty());
  EXPECT_TRUE(root_marks({5}, -9, 9).empty());
  EXPECT_TRUE(root_marks({}, -9, 9).empty());
  EXPECT_TRUE(root_marks({-10, 1}, -9, 9).empty());
}

// Quartics built from their roots, halves among them: no root is missed, and no even mark is invented.
TEST(RootMarks, OfProductsHoldEveryRoot) {
  Dice dice(1);
  for (int i = 0; i < 2000; ++i) {
    Polynomial p{1};
    std::vector<Mark> roots;
    for (int k = 0; k < 4; ++k) {
      const Mark twice = dice.between(-20, 20);
      roots.push_back(twice);
      Polynomial next(p.size() + 1);
      for (std::size_t j = 0; j < p.size(); ++j) {
        next[j] -= p[j] * static_cast<long>(twice);
        next[j + 1] += p[j] * 2;
      }
      p = next;
    }
    const std::vector<Mark> marks = root_marks(p, -10, 10);
    for (const Mark root : roots) EXPECT_NE(std::find(marks.begin(), marks.end(), root), marks.end()) << root;
    for (const Mark mark : marks) {
      if (mark % 2 != 0) continue;
      EXPECT_NE(std::find(roots.begin(), roots.end(), mark), roots.end()) << mark;
    }
  }
}

}  // namespace
}  // namespace halfspace::test
