// Spans of one scan line against a z-buffer that asks GMP at every dot.
#include "firmware/core/span_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/faces.hpp"

namespace halfspace {
namespace {

using namespace testing;

constexpr std::int32_t side = 64;
constexpr std::int32_t y = 31;

struct Interval {
  std::uint16_t face;
  std::int32_t x0, x1;
};

struct Line {
  std::vector<TestFace> faces;
  std::vector<Interval> intervals;  // by first dot

  [[nodiscard]] std::vector<ActiveFace> active() const {
    std::vector<ActiveFace> list;
    for (const TestFace& f : faces) list.push_back(f.active);
    return list;
  }
};

Line random_line(Dice& dice) {
  const Lighting lighting;
  Line line;
  const auto count = between(dice, 1, 12);
  for (std::uint32_t i = 0; i < count; ++i) {
    TestFace face = solid_face(dice, between(dice, 0, side), 31 + between(dice, -9, 9), between(dice, 3, 40), lighting);
    if (dice() % 3 == 0) face = random_face(dice, FaceKind::plane, 6, lighting);
    if (i > 0 && dice() % 4 == 0) face = line.faces[i - 1];  // a coincident face
    face.active.order = (i * 7 + 3) % 13;
    for (const DotRun& run : runs_of(face, y, side)) {
      const auto x0 = static_cast<std::int32_t>(between(dice, run.x0, run.x1));
      const auto x1 = static_cast<std::int32_t>(between(dice, x0, run.x1));
      line.intervals.push_back({static_cast<std::uint16_t>(i), x0, x1});
    }
    line.faces.push_back(face);
  }
  std::stable_sort(line.intervals.begin(), line.intervals.end(),
                   [](const Interval& a, const Interval& b) { return a.x0 < b.x0; });
  return line;
}

// The face of every dot, no_slot for background.
std::vector<std::uint16_t> nearest(const Line& line) {
  std::vector<std::uint16_t> dots(side, no_slot);
  for (std::int32_t x = 0; x < side; ++x) {
    std::uint16_t& best = dots[static_cast<std::size_t>(x)];
    for (const Interval& i : line.intervals) {
      if (x < i.x0 || x > i.x1) continue;
      if (best == no_slot) {
        best = i.face;
        continue;
      }
      const TestFace& f = line.faces[i.face];
      const TestFace& g = line.faces[best];
      const int sign = testing::compare(*testing::depth_at(f, x, y), *testing::depth_at(g, x, y));
      if (sign < 0 || (sign == 0 && f.active.order < g.active.order)) best = i.face;
    }
  }
  return dots;
}

struct Merged {
  bool fits = true;
  std::int32_t used = 0;
  std::vector<std::uint16_t> dots = std::vector<std::uint16_t>(side, no_slot);
};

Merged merge(const Line& line, std::size_t pool_size) {
  std::vector<Span> pool(pool_size);
  std::vector<ActiveFace> faces = line.active();
  Counters counters;
  SpanList list(pool, faces, exact_1152, counters);
  Merged merged;
  for (int round = 0; round < 2; ++round) {  // a list is used again for the next line
    list.clear(y);
    for (const Interval& i : line.intervals) merged.fits = merged.fits && list.insert(i.face, i.x0, i.x1);
  }
  merged.used = list.used();
  if (!merged.fits) return merged;
  std::int32_t end = -1;
  for (std::uint16_t i = list.first(); i != no_slot; i = list.at(i).next) {
    const Span& span = list.at(i);
    EXPECT_GT(span.x0, end) << "spans are in order and disjoint";
    EXPECT_LE(span.x0, span.x1);
    for (std::int32_t x = span.x0; x <= span.x1; ++x) merged.dots[static_cast<std::size_t>(x)] = span.face;
    end = span.x1;
  }
  return merged;
}

// Dots of coincident faces of one order may go to either: compare what the viewer sees.
void expect_same(const Line& line, const std::vector<std::uint16_t>& dots, const std::vector<std::uint16_t>& expected) {
  for (std::size_t x = 0; x < side; ++x) {
    ASSERT_EQ(dots[x] == no_slot, expected[x] == no_slot) << "dot " << x;
    if (dots[x] == no_slot) continue;
    ASSERT_EQ(line.faces[dots[x]].active.order, line.faces[expected[x]].active.order) << "dot " << x;
  }
}

TEST(SpanList, ShowsTheNearestFaceOfEveryDot) {
  Dice dice(40);
  for (int trial = 0; trial < 1500; ++trial) {
    const Line line = random_line(dice);
    const Merged merged = merge(line, 512);
    ASSERT_TRUE(merged.fits);
    expect_same(line, merged.dots, nearest(line));
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
}

TEST(SpanList, FitsInWhatItUsedAndFailsWithLess) {
  Dice dice(41);
  for (int trial = 0; trial < 300; ++trial) {
    const Line line = random_line(dice);
    if (line.intervals.empty()) continue;
    const auto used = static_cast<std::size_t>(merge(line, 512).used);
    const Merged tight = merge(line, used);
    ASSERT_TRUE(tight.fits) << "trial " << trial;
    expect_same(line, tight.dots, nearest(line));
    ASSERT_FALSE(merge(line, used - 1).fits) << "trial " << trial;
  }
}

// A comb of planes, each nearer than the one before: spans that were cut away free their slots.
TEST(SpanList, SlotsOfHiddenSpansAreUsedAgain) {
  const Lighting lighting;
  Line line;
  for (std::uint16_t i = 0; i < 50; ++i) {
    std::array<mpz_class, 10> c;
    c[2] = 1;
    c[3] = i;  // z = -i
    line.faces.push_back(make_face(FaceKind::plane, c, {0, 0, 0}, 0, 1, i, lighting));
    line.intervals.push_back({i, 5, 40});
  }
  const Merged merged = merge(line, 2);
  ASSERT_TRUE(merged.fits);
  EXPECT_LE(merged.used, 2);
  EXPECT_EQ(merged.dots[5], 49);
  EXPECT_EQ(merged.dots[4], no_slot);
}

}  // namespace
}  // namespace halfspace
