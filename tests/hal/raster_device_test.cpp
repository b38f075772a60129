// The checks that every raster device inherits: order, contiguity, sizes, and what becomes of a page that fails.
#include "hal/raster_device.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hal/device_sink.hpp"
#include "sim/simulated_clock.hpp"

namespace halfspace {
namespace {

constexpr DeviceTraits small_traits{.name = "small", .width = 16, .height = 4, .max_width = 16, .max_height = 10};
constexpr Page small_page{.width = 12, .height = 4};
constexpr std::array<std::uint8_t, 64> dots{};

// Keeps what reaches it as letters: b(egin) p(ut) e(nd) a(bort).
class Recorder final : public RasterDevice {
 public:
  Recorder() : RasterDevice(small_traits) {}
  std::string calls;
  DeviceStatus answer = DeviceStatus::ok;
  int answers_left = 1000;

 private:
  DeviceStatus note(char letter) {
    calls += letter;
    return answers_left-- > 0 ? answer : DeviceStatus::ok;
  }
  DeviceStatus do_begin_page(const Page&) override { return note('b'); }
  DeviceStatus do_put_band(const Band&) override { return note('p'); }
  DeviceStatus do_end_page() override { return note('e'); }
  void do_abort() override { calls += 'a'; }
};

Band band(std::int32_t y, std::int32_t rows) {
  return {y, rows, std::span(dots).first(static_cast<std::size_t>(rows > 0 ? rows : 0) * 2)};
}

TEST(RasterDevice, TakesAPageInOrder) {
  Recorder device;
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  EXPECT_EQ(device.put_band(band(0, 1)), DeviceStatus::ok);
  EXPECT_EQ(device.put_band(band(1, 3)), DeviceStatus::ok);
  EXPECT_EQ(device.end_page(), DeviceStatus::ok);
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  EXPECT_EQ(device.calls, "bppeb");
}

TEST(RasterDevice, RefusesCallsOutsideAPage) {
  Recorder device;
  EXPECT_EQ(device.put_band(band(0, 1)), DeviceStatus::out_of_order);
  EXPECT_EQ(device.end_page(), DeviceStatus::out_of_order);
  device.abort();
  EXPECT_EQ(device.calls, "");
}

TEST(RasterDevice, RefusesAPageWithinAPage) {
  Recorder device;
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::out_of_order);
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  EXPECT_EQ(device.calls, "bab");
}

TEST(RasterDevice, RefusesPagesThatDoNotSuitIt) {
  struct Case {
    Page page;
    DeviceStatus expected;
  };
  const Case cases[] = {
      {{.width = 16, .height = 10}, DeviceStatus::ok},
      {{.width = 17, .height = 1}, DeviceStatus::too_large},
      {{.width = 1, .height = 11}, DeviceStatus::too_large},
      {{.width = 0, .height = 1}, DeviceStatus::bad_page},
      {{.width = 1, .height = -1}, DeviceStatus::bad_page},
      {{.width = INT32_MAX, .height = INT32_MAX}, DeviceStatus::too_large},
      {{.width = 1, .height = 1, .format = DotFormat::gray}, DeviceStatus::bad_page},
      {{.width = 1, .height = 1, .levels = 1, .background = 0}, DeviceStatus::bad_page},
      {{.width = 1, .height = 1, .levels = 257}, DeviceStatus::bad_page},
      {{.width = 1, .height = 1, .levels = 65, .background = 65}, DeviceStatus::bad_page},
      {{.width = 1, .height = 1, .levels = 65, .background = -1}, DeviceStatus::bad_page},
  };
  for (const Case& c : cases) {
    Recorder device;
    EXPECT_EQ(device.begin_page(c.page), c.expected) << c.page.width << " x " << c.page.height;
    EXPECT_EQ(device.calls, c.expected == DeviceStatus::ok ? "b" : "");
  }
}

TEST(RasterDevice, RefusesBandsOutOfOrderOrOfTheWrongSize) {
  Band short_of_bytes = band(1, 2), with_spare_bytes = band(1, 2);
  short_of_bytes.bytes = std::span(dots).first(3);
  with_spare_bytes.bytes = std::span(dots).first(5);
  struct Case {
    Band second;
    DeviceStatus expected;
  };
  const Case cases[] = {
      {band(1, 2), DeviceStatus::ok},           {band(2, 1), DeviceStatus::out_of_order},  // a gap
      {band(0, 2), DeviceStatus::out_of_order},                                            // an overlap
      {band(1, 4), DeviceStatus::out_of_order},                                            // beyond the page
      {band(1, 0), DeviceStatus::out_of_order}, {band(1, -1), DeviceStatus::out_of_order},
      {short_of_bytes, DeviceStatus::bad_band}, {with_spare_bytes, DeviceStatus::bad_band},
  };
  for (const Case& c : cases) {
    Recorder device;
    ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
    ASSERT_EQ(device.put_band(band(0, 1)), DeviceStatus::ok);
    EXPECT_EQ(device.put_band(c.second), c.expected) << "y " << c.second.y << " rows " << c.second.rows;
    EXPECT_EQ(device.calls, c.expected == DeviceStatus::ok ? "bpp" : "bpa");
  }
}

TEST(RasterDevice, RefusesToEndAPageThatIsNotWhole) {
  Recorder device;
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  ASSERT_EQ(device.put_band(band(0, 3)), DeviceStatus::ok);
  EXPECT_EQ(device.end_page(), DeviceStatus::out_of_order);
  EXPECT_EQ(device.put_band(band(3, 1)), DeviceStatus::out_of_order);
  EXPECT_EQ(device.calls, "bpa");
}

TEST(RasterDevice, BusyKeepsThePage) {
  Recorder device;
  device.answer = DeviceStatus::busy;
  device.answers_left = 1;
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::busy);
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  device.answers_left = 1;
  EXPECT_EQ(device.put_band(band(0, 4)), DeviceStatus::busy);
  EXPECT_EQ(device.put_band(band(0, 4)), DeviceStatus::ok);
  device.answers_left = 1;
  EXPECT_EQ(device.end_page(), DeviceStatus::busy);
  EXPECT_EQ(device.end_page(), DeviceStatus::ok);
  EXPECT_EQ(device.calls, "bbppee");
}

TEST(RasterDevice, AnErrorLosesThePage) {
  Recorder device;
  device.answer = DeviceStatus::io;
  EXPECT_EQ(device.begin_page(small_page), DeviceStatus::io);
  EXPECT_EQ(device.put_band(band(0, 4)), DeviceStatus::out_of_order);
  device.answer = DeviceStatus::ok;
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  device.answer = DeviceStatus::no_paper;
  EXPECT_EQ(device.put_band(band(0, 4)), DeviceStatus::no_paper);
  EXPECT_EQ(device.end_page(), DeviceStatus::out_of_order);
  EXPECT_EQ(device.calls, "babpa");
}

TEST(RasterDevice, AbortEndsAPageOnce) {
  Recorder device;
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  device.abort();
  device.abort();
  EXPECT_EQ(device.put_band(band(0, 1)), DeviceStatus::out_of_order);
  EXPECT_EQ(device.calls, "ba");
}

TEST(DeviceSink, WaitsForABusyDeviceThenGivesUp) {
  Recorder device;
  SimulatedClock clock;
  DeviceSink sink(device, clock, 5);
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  device.answer = DeviceStatus::busy;
  device.answers_left = 5;
  EXPECT_TRUE(sink.put_band(band(0, 2)));
  device.answers_left = 1000;
  EXPECT_FALSE(sink.put_band(band(2, 2)));
  EXPECT_EQ(sink.status(), DeviceStatus::timeout);
  EXPECT_EQ(device.end_page(), DeviceStatus::out_of_order);
}

TEST(DeviceSink, PassesTheReasonOn) {
  Recorder device;
  SimulatedClock clock;
  DeviceSink sink(device, clock, 5);
  ASSERT_EQ(device.begin_page(small_page), DeviceStatus::ok);
  device.answer = DeviceStatus::no_paper;
  EXPECT_FALSE(sink.put_band(band(0, 4)));
  EXPECT_EQ(sink.status(), DeviceStatus::no_paper);
}

class WrappingClock final : public Clock {
 public:
  std::uint32_t now_ms() override { return now_; }
  void pause() override { ++now_; }

 private:
  std::uint32_t now_ = UINT32_MAX - 2;
};

TEST(RetryWhileBusy, KeepsItsDeadlineWhenTheClockWraps) {
  WrappingClock clock;
  int calls = 0;
  const auto never_ready = [&] {
    ++calls;
    return DeviceStatus::busy;
  };
  EXPECT_EQ(retry_while_busy(clock, 10, never_ready), DeviceStatus::timeout);
  EXPECT_EQ(calls, 11);  // at 0, 1 .. 10 ms
}

}  // namespace
}  // namespace halfspace
