// Lines and conics in every width and branch against exact roots: for every line the first dots at and right of the root.
#include "firmware/core/arc.hpp"

#include <gtest/gtest.h>

#include "firmware/core/engine.hpp"
#include "firmware/core/memory_source.hpp"
#include "host/job/job_bytes.hpp"
#include "host/job/job_writer.hpp"
#include "host/job/limits.hpp"
#include "tests/core/numbers.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

using Coefficients = std::array<mpz_class, 6>;

constexpr std::int32_t x_min = 3, x_max = 70;

// Is x (local) at or right of the root on line y, or strictly right of it? w = 2 A x + B against -+sqrt(B^2 - 4 A C).
bool is_right(const Coefficients& q, Branch branch, long x, long y, bool strictly) {
  const mpz_class b = q[1] * y + q[3];
  const mpz_class c = (q[2] * y + q[4]) * y + q[5];
  if (branch == Branch::single) return strictly ? b * x + c > 0 : b * x + c >= 0;
  const mpz_class w = 2 * q[0] * x + b;
  const mpz_class above = w * w - (b * b - 4 * q[0] * c);
  if (branch == Branch::left) return strictly ? w > 0 || above < 0 : w >= 0 || above <= 0;
  return strictly ? w > 0 && above > 0 : w >= 0 && above >= 0;
}

bool has_root(const Coefficients& q, Branch branch, long y) {
  const mpz_class b = q[1] * y + q[3];
  if (branch == Branch::single) return q[0] == 0 && b > 0;
  return q[0] > 0 && b * b - 4 * q[0] * ((q[2] * y + q[4]) * y + q[5]) >= 0;
}

std::int32_t first_dot(const Coefficients& q, Branch branch, std::int32_t origin_x, long y, bool strictly) {
  std::int32_t x = x_min;
  while (x <= x_max && !is_right(q, branch, x - origin_x, y, strictly)) ++x;
  return x;
}

struct Setting {
  Coefficients q;
  Branch branch;
  std::int32_t origin_x, origin_y;
};

// The narrowest kind for the arc, as the job writer chooses it.
std::optional<ArcKind> kind_of(const Setting& s) {
  IntegerScene scene;
  scene.scissor = {x_min, 0, x_max, 99};
  scene.bodies.resize(1);
  scene.bodies[0].origin = {s.origin_x, s.origin_y, 0};
  Arc arc;
  arc.form = Curve{s.q};
  return arc_kind(scene, arc);
}

// Follows the arc over all its lines from y0 in the given kind.
void expect_crossings(const Setting& s, ArcKind kind, std::int32_t y0, std::int32_t y1, std::int32_t start_x) {
  JobBytes out;
  const bool line = kind <= ArcKind::line256;
  if (!line) out.number(static_cast<int>(s.branch));
  for (std::size_t i = line ? 3 : 0; i < 6; ++i) out.wide(s.q[i]);
  const std::vector<std::uint8_t> bytes = out.take();
  MemorySource source(bytes);
  JobReader in(source);
  const ArcModule& module = *all_modules.arcs[static_cast<std::size_t>(kind)];
  std::vector<std::uint64_t> state(static_cast<std::size_t>(module.bytes) / 8 + 1);
  module.load(in, {s.origin_x, s.origin_y, start_x, y0, y1, x_min, x_max}, state.data());
  ASSERT_FALSE(in.failed());
  for (std::int32_t y = y0;; ++y) {
    const ArcCrossing crossing = y == y0 ? module.settle(state.data()) : module.next(state.data());
    ASSERT_EQ(crossing.at_or_right, first_dot(s.q, s.branch, s.origin_x, y - s.origin_y, false)) << "line " << y;
    ASSERT_EQ(crossing.right, first_dot(s.q, s.branch, s.origin_x, y - s.origin_y, true)) << "line " << y;
    if (y == y1) break;
  }
}

// Follows every stretch of lines with a root, in the narrowest kind and in all wider ones. Returns the lines followed.
int follow(const Setting& s, Dice& dice) {
  const std::optional<ArcKind> narrowest = kind_of(s);
  if (!narrowest) return 0;
  const int family = *narrowest <= ArcKind::line256 ? 3 : 6;
  int lines = 0;
  for (std::int32_t y0 = 0; y0 < 100; ++y0) {
    if (!has_root(s.q, s.branch, y0 - s.origin_y)) continue;
    std::int32_t y1 = y0;
    while (y1 < 99 && has_root(s.q, s.branch, y1 + 1 - s.origin_y)) ++y1;
    for (int kind = static_cast<int>(*narrowest); kind < family; ++kind) {
      expect_crossings(s, static_cast<ArcKind>(kind), y0, y1,
                       static_cast<std::int32_t>(between(dice, x_min, x_max + 1)));
      if (::testing::Test::HasFatalFailure()) return lines;
    }
    lines += y1 - y0 + 1;
    y0 = y1;
  }
  return lines;
}

Setting place(const Coefficients& q, Branch branch, Dice& dice) {
  return {q, branch, static_cast<std::int32_t>(between(dice, -20, 90)),
          static_cast<std::int32_t>(between(dice, -20, 120))};
}

TEST(Arc, LinesSteepShallowAndNearlyLevel) {
  Dice dice(30);
  int lines = 0;
  for (int trial = 0; trial < testing::trials(400); ++trial) {
    const int bits = std::array{6, 40, 100, 200}[trial % 4];
    Coefficients q;
    q[3] = abs(random_bits(dice, trial % 3 == 0 ? 2 : bits)) + 1;
    q[4] = random_bits(dice, trial % 5 == 0 ? 2 : bits);
    q[5] = random_bits(dice, bits + 5);
    if (trial % 3 == 1) q[5] = q[3] * static_cast<long>(between(dice, -50, 50));  // through dots: ties
    lines += follow(place(q, Branch::single, dice), dice);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial << ": " << q[3] << " x + " << q[4] << " y + " << q[5];
  }
  EXPECT_GT(lines, testing::trials(10000));
}

TEST(Arc, ConicsOfEveryBranchAndWidth) {
  Dice dice(31);
  std::array<int, 3> lines{};
  for (int trial = 0; trial < testing::trials(1200); ++trial) {
    const auto branch = static_cast<Branch>(trial % 3);
    const int bits = std::array{5, 30, 90, 220}[trial / 3 % 4];
    Coefficients q;
    // About the middle of the page: the highest degrees are the smaller ones.
    for (int i = 0; i < 6; ++i) q[i] = random_bits(dice, bits + (i < 3 ? 0 : i < 5 ? 6 : 12));
    q[0] = branch == Branch::single ? mpz_class(0) : mpz_class(abs(q[0]) + 1);
    lines[static_cast<std::size_t>(trial % 3)] += follow(place(q, branch, dice), dice);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial << " branch " << trial % 3;
  }
  for (const int n : lines) EXPECT_GT(n, testing::trials(3000));
}

TEST(Arc, CirclesDoubleLinesAndTies) {
  Dice dice(32);
  const Coefficients curves[] = {
      {1, 0, 1, 0, 0, -625},      // a circle through many dots (7, 24, 25)
      {1, 0, 1, 0, 0, 0},         // a point
      {1, 4, 4, 0, 0, 0},         // a double line: both roots equal on every line
      {1, 0, 0, -6, 0, 9},        // upright, double
      {1, 0, -1, 0, 0, 0},        // two lines that cross on a dot
      {2, 0, -1000000, 0, 0, 1},  // nearly level
      {1000000, 0, -2, 0, 0, 1},  // nearly upright
      {1, 0, 0, 0, -1, 0},        // a parabola from its tip
  };
  int lines = 0;
  for (const Coefficients& q : curves) {
    for (const Branch branch : {Branch::left, Branch::right}) {
      for (int i = 0; i < testing::trials(32); ++i) {
        lines += follow(place(q, branch, dice), dice);
        ASSERT_FALSE(HasFatalFailure()) << q[0] << " " << q[1] << " " << q[2] << " " << q[5];
      }
    }
  }
  EXPECT_GT(lines, testing::trials(10000));
}

}  // namespace
}  // namespace halfspace
