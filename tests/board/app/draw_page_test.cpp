// The controller's program on the host: what it tells the device, and what it reports, for good and bad jobs.
#include "firmware/app/draw_page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firmware/app/embedded_job.hpp"
#include "firmware/core/memory_source.hpp"
#include "host/job/job_writer.hpp"

namespace halfspace {
namespace {

// Notes every call as a letter: b begin, p band, e end, a abort.
class NotingDevice final : public RasterDevice {
 public:
  explicit NotingDevice(DeviceStatus at_band = DeviceStatus::ok)
      : RasterDevice({.name = "noting", .max_width = 64, .max_height = 64, .preferred_band_rows = 4}),
        at_band_(at_band) {}
  std::string calls;

 private:
  DeviceStatus do_begin_page(const Page&) override {
    calls += 'b';
    return DeviceStatus::ok;
  }
  DeviceStatus do_put_band(const Band&) override {
    calls += 'p';
    return at_band_;
  }
  DeviceStatus do_end_page() override {
    calls += 'e';
    return DeviceStatus::ok;
  }
  void do_abort() override { calls += 'a'; }

  DeviceStatus at_band_;
};

class StillClock final : public Clock {
 public:
  std::uint32_t now_ms() override { return now_; }
  void pause() override { ++now_; }

 private:
  std::uint32_t now_ = 0;
};

class TextSink final : public ByteSink {
 public:
  Accepted write(std::span<const std::uint8_t> bytes) override {
    text.append(bytes.begin(), bytes.end());
    return {DeviceStatus::ok, bytes.size()};
  }
  std::string text;
};

// A page of two levels, 8 scan lines high, that shows nothing.
std::vector<std::uint8_t> empty_job(std::int32_t width) {
  IntegerScene scene;
  scene.width = width;
  scene.height = 8;
  scene.scissor = {0, 0, width - 1, 7};
  JobOptions options;
  options.page = {width, 8, DotFormat::bilevel, 2, 1};
  return write_job(scene, ResolvedScene{}, options).bytes;
}

struct Outcome {
  PageReport report;
  std::string calls;
};

Outcome run(const std::vector<std::uint8_t>& job, DeviceStatus at_band = DeviceStatus::ok) {
  alignas(8) std::array<std::byte, 2048> memory{};
  NotingDevice device(at_band);
  StillClock clock;
  MemorySource source(job);
  const PageReport report = draw_page(source, device, clock, memory, Shader::isqrt, all_modules);
  return {report, device.calls};
}

TEST(DrawPage, DrawsInBandsOfTheDevicesHeight) {
  const Outcome drawn = run(empty_job(16));
  EXPECT_TRUE(drawn.report.ok());
  EXPECT_EQ(drawn.calls, "bppe");
  EXPECT_EQ(drawn.report.drawn.band_rows, 4);
  EXPECT_LE(drawn.report.drawn.need, drawn.report.drawn.have);
}

TEST(DrawPage, RefusesBeforeTheDeviceHearsOfIt) {
  const Outcome refused = run(empty_job(32767));
  EXPECT_EQ(refused.report.drawn.status, DrawStatus::does_not_fit);
  EXPECT_EQ(refused.report.drawn.have, 2048);
  EXPECT_GT(refused.report.drawn.need, 32767 / 8);
  EXPECT_EQ(refused.calls, "");
}

TEST(DrawPage, RefusesWhatIsNoJob) {
  const Outcome refused = run({'H', 'S', 'J', '0'});
  EXPECT_EQ(refused.report.drawn.status, DrawStatus::not_a_job);
  EXPECT_EQ(refused.calls, "");
}

TEST(DrawPage, PassesOnThatThePageIsTooWideForTheDevice) {
  const Outcome refused = run(empty_job(65));
  EXPECT_EQ(refused.report.device, DeviceStatus::too_large);
  EXPECT_FALSE(refused.report.ok());
  EXPECT_EQ(refused.calls, "");
}

TEST(DrawPage, AbortsAJobThatEndsEarly) {
  std::vector<std::uint8_t> job = empty_job(16);
  job.pop_back();
  const Outcome stopped = run(job);
  EXPECT_EQ(stopped.report.drawn.status, DrawStatus::bad_record);
  EXPECT_EQ(stopped.calls, "ba");
}

TEST(DrawPage, ReportsWhatTheDeviceSays) {
  const Outcome stopped = run(empty_job(16), DeviceStatus::no_paper);
  EXPECT_EQ(stopped.report.device, DeviceStatus::no_paper);
  EXPECT_EQ(stopped.report.drawn.status, DrawStatus::stopped);
  EXPECT_EQ(stopped.calls, "bpa");
}

TEST(DrawPage, GivesUpOnADeviceThatStaysBusy) {
  const Outcome stopped = run(empty_job(16), DeviceStatus::busy);
  EXPECT_EQ(stopped.report.device, DeviceStatus::timeout);
  EXPECT_EQ(stopped.calls.front(), 'b');
  EXPECT_EQ(stopped.calls.back(), 'a');
}

TEST(Report, SaysWhatIsWrongAndTheFigures) {
  TextSink sink;
  PageReport report;
  report.drawn.status = DrawStatus::does_not_fit;
  report.drawn.need = 9000;
  report.drawn.have = 2048;
  write_report(sink, report);
  EXPECT_EQ(sink.text.substr(0, sink.text.find('\n')), std::string("status ") + describe(DrawStatus::does_not_fit));
  EXPECT_NE(sink.text.find("\nneed_bytes 9000\nhave_bytes 2048\n"), std::string::npos);
}

}  // namespace
}  // namespace halfspace
