// Drivers that write a stream of bytes: small pictures byte by byte, large ones through the strict decoders.
#include <gtest/gtest.h>

#include "drivers/ascii.hpp"
#include "drivers/braille.hpp"
#include "drivers/gray.hpp"
#include "drivers/pwg.hpp"
#include "drivers/template_driver.hpp"
#include "sim/byte_collector.hpp"
#include "sim/decode.hpp"
#include "sim/simulated_clock.hpp"
#include "tests/drivers/pages.hpp"

namespace halfspace {
namespace {

template <typename Driver>
struct Rig {
  SimulatedClock clock;
  ByteCollector sink;
  Driver driver{sink, clock};

  std::string text() const { return {sink.bytes().begin(), sink.bytes().end()}; }
};

PaperSheet bilevel(const std::vector<std::string>& rows) {
  PaperSheet sheet{.width = static_cast<std::int32_t>(rows[0].size()),
                   .height = static_cast<std::int32_t>(rows.size())};
  sheet.dots.resize(rows.size() * sheet.row_bytes());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      if (rows[y][x] == '#') sheet.dots[y * sheet.row_bytes() + x / 8] |= static_cast<std::uint8_t>(0x80 >> x % 8);
    }
  }
  return sheet;
}

Decoded decode(const ByteCollector& sink, const PaperSheet&, const GrayDriver&) { return decode_pgm(sink.bytes()); }
Decoded decode(const ByteCollector& sink, const PaperSheet&, const AsciiDriver&) { return decode_spans(sink.bytes()); }
Decoded decode(const ByteCollector& sink, const PaperSheet& sheet, const BrailleDriver&) {
  return decode_braille(sink.bytes(), sheet.width, sheet.height);
}
Decoded decode(const ByteCollector& sink, const PaperSheet&, const PwgDriver&) { return decode_pwg(sink.bytes()); }

template <typename R>
class Streams : public testing::Test {};
using Rigs = testing::Types<Rig<GrayDriver>, Rig<AsciiDriver>, Rig<BrailleDriver>, Rig<PwgDriver>>;
TYPED_TEST_SUITE(Streams, Rigs);

TYPED_TEST(Streams, DecodeToTheDotsThatWereDrawn) {
  for (const std::int32_t width : {1, 2, 7, 8, 9, 129, 1033, 2049}) {
    for (const std::int32_t height : {1, 3, 4, 5, 21}) {
      for (const std::int32_t band_rows : {1, 2, 3, 4, 7, 21}) {
        TypeParam rig;
        const DeviceTraits& traits = rig.driver.traits();
        const PaperSheet sheet = noise(width, height, traits.format, traits.format == DotFormat::gray ? 17 : 2,
                                       static_cast<unsigned>(width));
        ASSERT_EQ(draw(rig.driver, sheet, band_rows), DeviceStatus::ok);
        const Decoded decoded = decode(rig.sink, sheet, rig.driver);
        ASSERT_TRUE(decoded.sheet) << decoded.violation.what << " at byte " << decoded.violation.offset;
        ASSERT_TRUE(*decoded.sheet == sheet) << width << " x " << height << " by " << band_rows;
      }
    }
  }
}

TYPED_TEST(Streams, SurviveEveryFaultEverywhere) {
  constexpr std::size_t patience = driver_patience_ms;
  TypeParam reference;
  const PaperSheet sheet = noise(200, 40, reference.driver.traits().format, 2, 5);
  reference.sink.limit_transfer(300);
  ASSERT_EQ(draw(reference.driver, sheet, 8), DeviceStatus::ok);
  const std::size_t calls_of_page = reference.sink.calls();
  for (const DeviceStatus fault :
       {DeviceStatus::busy, DeviceStatus::offline, DeviceStatus::io, DeviceStatus::no_paper}) {
    for (std::size_t at_call = 0; at_call <= calls_of_page; ++at_call) {
      for (const std::size_t calls : {std::size_t{1}, patience, patience + 1, Fault::forever}) {
        const bool overcome = at_call == calls_of_page || (fault == DeviceStatus::busy && calls <= patience);
        const DeviceStatus lost = fault == DeviceStatus::busy ? DeviceStatus::timeout : fault;
        TypeParam rig;
        rig.sink.limit_transfer(300);
        rig.sink.set_fault({fault, at_call, calls});
        ASSERT_EQ(draw(rig.driver, sheet, 8), overcome ? DeviceStatus::ok : lost) << at_call << " for " << calls;
        rig.sink.set_fault({});
        rig.sink.clear();
        ASSERT_EQ(draw(rig.driver, sheet, 8), DeviceStatus::ok);
        EXPECT_EQ(rig.sink.bytes(), reference.sink.bytes());
      }
    }
  }
}

TEST(Gray, WritesABinaryPgm) {
  Rig<GrayDriver> rig;
  const PaperSheet sheet{
      .width = 3, .height = 2, .format = DotFormat::gray, .levels = 17, .dots = {'a' - 96, 2, 3, 4, 5, 16}};
  ASSERT_EQ(draw(rig.driver, sheet, 1), DeviceStatus::ok);
  EXPECT_EQ(rig.text(), "P5\n3 2\n16\n\1\2\3\4\5\x10");
}

TEST(Ascii, WritesSpansWithoutTheBackground) {
  Rig<AsciiDriver> rig;
  const PaperSheet sheet{
      .width = 6, .height = 4, .format = DotFormat::gray, .levels = 256, .dots = {0,   0, 0, 0, 0, 0,    //
                                                                                  0,   9, 9, 9, 0, 0,    //
                                                                                  200, 9, 9, 0, 7, 255,  //
                                                                                  0,   0, 0, 0, 0, 1}};
  ASSERT_EQ(draw(rig.driver, sheet, 3), DeviceStatus::ok);
  EXPECT_EQ(rig.text(),
            "halfspace spans 1\n"
            "page 6 4 levels 256 background 0\n"
            "1 1-3:9\n"
            "2 0-0:200 1-2:9 4-4:7 5-5:255\n"
            "3 5-5:1\n"
            "end 4\n");
}

TEST(Braille, RaisesADotWhereThereIsNoInk) {
  Rig<BrailleDriver> rig;
  const PaperSheet sheet = bilevel({"#######",  //
                                    "#.....#",  //
                                    "#.....#",  //
                                    "#######",  //
                                    "....###"});
  ASSERT_EQ(draw(rig.driver, sheet, 2), DeviceStatus::ok);
  EXPECT_EQ(rig.text(), "⠰⠶⠶⠀\n⠉⠉⠀⠀\n");
}

TEST(Pwg, HoldsBackNoMoreThan256EqualLines) {
  Rig<PwgDriver> rig;
  PaperSheet sheet{.width = 16, .height = 600};
  sheet.dots.assign(1200, 0xA5);
  ASSERT_EQ(draw(rig.driver, sheet, 100), DeviceStatus::ok);
  const std::vector<std::uint8_t> body(rig.sink.bytes().begin() + 1800, rig.sink.bytes().end());
  EXPECT_EQ(body, (std::vector<std::uint8_t>{255, 1, 0xA5, 255, 1, 0xA5, 87, 1, 0xA5}));
}

TEST(Template, TakesAPage) {
  TemplateDriver driver;
  EXPECT_EQ(draw(driver, noise(640, 480, DotFormat::bilevel, 2, 1), 8), DeviceStatus::ok);
}

}  // namespace
}  // namespace halfspace
