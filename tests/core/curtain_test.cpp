// What a strip hides: ranges of crossings, columns, and the list of what rests.
#include "firmware/core/curtain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "firmware/core/active_list.hpp"
#include "tests/core/numbers.hpp"

namespace halfspace {
namespace {

using testing::between;
using testing::Dice;

// The first dot at or right of one side of a circle about (x, y) of radius r, all in quarters of a dot.
std::int32_t dot_of(std::int64_t x, std::int64_t y, std::int64_t r, bool left, std::int32_t line) {
  const auto is_beyond = [&](std::int64_t dot) {
    const std::int64_t dx = 4 * dot - x;
    const std::int64_t rest = r * r - (4 * line - y) * (4 * line - y);
    return left ? dx >= 0 || dx * dx <= rest : dx >= 0 && dx * dx >= rest;
  };
  std::int32_t dot = 0;
  while (!is_beyond(dot)) ++dot;
  return dot;
}

TEST(CrossingRange, HoldsTheCrossingOnEveryLineOfTheStrip) {
  Dice dice(20);
  int narrow = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::int64_t r = between(dice, 4 * strip_rows, 900);
    const std::int64_t x = between(dice, 1000, 1100);
    const std::int64_t y = between(dice, 1000, 1100);
    const bool left = dice() % 2 == 0;
    const std::int64_t top = (y - r + 3) / 4;
    const auto line = static_cast<std::int32_t>(between(dice, top, (y + r) / 4 - strip_end));
    const auto at = [&](std::int32_t of) { return dot_of(x, y, r, left, line + of); };
    const CrossingRange range = crossing_range(at(0), at(strip_middle), at(strip_end), 0, 1000);
    for (std::int32_t i = 0; i < strip_rows; ++i) {
      ASSERT_GE(at(i), range.low) << "trial " << trial << " line " << i;
      ASSERT_LE(at(i), range.high) << "trial " << trial << " line " << i;
    }
    narrow += range.high - range.low < 2 * strip_rows ? 1 : 0;
  }
  EXPECT_GT(narrow, 1000);
}

TEST(CrossingRange, IsAllOfTheLineWhereTheScissorCutsIt) {
  for (const std::array<std::int32_t, 3>& at :
       {std::array{5, 9, 9}, std::array{9, 5, 9}, std::array{9, 9, 41}, std::array{41, 41, 41}}) {
    const CrossingRange range = crossing_range(at[0], at[1], at[2], 5, 40);
    EXPECT_EQ(range.low, 5);
    EXPECT_EQ(range.high, 41);
  }
}

TEST(Curtain, HidesOnlyWhatCoveredDotsHide) {
  constexpr std::int32_t width = 75;
  constexpr std::int32_t far = 1000;
  Dice dice(21);
  int hidden = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<std::int32_t, Curtain::columns_of(width)> columns{};
    Curtain curtain(columns);
    curtain.open();
    std::array<std::int32_t, width> dots{};
    dots.fill(far);
    for (int i = 0; i < 6; ++i) {
      const auto a = static_cast<std::int32_t>(between(dice, 0, width - 1));
      const auto b = static_cast<std::int32_t>(between(dice, -1, width - 1));
      const auto high = static_cast<std::int32_t>(between(dice, -20, 20));
      curtain.cover(a, b, high - 20, [high](std::int32_t from, std::int32_t to) {
        EXPECT_EQ(to - from, 15);
        return high + (from & 16);
      });
      for (std::int32_t x = a; x <= b; ++x) dots[x] = std::min(dots[x], high + (x & 16));
    }
    for (int i = 0; i < 20; ++i) {
      const auto a = static_cast<std::int32_t>(between(dice, 0, width - 1));
      const auto b = static_cast<std::int32_t>(between(dice, a, width - 1));
      const auto low = static_cast<std::int32_t>(between(dice, -20, 20));
      const auto nearest = [low](std::int32_t from, std::int32_t to) { return low + (from / 16 + to / 16) % 7; };
      if (!curtain.hides(a, b, low, nearest)) continue;
      ++hidden;
      for (std::int32_t x = a; x <= b; ++x) {
        ASSERT_LT(dots[x], nearest(x, x)) << "trial " << trial << " dot " << x;
      }
    }
  }
  EXPECT_GT(hidden, 1000);
}

TEST(ActiveList, KeepsEachSlotOnceAndTheOrderOfThoseAwake) {
  constexpr std::uint16_t slots = 12;
  Dice dice(22);
  std::array<std::uint16_t, slots> words{};
  ActiveList list(words);
  std::vector<std::uint16_t> awake, resting;
  for (int step = 0; step < 20000; ++step) {
    const auto slot = static_cast<std::uint16_t>(between(dice, 0, slots - 1));
    const auto is_slot = [&](std::uint16_t other) { return other == slot; };
    const bool rests = std::find(resting.begin(), resting.end(), slot) != resting.end();
    const bool wakes = std::find(awake.begin(), awake.end(), slot) != awake.end();
    if (rests) {
      ASSERT_TRUE(list.wake(slot));
      std::erase(resting, slot);
      awake.push_back(slot);
    } else if (wakes) {
      list.remove(is_slot);
      std::erase(awake, slot);
    } else {
      ASSERT_FALSE(list.wake(slot));
      list.add(slot);
      awake.push_back(slot);
    }
    if (step % 7 == 0) {
      list.wake_all();
      awake.insert(awake.end(), resting.begin(), resting.end());
      resting.clear();
      const auto odd = [&](std::uint16_t other) { return other % 3 == step % 3; };
      list.rest(0, odd);
      std::copy_if(awake.begin(), awake.end(), std::back_inserter(resting), odd);
      std::erase_if(awake, odd);
      ASSERT_TRUE(std::is_permutation(awake.begin(), awake.end(), list.awake().begin(), list.awake().end()));
      awake.assign(list.awake().begin(), list.awake().end());
    }
    ASSERT_TRUE(std::equal(awake.begin(), awake.end(), list.awake().begin(), list.awake().end()));
    ASSERT_TRUE(std::is_permutation(resting.begin(), resting.end(), list.resting().begin(), list.resting().end()));
  }
}

}  // namespace
}  // namespace halfspace
