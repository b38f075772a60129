// gray.hpp - a gray framebuffer after the Vectrix (672 x 480), sent as a binary PGM stream: P5, width,
// height, the highest level as maxval, then one byte a dot, the level itself. Errors  As raster_device.hpp;
// those of the sink are passed on.
#pragma once

#include "drivers/byte_writer.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits gray_traits{.name = "gray",
                                          .width = 672,
                                          .height = 480,
                                          .max_width = 32767,
                                          .max_height = 32767,
                                          .dots_per_inch = 96,
                                          .format = DotFormat::gray,
                                          .levels = 256,
                                          .paper = Paper::black,
                                          .preferred_band_rows = 16};

class GrayDriver final : public RasterDevice {
 public:
  GrayDriver(ByteSink& sink, Clock& clock) : RasterDevice(gray_traits), writer_(sink, clock) {}

 private:
  DeviceStatus do_begin_page(const Page& page) override {
    writer_.reset();
    writer_.put("P5\n");
    writer_.put_number(page.width);
    writer_.put(" ");
    writer_.put_number(page.height);
    writer_.put("\n");
    writer_.put_number(page.levels - 1);
    writer_.put("\n");
    return writer_.status();
  }
  DeviceStatus do_put_band(const Band& band) override {
    writer_.put(band.bytes);
    return writer_.status();
  }
  DeviceStatus do_end_page() override { return writer_.flush(); }
  void do_abort() override { writer_.reset(); }

  ByteWriter writer_;
};

}  // namespace halfspace
