// ascii.hpp - the picture as text that a person can read and a program can parse: spans of one level.
//   halfspace spans 1                         format and its version
//   page 512 512 levels 256 background 0      width, height, levels, the level that is left out
//   17 3-9:200 10-10:31                       scan line, then its spans: first dot - last dot : level
//   end 512                                   the page is whole; its height once more
// Spans run left to right without overlap; neighbours differ in level. Dots of the background level are left
// out, and so are scan lines of nothing else.
#pragma once

#include "drivers/byte_writer.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits ascii_traits{.name = "ascii",
                                           .width = 512,
                                           .height = 512,
                                           .max_width = 32767,
                                           .max_height = 32767,
                                           .dots_per_inch = 96,
                                           .format = DotFormat::gray,
                                           .levels = 256,
                                           .paper = Paper::black,
                                           .preferred_band_rows = 16};

class AsciiDriver final : public RasterDevice {
 public:
  AsciiDriver(ByteSink& sink, Clock& clock) : RasterDevice(ascii_traits), writer_(sink, clock) {}

 private:
  DeviceStatus do_begin_page(const Page& page) override;
  DeviceStatus do_put_band(const Band& band) override;
  DeviceStatus do_end_page() override;
  void do_abort() override { writer_.reset(); }

  void put_row(std::int32_t y, std::span<const std::uint8_t> levels);

  ByteWriter writer_;
};

}  // namespace halfspace
