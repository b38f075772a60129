// dot_stream.hpp - a device that is nothing but its bytes: the bands of a page, one after the other, as they come.
#pragma once

#include "drivers/write_all.hpp"
#include "hal/raster_device.hpp"

namespace halfspace::microbit {

inline constexpr DeviceTraits dot_stream_traits{.name = "dots",
                                                .width = 128,
                                                .height = 64,
                                                .max_width = 32767,
                                                .max_height = 32767,
                                                .dots_per_inch = 100,
                                                .levels = 17,
                                                .preferred_band_rows = 8};

class DotStream final : public RasterDevice {
 public:
  DotStream(ByteSink& sink, Clock& clock) : RasterDevice(dot_stream_traits), sink_(sink), clock_(clock) {}

 private:
  DeviceStatus do_begin_page(const Page&) override { return DeviceStatus::ok; }
  DeviceStatus do_put_band(const Band& band) override { return write_all(sink_, clock_, band.bytes).status; }
  DeviceStatus do_end_page() override { return DeviceStatus::ok; }
  void do_abort() override {}

  ByteSink& sink_;
  Clock& clock_;
};

}  // namespace halfspace::microbit
