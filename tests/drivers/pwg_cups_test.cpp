// PWG Raster read back by libcups, which knows nothing of us: header and every dot.
#include <cups/raster.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "drivers/pwg.hpp"
#include "sim/byte_collector.hpp"
#include "sim/simulated_clock.hpp"
#include "tests/drivers/pages.hpp"

namespace halfspace {
namespace {

struct Reader {
  std::span<const std::uint8_t> left;
};

ssize_t read_some(void* context, unsigned char* into, std::size_t size) {
  auto& reader = *static_cast<Reader*>(context);
  const std::size_t count = std::min(size, reader.left.size());
  std::memcpy(into, reader.left.data(), count);
  reader.left = reader.left.subspan(count);
  return static_cast<ssize_t>(count);
}

void expect_cups_reads(const PaperSheet& sheet, std::span<const std::uint8_t> stream) {
  Reader reader{stream};
  const std::unique_ptr<cups_raster_t, decltype(&cupsRasterClose)> raster(
      cupsRasterOpenIO(read_some, &reader, CUPS_RASTER_READ), cupsRasterClose);
  ASSERT_NE(raster, nullptr);
  cups_page_header2_t header{};
  ASSERT_EQ(cupsRasterReadHeader2(raster.get(), &header), 1U);
  EXPECT_STREQ(header.MediaClass, "PwgRaster");
  EXPECT_EQ(header.cupsWidth, static_cast<unsigned>(sheet.width));
  EXPECT_EQ(header.cupsHeight, static_cast<unsigned>(sheet.height));
  EXPECT_EQ(header.cupsBitsPerPixel, 1U);
  EXPECT_EQ(header.cupsColorSpace, CUPS_CSPACE_K);
  EXPECT_EQ(header.HWResolution[0], 300U);
  EXPECT_EQ(header.PageSize[0], (static_cast<unsigned>(sheet.width) * 72 + 150) / 300);
  ASSERT_EQ(header.cupsBytesPerLine, sheet.row_bytes());
  std::vector<std::uint8_t> dots(sheet.dots.size());
  for (std::size_t at = 0; at < dots.size(); at += sheet.row_bytes()) {
    ASSERT_EQ(cupsRasterReadPixels(raster.get(), dots.data() + at, header.cupsBytesPerLine), header.cupsBytesPerLine);
  }
  EXPECT_EQ(dots, sheet.dots);
  EXPECT_EQ(cupsRasterReadHeader2(raster.get(), &header), 0U);
}

TEST(PwgByCups, IsReadDotForDot) {
  for (const std::int32_t width : {1, 8, 9, 1015, 1016, 1024, 1025, 2049, 2550, 32767}) {
    for (const std::int32_t height : {1, 2, 300}) {
      SimulatedClock clock;
      ByteCollector sink;
      PwgDriver driver(sink, clock);
      const PaperSheet sheet = noise(width, height, DotFormat::bilevel, 2, static_cast<unsigned>(width + height));
      ASSERT_EQ(draw(driver, sheet, 16), DeviceStatus::ok);
      expect_cups_reads(sheet, sink.bytes());
    }
  }
}

TEST(PwgByCups, ReadsAnEmptyPage) {
  SimulatedClock clock;
  ByteCollector sink;
  PwgDriver driver(sink, clock);
  PaperSheet sheet{.width = 2550, .height = 3300};
  sheet.dots.resize(3300 * sheet.row_bytes());
  ASSERT_EQ(draw(driver, sheet, 16), DeviceStatus::ok);
  EXPECT_LT(sink.bytes().size(), 1900U);
  expect_cups_reads(sheet, sink.bytes());
}

}  // namespace
}  // namespace halfspace
