// Halftone: exact densities, nested patterns, whole rank tables, and fills compared dot by dot.
#include "firmware/core/stipple.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <vector>

#include "firmware/core/row_painter.hpp"

namespace halfspace {
namespace {

constexpr std::array screens{Screen::clustered, Screen::bayer, Screen::blue_noise};

std::vector<PatternRow> patterns_of(Screen screen, std::int32_t levels) {
  std::vector<PatternRow> rows(static_cast<std::size_t>(levels * cell_side));
  make_patterns(screen, levels, rows);
  return rows;
}

TEST(Stipple, EveryLevelOfEveryScreenHasItsDensity) {
  for (const Screen screen : screens) {
    for (std::int32_t levels = 2; levels <= 256; ++levels) {
      const auto rows = patterns_of(screen, levels);
      for (std::int32_t k = 0; k < levels; ++k) {
        int inked = 0;
        for (int y = 0; y < cell_side; ++y) inked += std::popcount(rows[static_cast<std::size_t>(k * cell_side + y)]);
        // round(256 (N - 1 - k) / (N - 1)): within half of the quotient, halves up.
        const int twice_error = 2 * inked * (levels - 1) - 2 * cell_dots * (levels - 1 - k);
        ASSERT_LE(twice_error, levels - 1)
            << "screen " << static_cast<int>(screen) << " level " << k << " of " << levels;
        ASSERT_GT(twice_error, -(levels - 1))
            << "screen " << static_cast<int>(screen) << " level " << k << " of " << levels;
      }
    }
  }
}

TEST(Stipple, ADarkerPatternContainsEveryLighterOne) {
  for (const Screen screen : screens) {
    for (const std::int32_t levels : {2, 3, 17, 65, 256}) {
      const auto rows = patterns_of(screen, levels);
      for (std::size_t i = cell_side; i < rows.size(); ++i) ASSERT_EQ(rows[i] & ~rows[i - cell_side], 0);
      for (std::size_t y = 0; y < cell_side; ++y) {
        ASSERT_EQ(rows[y], 0xffff) << "level 0 is black";
        ASSERT_EQ(rows[rows.size() - 1 - y], 0) << "the highest level is white";
      }
    }
  }
}

TEST(Stipple, RanksArePermutationsThatRepeatFromCellToCell) {
  for (const Screen screen : screens) {
    std::bitset<cell_dots> seen;
    for (int y = 0; y < cell_side; ++y) {
      for (int x = 0; x < cell_side; ++x) {
        seen.set(screen_rank(screen, x, y));
        ASSERT_EQ(screen_rank(screen, x, y), screen_rank(screen, x + 16, y + 32));
      }
    }
    EXPECT_TRUE(seen.all()) << static_cast<int>(screen);
  }
}

int inked_neighbours(Screen screen, int x, int y, int inked) {
  int count = 0;
  for (const auto& [dx, dy] : {std::array{1, 0}, {15, 0}, {0, 1}, {0, 15}}) {
    if (screen_rank(screen, x + dx, y + dy) < inked) ++count;
  }
  return count;
}

// Edges between ink and paper in a cell: few where dots grow in clusters, many where they are dispersed.
int boundary(Screen screen, int inked) {
  int edges = 0;
  for (int y = 0; y < cell_side; ++y) {
    for (int x = 0; x < cell_side; ++x) {
      if (screen_rank(screen, x, y) < inked) edges += 4 - inked_neighbours(screen, x, y, inked);
    }
  }
  return edges;
}

TEST(Stipple, ClusteredSpotsGrowTogetherAndDispersedDotsStayApart) {
  for (const int inked : {32, 48, 64, 96, 128}) {
    EXPECT_LE(2 * boundary(Screen::clustered, inked), boundary(Screen::bayer, inked)) << inked;
    EXPECT_LT(boundary(Screen::clustered, inked), boundary(Screen::blue_noise, inked)) << inked;
  }
  // Eight spots of a 45-degree screen: the pattern repeats when moved by (4, 4) in an 8 x 8 cell.
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(screen_rank(Screen::clustered, x, y) < 64, screen_rank(Screen::clustered, x + 4, y + 4) < 64);
    }
  }
}

TEST(Stipple, BlueNoiseHasNoTwoEarlyDotsSideBySide) {
  for (int y = 0; y < cell_side; ++y) {
    for (int x = 0; x < cell_side; ++x) {
      if (screen_rank(Screen::blue_noise, x, y) < 32) {
        EXPECT_EQ(inked_neighbours(Screen::blue_noise, x, y, 32), 0) << x << ", " << y;
      }
      if (screen_rank(Screen::blue_noise, x, y) >= 224) {
        EXPECT_EQ(inked_neighbours(Screen::blue_noise, x, y, 224), 4) << x << ", " << y;
      }
    }
  }
}

TEST(BilevelRow, FillsTheSameDotsAsOneByOne) {
  constexpr PatternRow pattern = 0b1011000111010010;
  constexpr int width = 101;
  for (int x0 = 0; x0 < width; ++x0) {
    for (int x1 = x0; x1 < width; ++x1) {
      for (const std::uint32_t before : {0U, 0xffffffffU}) {
        std::array<std::uint32_t, 5> words;
        words.fill(before);
        BilevelRow(std::span(words).first(4)).fill(x0, x1, pattern);
        for (int x = 0; x < 128; ++x) {
          const bool expected = x < x0 || x > x1 ? before != 0 : (pattern >> (15 - x % 16) & 1) != 0;
          ASSERT_EQ((words[static_cast<std::size_t>(x / 32)] >> (31 - x % 32) & 1) != 0, expected)
              << x0 << ".." << x1 << " at " << x;
        }
        ASSERT_EQ(words[4], before) << "the word behind the row";
      }
    }
  }
}

TEST(BilevelRow, CopiesLeftmostDotFirstAndClearsSpareBits) {
  for (std::int32_t width = 1; width <= 100; ++width) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(width + 31) / 32, 0xffffffffU);
    words[0] ^= 0x40000000U;  // dot 1 is paper
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width + 7) / 8, 0xaa);
    BilevelRow(words).copy_to(bytes, width);
    for (std::size_t x = 0; x < bytes.size() * 8; ++x) {
      const bool inked = x < static_cast<std::size_t>(width) && x != 1;
      ASSERT_EQ((bytes[x / 8] >> (7 - x % 8) & 1) != 0, inked) << "dot " << x << " of " << width;
    }
  }
}

TEST(RowPainter, PaintsTheSameLevelsBilevelAndGray) {
  const Page bilevel{37, 20, DotFormat::bilevel, 65, 64};
  const Page gray{37, 20, DotFormat::gray, 65, 64};
  const auto rows = patterns_of(Screen::bayer, 65);
  std::vector<std::uint32_t> bilevel_words(row_words(bilevel)), gray_words(row_words(gray));
  RowPainter ink(bilevel, bilevel_words, rows);
  RowPainter tone(gray, gray_words, {});
  for (std::int32_t y = 0; y < 20; ++y) {
    for (RowPainter* painter : {&ink, &tone}) {
      painter->begin(y);
      painter->fill(3, 20, 11);
      painter->fill(36, 36, 0);
    }
    std::vector<std::uint8_t> dots(bilevel.row_bytes()), tones(gray.row_bytes());
    ink.copy_to(dots);
    tone.copy_to(tones);
    for (std::int32_t x = 0; x < 37; ++x) {
      const int level = x >= 3 && x <= 20 ? 11 : x == 36 ? 0 : 64;
      ASSERT_EQ(tones[static_cast<std::size_t>(x)], level);
      const bool inked = screen_rank(Screen::bayer, x, y) < inked_dots(level, 65);
      ASSERT_EQ((dots[static_cast<std::size_t>(x / 8)] >> (7 - x % 8) & 1) != 0, inked) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace halfspace
