// number_test.cpp - every decimal is read to the nearest double and keeps its text; nothing else is a number.
#include "host/scene/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>

namespace halfspace::test {
namespace {

std::string print(double value, std::chars_format format) {
  char buffer[800];
  const auto [end, status] = std::to_chars(std::begin(buffer), std::end(buffer), value, format);
  EXPECT_EQ(status, std::errc{});
  return {buffer, end};
}

bool is_in_range(double value) { return value == 0 || (std::abs(value) >= 1e-308 && std::abs(value) <= 1e308); }

// Of all doubles, by their bits: in range they come back exactly, the others are refused.
TEST(Number, ReadsBackEveryDoubleInRangeAndRefusesTheOthers) {
  const std::uint64_t seed = std::random_device{}();
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    for (const std::chars_format format : {std::chars_format::general, std::chars_format::scientific}) {
      const std::string text = print(value, format);
      const std::variant<Number, std::string> reading = read_number(text);
      ASSERT_EQ(std::holds_alternative<Number>(reading), is_in_range(value)) << text << ", seed " << seed;
      if (!is_in_range(value)) continue;
      ASSERT_EQ(std::get<Number>(reading).text, text) << "seed " << seed;
      ASSERT_EQ(std::get<Number>(reading).value, value) << text << ", seed " << seed;
    }
  }
}

TEST(Number, KeepsDigitsThatADoubleCannotHold) {
  const std::string text = "-0.10000000000000000000000000000000000000001";
  const std::variant<Number, std::string> reading = read_number(text);
  EXPECT_EQ(std::get<Number>(reading).text, text);
  EXPECT_EQ(std::get<Number>(reading).value, -0.1);
}

TEST(Number, DropsAPlusSignAndWritesEveryZeroAlike) {
  EXPECT_EQ(std::get<Number>(read_number("+1.5")).text, "1.5");
  for (const std::string_view zero : {"0", "-0", "+0.", ".000", "0e5", "-0.0E-999999999", "0e99999999999999999999"}) {
    EXPECT_EQ(std::get<Number>(read_number(zero)).text, "0") << zero;
    EXPECT_FALSE(std::signbit(std::get<Number>(read_number(zero)).value)) << zero;
  }
}

TEST(Number, RefusesWhatIsNoDecimal) {
  for (const std::string_view text : {"", "+", "-", ".", "e5", "1e", "1e+", "--1", "+-1", "-+1", "1 ", " 1", "1,5",
                                      "0x1", "nan", "-inf", "1f", "1_000"}) {
    EXPECT_TRUE(std::holds_alternative<std::string>(read_number(text))) << text;
  }
}

}  // namespace
}  // namespace halfspace::test
