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
        for (int y = 0; y < cell_side; ++y) inked += std::popcount(rows[static_cast<std::size_t>(y * levels + k)]);
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

TEST(Stipple, EdgesAreWhereALineChanges) {
  for (const Screen screen : screens) {
    for (const std::int32_t levels : {2, 3, 17, 31, 32, 33, 65, 256}) {
      const auto rows = patterns_of(screen, levels);
      std::vector<std::uint32_t> words(edge_words(levels) * cell_side);
      find_edges(levels, rows, words);
      for (std::size_t y = 0; y < cell_side; ++y) {
        const PatternRow* row = rows.data() + y * static_cast<std::size_t>(levels);
        const LevelEdges edges(words.data() + y * edge_words(levels));
        const auto is_edge = [&](std::int32_t k) { return k == 0 || k == levels || row[k] != row[k - 1]; };
        for (std::int32_t k = 0; k <= levels; ++k) {
          std::int32_t up = k;
          while (!is_edge(up)) ++up;
          ASSERT_EQ(edges.from(k), up) << "level " << k << " of " << levels << " line " << y;
          std::int32_t down = k;
          while (!is_edge(down)) --down;
          ASSERT_EQ(edges.to(k), down) << "level " << k << " of " << levels << " line " << y;
        }
      }
    }
  }
}

TEST(Stipple, ADarkerPatternContainsEveryLighterOne) {
  for (const Screen screen : screens) {
    for (const std::int32_t levels : {2, 3, 17, 65, 256}) {
      const auto rows = patterns_of(screen, levels);
      const auto n = static_cast<std::size_t>(levels);
      for (std::size_t y = 0; y < cell_side; ++y) {
        for (std::size_t k = 1; k < n; ++k) ASSERT_EQ(rows[y * n + k] & ~rows[y * n + k - 1], 0);
        ASSERT_EQ(rows[y * n], 0xffff) << "level 0 is black";
        ASSERT_EQ(rows[y * n + n - 1], 0) << "the highest level is white";
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

// Rows of a page under test: level k of 256 has the pattern 257 k, and a gray dot its level.
std::vector<PatternRow> same_on_every_line(const Page& page) {
  std::vector<PatternRow> rows(static_cast<std::size_t>(page.levels) * cell_side);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = tones[i % static_cast<std::size_t>(page.levels)];
  return rows;
}

// What a band shows at dot x where a row has the level.
unsigned shown(const Page& page, std::int32_t x, std::int32_t level) {
  return page.format == DotFormat::gray ? static_cast<unsigned>(level)
                                        : static_cast<unsigned>(level) >> (7 - x % 8) & 1U;
}
unsigned dot_of(const Page& page, const std::vector<std::uint8_t>& bytes, std::int32_t x) {
  if (page.format == DotFormat::gray) return bytes[static_cast<std::size_t>(x)];
  return bytes[static_cast<std::size_t>(x / 8)] >> (7 - x % 8) & 1U;
}

constexpr Page bilevel_page{101, 1, DotFormat::bilevel, 256, 0x35};
constexpr Page gray_page{101, 1, DotFormat::gray, 256, 0x35};

TEST(RowPainter, FillsTheSameDotsAsOneByOne) {
  for (const Page& page : {bilevel_page, gray_page}) {
    const auto rows = same_on_every_line(page);
    std::vector<std::uint32_t> words(row_words(page) + 1, 0x12345678);
    std::vector<std::uint8_t> bytes(page.row_bytes());
    RowPainter painter(page, std::span(words).first(row_words(page)), rows);
    for (std::int32_t x0 = 0; x0 < page.width; ++x0) {
      for (std::int32_t x1 = x0; x1 < page.width; ++x1) {
        painter.begin(0);
        painter.fill(x0, x1, 0xc9);
        painter.copy_to(bytes);
        for (std::int32_t x = 0; x < page.width; ++x) {
          const std::int32_t level = x < x0 || x > x1 ? page.background : 0xc9;
          ASSERT_EQ(dot_of(page, bytes, x), shown(page, x, level)) << x0 << ".." << x1 << " at " << x;
        }
        ASSERT_EQ(words.back(), 0x12345678U) << "the word behind the row";
      }
    }
  }
}

// Runs of one dot and of several words, none at all, and two changes at one dot.
TEST(RunPainter, PaintsTheSameDotsAsFills) {
  constexpr std::array<std::int32_t, 16> steps{1, 0, 2, 31, 1, 0, 0, 33, 1, 1, 64, 3, 0, 96, 5, 2};
  for (const DotFormat format : {DotFormat::bilevel, DotFormat::gray}) {
    const Page page{400, 1, format, 256, 0x35};
    const auto rows = same_on_every_line(page);
    std::vector<std::uint32_t> words(row_words(page));
    std::vector<std::uint8_t> bytes(page.row_bytes());
    RowPainter painter(page, words, rows);
    for (std::int32_t x0 = 0; x0 < 70; ++x0) {
      for (std::size_t first = 0; first < steps.size(); ++first) {
        std::vector<std::int32_t> levels(static_cast<std::size_t>(page.width), page.background);
        const auto take = [&levels](std::int32_t x, std::int32_t end, std::int32_t level) {
          for (; x < end; ++x) levels[static_cast<std::size_t>(x)] = level;
        };
        painter.begin(0);
        RunPainter run(painter, x0, 7);
        std::int32_t x = x0;
        std::int32_t level = 7;
        for (std::size_t i = 0; i < steps.size(); ++i) {
          const std::int32_t next = x + steps[(first + i) % steps.size()];
          take(x, next, level);
          x = next;
          level = static_cast<std::int32_t>(37 * i + first) % 256;
          run.change(x, level);
        }
        run.end(x + 2);
        take(x, x + 3, level);
        painter.copy_to(bytes);
        for (std::int32_t dot = 0; dot < page.width; ++dot) {
          ASSERT_EQ(dot_of(page, bytes, dot), shown(page, dot, levels[static_cast<std::size_t>(dot)]))
              << "from " << x0 << " by " << first << " at " << dot;
        }
      }
    }
  }
}

TEST(RowPainter, CopiesLeftmostDotFirstAndClearsSpareBits) {
  for (std::int32_t width = 1; width <= 100; ++width) {
    const Page page{width, 1, DotFormat::bilevel, 256, 0xff};
    const auto rows = same_on_every_line(page);
    std::vector<std::uint32_t> words(row_words(page));
    std::vector<std::uint8_t> bytes(page.row_bytes(), 0xaa);
    RowPainter painter(page, words, rows);
    painter.begin(0);
    if (width > 1) painter.fill(1, 1, 0);  // dot 1 is paper
    painter.copy_to(bytes);
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
