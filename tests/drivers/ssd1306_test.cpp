#include "drivers/ssd1306.hpp"

#include <gtest/gtest.h>

#include "drivers/write_all.hpp"
#include "sim/simulated_clock.hpp"
#include "sim/ssd1306.hpp"
#include "tests/drivers/pages.hpp"

namespace halfspace {
namespace {

struct Rig {
  SimulatedClock clock;
  SimulatedSsd1306 display;
  Ssd1306Driver driver{display, clock};
};

// The page in the top left corner, the rest dark: ink.
PaperSheet on_glass(const PaperSheet& sheet) {
  PaperSheet glass{.width = 128, .height = 64};
  glass.dots.assign(1024, 0xFF);
  for (std::int32_t y = 0; y < sheet.height; ++y) {
    for (std::int32_t x = 0; x < sheet.width; ++x) {
      const std::size_t from = static_cast<std::size_t>(y) * sheet.row_bytes() + static_cast<std::size_t>(x) / 8;
      const auto bit = static_cast<std::uint8_t>(0x80 >> x % 8);
      if ((sheet.dots[from] & bit) == 0) {
        glass.dots[static_cast<std::size_t>(y * 16 + x / 8)] &= static_cast<std::uint8_t>(~bit);
      }
    }
  }
  return glass;
}

TEST(Ssd1306, ShowsPagesOfAnySizeInBandsOfAnyHeight) {
  for (const std::int32_t width : {1, 7, 8, 9, 100, 127, 128}) {
    for (const std::int32_t height : {1, 7, 8, 9, 33, 63, 64}) {
      for (std::int32_t band_rows = 1; band_rows <= height; ++band_rows) {
        Rig rig;
        const PaperSheet sheet = noise(width, height, DotFormat::bilevel, 2, 7);
        ASSERT_EQ(draw(rig.driver, sheet, band_rows), DeviceStatus::ok);
        ASSERT_TRUE(rig.display.violations().empty()) << rig.display.violations()[0].what;
        ASSERT_EQ(rig.display.glass(), on_glass(sheet)) << width << " x " << height << " by " << band_rows;
      }
    }
  }
}

TEST(Ssd1306, LaysDotsInVerticalBytes) {
  Rig rig;
  PaperSheet sheet{.width = 2, .height = 9};  // all light but (1, 1) and (0, 8)
  sheet.dots = {0, 0x40, 0, 0, 0, 0, 0, 0, 0x80};
  ASSERT_EQ(draw(rig.driver, sheet, 9), DeviceStatus::ok);
  EXPECT_EQ(rig.display.memory()[0], 0xFF);
  EXPECT_EQ(rig.display.memory()[1], 0xFD);
  EXPECT_EQ(rig.display.memory()[2], 0);
  EXPECT_EQ(rig.display.memory()[128], 0);
  EXPECT_EQ(rig.display.memory()[129], 1);
}

TEST(Ssd1306, SurvivesEveryFaultEverywhere) {
  const PaperSheet sheet = noise(128, 64, DotFormat::bilevel, 2, 11);
  constexpr std::size_t calls_of_page = 2 + 8 + 1;
  constexpr std::size_t patience = driver_patience_ms;
  for (const DeviceStatus fault : {DeviceStatus::busy, DeviceStatus::offline, DeviceStatus::io}) {
    for (std::size_t at_call = 0; at_call <= calls_of_page; ++at_call) {
      for (const std::size_t calls : {std::size_t{1}, patience, patience + 1, Fault::forever}) {
        const bool overcome = at_call == calls_of_page || (fault == DeviceStatus::busy && calls <= patience);
        const DeviceStatus lost = fault == DeviceStatus::busy ? DeviceStatus::timeout : fault;
        Rig rig;
        rig.display.set_fault({fault, at_call, calls});
        ASSERT_EQ(draw(rig.driver, sheet, 8), overcome ? DeviceStatus::ok : lost) << at_call << " for " << calls;
        rig.display.set_fault({});
        ASSERT_EQ(draw(rig.driver, sheet, 8), DeviceStatus::ok);
        EXPECT_TRUE(rig.display.violations().empty());
        EXPECT_EQ(rig.display.glass(), on_glass(sheet));
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
