// What the report says of a Cortex-M3, from rows made up.
#include "host/report/board_summary.hpp"

#include <gtest/gtest.h>

namespace halfspace::test {
namespace {

BoardRow row(int radius, const char* shader, double instructions) {
  BoardRow row;
  row.face = "cone";
  row.shader = shader;
  row.radius = radius;
  row.levels = 17;
  row.face_instructions = instructions;
  return row;
}

TEST(BoardSummary, TellsHowGoodTheChoiceIs) {
  const std::vector<BoardRow> rows{row(500, "auto", 11),   row(500, "contour", 10), row(500, "isqrt", 300),
                                   row(5, "auto", 150),    row(5, "contour", 200),  row(5, "isqrt", 100),
                                   row(20, "contour", 10), row(20, "isqrt", 20)};
  EXPECT_NE(
      board_summary(rows).find("`auto` takes at most a tenth more than the better of `contour` and `isqrt` on 1 of 2 "
                               "pages; at worst 1.50 times as much (cone, radius 5, 17 levels)."),
      std::string::npos)
      << board_summary(rows);
}

TEST(BoardSummary, SaysNothingOfAChoiceThatWasNotMeasured) {
  const std::vector<BoardRow> rows{row(500, "contour", 10), row(500, "isqrt", 300)};
  EXPECT_EQ(board_summary(rows).find("`auto`"), std::string::npos);
}

}  // namespace
}  // namespace halfspace::test
