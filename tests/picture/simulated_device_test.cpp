// Every known device, as a command uses it: by name, a page in bands, the file out.
#include "host/picture/simulated_device.hpp"

#include <gtest/gtest.h>

#include "hal/device_sink.hpp"
#include "host/picture/picture.hpp"
#include "tests/drivers/pages.hpp"
#include "tests/picture/scratch_folder.hpp"

namespace halfspace {
namespace {

class EveryDevice : public testing::TestWithParam<KnownDevice> {};

TEST_P(EveryDevice, ReceivesThePageThatWasDrawn) {
  const DeviceTraits& traits = GetParam().traits;
  for (const std::int32_t width : {1, 13, 64, 127}) {
    const PaperSheet drawn = noise(width, 37, traits.format, traits.format == DotFormat::gray ? 9 : 2, 3);
    const auto simulated = make_simulated_device(GetParam(), page_of(drawn), 100);
    EXPECT_STREQ(simulated->device().traits().name, traits.name);
    ASSERT_EQ(draw(simulated->device(), drawn, traits.preferred_band_rows), DeviceStatus::ok);
    const ReceivedPage received = simulated->sheet();
    ASSERT_TRUE(received.sheet) << received.error;
    EXPECT_TRUE(*received.sheet == drawn);
    EXPECT_FALSE(simulated->raw_bytes().empty());
  }
}

TEST_P(EveryDevice, HasNoSheetOfAPageCutShort) {
  const DeviceTraits& traits = GetParam().traits;
  const PaperSheet drawn = noise(20, 30, traits.format, 2, 3);
  const auto simulated = make_simulated_device(GetParam(), page_of(drawn), 100);
  ASSERT_EQ(simulated->device().begin_page(page_of(drawn)), DeviceStatus::ok);
  ASSERT_EQ(simulated->device().put_band({0, 8, std::span(drawn.dots).first(8 * drawn.row_bytes())}), DeviceStatus::ok);
  simulated->device().abort();
  const ScratchFolder folder;
  EXPECT_FALSE(simulated->sheet().sheet);
  EXPECT_TRUE(write_output(*simulated, 100, folder / "a.png"));
  EXPECT_TRUE(folder.names().empty());
}

TEST_P(EveryDevice, WritesPicturesAndRawBytes) {
  const ScratchFolder folder;
  const PaperSheet drawn = noise(100, 50, GetParam().traits.format, 200, 3);
  const auto simulated = make_simulated_device(GetParam(), page_of(drawn), 100);
  DeviceSink sink(simulated->device(), simulated->clock(), 1000);
  ASSERT_EQ(simulated->device().begin_page(page_of(drawn)), DeviceStatus::ok);
  ASSERT_TRUE(sink.put_band({0, 50, drawn.dots}));
  ASSERT_EQ(simulated->device().end_page(), DeviceStatus::ok);
  ASSERT_EQ(write_output(*simulated, 100, folder / "a.png"), std::nullopt);
  ASSERT_EQ(write_output(*simulated, 100, folder / "a.prn"), std::nullopt);
  EXPECT_EQ(folder.read("a.prn"), simulated->raw_bytes());
  const auto picture = read_picture(folder / "a.png");
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, 100);
  EXPECT_EQ(picture->height, 50);
  EXPECT_EQ(picture->dpi, 100);
}

INSTANTIATE_TEST_SUITE_P(, EveryDevice, testing::ValuesIn(known_devices),
                         [](const auto& device) { return std::string(device.param.traits.name); });

TEST(SimulatedDevice, RawBytesOfAPlotterAreItsLines) {
  const PaperSheet drawn = noise(100, 3, DotFormat::bilevel, 2, 3);
  const auto simulated = make_simulated_device(*find_device("va"), page_of(drawn), 200);
  ASSERT_EQ(draw(simulated->device(), drawn, 1), DeviceStatus::ok);
  EXPECT_EQ(simulated->raw_bytes(), padded(drawn, 2112).dots);
}

TEST(CheckOutputName, RefusesBeforeAnythingIsDrawn) {
  const DeviceTraits& plotter = find_device("versatec")->traits;
  const DeviceTraits& gray = find_device("gray")->traits;
  for (const char* const name :
       {"a.png", "a.tif", "a.pbm", "a.pgm", "a.exr", "a.prn", "a.txt", "a.pwg", "-", "/dev/full"}) {
    EXPECT_EQ(check_output_name(name, plotter), std::nullopt) << name;
  }
  for (const char* const name : {"a.jpg", "a", "", "png", "a.prn.gz"})
    EXPECT_TRUE(check_output_name(name, plotter)) << name;
  EXPECT_TRUE(check_output_name("a.pbm", gray));
}

}  // namespace
}  // namespace halfspace
