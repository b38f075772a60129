// The simulated display: what it refuses, and how addresses walk in its three modes.
#include "sim/ssd1306.hpp"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Step {
  bool data;
  Bytes bytes;
};

TEST(SimulatedSsd1306, NamesEachViolationAndItsByte) {
  struct Case {
    std::size_t offset;
    const char* what;
    std::vector<Step> steps;
  };
  const Case cases[] = {
      {0, "unknown command", {{false, {0x2F}}}},  // scrolling
      {1, "unknown command", {{false, {0xAE, 0xB8}}}},
      {0, "command without all its arguments", {{false, {0x20}}}},
      {2, "command without all its arguments", {{false, {0x20, 0, 0x21, 0}}}},
      {0, "no such addressing mode", {{false, {0x20, 3}}}},
      {0, "window in page addressing mode", {{false, {0x21, 0, 127}}}},
      {2, "window outside the display", {{false, {0x20, 0, 0x21, 0, 128}}}},
      {2, "window outside the display", {{false, {0x20, 0, 0x22, 5, 4}}}},
      {2, "page-mode address in another addressing mode", {{false, {0x20, 1, 0xB0}}}},
      {0, "column outside the display", {{false, {0x18}}}},
      {0, "not the multiplex ratio of 64 lines", {{false, {0xA8, 0x1F}}}},
      {0, "vertical offset", {{false, {0xD3, 1}}}},
      {0, "not the COM pins of a 64-line panel", {{false, {0xDA, 0x02}}}},
      {0, "start line other than 0", {{false, {0x41}}}},
      {0, "display on without the charge pump", {{false, {0xAF}}}},
      {2, "display on before all of its memory is written", {{false, {0x8D, 0x14, 0xAF}}}},
      {130, "data beyond the window", {{false, {0xB1, 0x00}}, {true, Bytes(129)}}},
      {9, "data beyond the window", {{false, {0x20, 0, 0x21, 5, 5, 0x22, 3, 3}}, {true, Bytes(2)}}},
  };
  for (const Case& c : cases) {
    SimulatedSsd1306 display;
    DeviceStatus last = DeviceStatus::ok;
    for (const Step& step : c.steps) last = step.data ? display.data(step.bytes) : display.command(step.bytes);
    EXPECT_EQ(last, DeviceStatus::protocol) << c.what;
    ASSERT_EQ(display.violations().size(), 1U) << c.what;
    EXPECT_EQ(display.violations()[0], (Violation{c.offset, c.what}));
  }
}

Bytes counted(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i + 1);
  return bytes;
}

TEST(SimulatedSsd1306, WalksItsWindowInEachAddressingMode) {
  struct Case {
    Bytes commands;
    std::size_t places[4];  // of the first four bytes, in the memory
  };
  const Case cases[] = {
      {{0x20, 0, 0x21, 10, 11, 0x22, 2, 3}, {2 * 128 + 10, 2 * 128 + 11, 3 * 128 + 10, 3 * 128 + 11}},
      {{0x20, 1, 0x21, 10, 11, 0x22, 2, 3}, {2 * 128 + 10, 3 * 128 + 10, 2 * 128 + 11, 3 * 128 + 11}},
      {{0x20, 2, 0xB5, 0x0A, 0x11}, {5 * 128 + 26, 5 * 128 + 27, 5 * 128 + 28, 5 * 128 + 29}},
  };
  for (const Case& c : cases) {
    SimulatedSsd1306 display;
    ASSERT_EQ(display.command(c.commands), DeviceStatus::ok);
    ASSERT_EQ(display.data(counted(4)), DeviceStatus::ok);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(display.memory()[c.places[i]], i + 1);
  }
}

TEST(SimulatedSsd1306, IsDarkUntilItIsSwitchedOnAndTurnsAsItIsTold) {
  const auto inked = [](const PaperSheet& glass, std::size_t x, std::size_t y) {
    return (glass.dots[y * 16 + x / 8] >> (7 - x % 8) & 1) != 0;
  };
  SimulatedSsd1306 display;
  Bytes memory(1024);
  memory[3 * 128 + 5] = 2;  // column 5, line 25
  ASSERT_EQ(display.command(Bytes{0x8D, 0x14, 0x20, 0, 0x21, 0, 127, 0x22, 0, 7}), DeviceStatus::ok);
  ASSERT_EQ(display.data(memory), DeviceStatus::ok);
  EXPECT_TRUE(inked(display.glass(), 122, 38));
  ASSERT_EQ(display.command(Bytes{0xAF}), DeviceStatus::ok);
  EXPECT_FALSE(inked(display.glass(), 122, 38));  // as it powers up: upside down on the module
  EXPECT_TRUE(inked(display.glass(), 5, 25));
  ASSERT_EQ(display.command(Bytes{0xA1, 0xC8}), DeviceStatus::ok);
  EXPECT_FALSE(inked(display.glass(), 5, 25));
  EXPECT_TRUE(inked(display.glass(), 6, 25));
  ASSERT_EQ(display.command(Bytes{0xA7}), DeviceStatus::ok);
  EXPECT_TRUE(inked(display.glass(), 5, 25));
  EXPECT_FALSE(inked(display.glass(), 6, 25));
  ASSERT_EQ(display.command(Bytes{0xA5}), DeviceStatus::ok);
  EXPECT_FALSE(inked(display.glass(), 5, 25));
  ASSERT_EQ(display.command(Bytes{0xAE}), DeviceStatus::ok);
  EXPECT_TRUE(inked(display.glass(), 5, 25));
}

}  // namespace
}  // namespace halfspace
