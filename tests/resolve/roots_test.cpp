// Roots on a scan line, and the lines between which roots lie, where equality is the hard case.
#include <gtest/gtest.h>

#include <algorithm>

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
