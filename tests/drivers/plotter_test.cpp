// Versatec and Varian drivers against the simulated plotters: every dot arrives, no rule is broken, and each fault at
// each place, lasting each time, ends as it should, with the next page whole.
#include "sim/plotter.hpp"

#include <gtest/gtest.h>

#include "drivers/varian.hpp"
#include "drivers/versatec.hpp"
#include "sim/simulated_clock.hpp"
#include "tests/drivers/pages.hpp"

namespace halfspace {
namespace {

template <typename Driver, typename Plotter>
struct Rig {
  SimulatedClock clock;
  Plotter plotter;
  Driver driver{plotter, clock};

  void expect_printed(const PaperSheet& sheet) {
    plotter.close();
    EXPECT_TRUE(plotter.violations().empty())
        << plotter.violations()[0].what << " at byte " << plotter.violations()[0].offset;
    ASSERT_FALSE(plotter.pages().empty());
    EXPECT_TRUE(plotter.pages().back() == padded(sheet, driver.traits().max_width));
  }
};

template <typename R>
class Plotters : public testing::Test {};
using Rigs = testing::Types<Rig<VersatecDriver, SimulatedVersatec>, Rig<VarianDriver, SimulatedVarian>>;
TYPED_TEST_SUITE(Plotters, Rigs);

PaperSheet page(std::int32_t width, std::int32_t height) {
  return noise(width, height, DotFormat::bilevel, 2, static_cast<unsigned>(width * 1000 + height));
}

TYPED_TEST(Plotters, PrintPagesOfAnyWidthInBandsOfAnyHeight) {
  for (const std::int32_t width : {1, 7, 8, 9, 63, 64, 65, 1000, 2111, 2112}) {
    for (std::int32_t band_rows = 1; band_rows <= 40; ++band_rows) {
      TypeParam rig;
      const PaperSheet sheet = page(width, 39);
      ASSERT_EQ(draw(rig.driver, sheet, band_rows), DeviceStatus::ok);
      EXPECT_EQ(rig.plotter.pages().size(), 1U);
      rig.expect_printed(sheet);
    }
  }
}

TYPED_TEST(Plotters, PrintTheFullWidth) {
  TypeParam rig;
  const PaperSheet sheet = page(rig.driver.traits().max_width, 101);
  ASSERT_EQ(draw(rig.driver, sheet, rig.driver.traits().preferred_band_rows), DeviceStatus::ok);
  rig.expect_printed(sheet);
}

TYPED_TEST(Plotters, RefuseAWiderPage) {
  TypeParam rig;
  EXPECT_EQ(draw(rig.driver, page(rig.driver.traits().max_width + 1, 1), 1), DeviceStatus::too_large);
  EXPECT_EQ(rig.plotter.calls(), 0U);
}

TYPED_TEST(Plotters, CarryPartialLinesAcrossWrites) {
  for (const std::size_t limit : {2U, 6U, 262U, 264U, 266U, 878U, 882U, 4096U}) {
    TypeParam rig;
    rig.plotter.limit_transfer(limit);
    const PaperSheet sheet = page(999, 23);
    ASSERT_EQ(draw(rig.driver, sheet, 4), DeviceStatus::ok);
    rig.expect_printed(sheet);
  }
}

TYPED_TEST(Plotters, PrintOnePageAfterAnother) {
  TypeParam rig;
  for (const std::int32_t height : {1, 5, 2}) {
    const PaperSheet sheet = page(300, height);
    ASSERT_EQ(draw(rig.driver, sheet, 2), DeviceStatus::ok);
    rig.expect_printed(sheet);
  }
  EXPECT_EQ(rig.plotter.pages().size(), 3U);
}

TYPED_TEST(Plotters, LeaveNothingBehindWhenAborted) {
  TypeParam rig;
  const PaperSheet sheet = page(2112, 90);
  ASSERT_EQ(rig.driver.begin_page(page_of(sheet)), DeviceStatus::ok);
  ASSERT_EQ(rig.driver.put_band({0, 70, std::span(sheet.dots).first(70 * sheet.row_bytes())}), DeviceStatus::ok);
  rig.driver.abort();
  rig.plotter.close();
  EXPECT_TRUE(rig.plotter.violations().empty());
  ASSERT_EQ(draw(rig.driver, sheet, 7), DeviceStatus::ok);
  rig.expect_printed(sheet);
}

constexpr std::size_t patience = driver_patience_ms;  // one pause is a millisecond to the simulated clock

DeviceStatus expected(DeviceStatus fault, std::size_t at_call, std::size_t calls, std::size_t calls_of_page) {
  if (at_call >= calls_of_page) return DeviceStatus::ok;
  if (fault != DeviceStatus::busy) return fault;
  return calls <= patience ? DeviceStatus::ok : DeviceStatus::timeout;
}

// fault x place x persistence. The place runs over every call that the page makes, and one beyond.
TYPED_TEST(Plotters, SurviveEveryFaultEverywhere) {
  const PaperSheet sheet = page(2112, 9);
  TypeParam reference;
  reference.plotter.limit_transfer(1000);
  ASSERT_EQ(draw(reference.driver, sheet, 4), DeviceStatus::ok);
  const std::size_t calls_of_page = reference.plotter.calls();
  ASSERT_GT(calls_of_page, 6U);

  for (const DeviceStatus fault :
       {DeviceStatus::busy, DeviceStatus::offline, DeviceStatus::no_paper, DeviceStatus::io}) {
    for (std::size_t at_call = 0; at_call <= calls_of_page; ++at_call) {
      for (const std::size_t calls : {std::size_t{1}, std::size_t{5}, patience, patience + 1, Fault::forever}) {
        TypeParam rig;
        rig.plotter.limit_transfer(1000);
        rig.plotter.set_fault({fault, at_call, calls});
        ASSERT_EQ(draw(rig.driver, sheet, 4), expected(fault, at_call, calls, calls_of_page))
            << describe(fault) << ", at call " << at_call << ", for " << calls;
        rig.plotter.set_fault({});
        ASSERT_EQ(draw(rig.driver, sheet, 4), DeviceStatus::ok) << describe(fault) << ", at call " << at_call;
        rig.expect_printed(sheet);
      }
    }
  }
}

TYPED_TEST(Plotters, ReportTheEndOfThePaperAtEveryLine) {
  const PaperSheet sheet = page(640, 80);
  for (std::size_t lines = 0; lines <= 81; ++lines) {
    TypeParam rig;
    rig.plotter.limit_paper(lines);
    ASSERT_EQ(draw(rig.driver, sheet, 8), lines < 80 ? DeviceStatus::no_paper : DeviceStatus::ok);
    rig.plotter.limit_paper(SIZE_MAX);
    ASSERT_EQ(draw(rig.driver, sheet, 8), DeviceStatus::ok);
    rig.expect_printed(sheet);
  }
}

}  // namespace
}  // namespace halfspace
