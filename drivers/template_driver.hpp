// template_driver.hpp - an empty driver to copy. It takes pages and throws them away; the tests build and run
// it.
//   1. State what the device is in its traits, and add them to device_table.hpp.
//   2. Turn each band into the device's bytes in do_put_band. Order, contiguity and sizes have been checked.
//   3. Wait only through retry_while_busy or write_all: both have a deadline.
//   4. Write a simulator that refuses what the device refuses (sim/), and a test that compares dots
//   (tests/drivers).
#pragma once

#include "drivers/write_all.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits template_traits{.name = "template",
                                              .width = 640,
                                              .height = 480,
                                              .max_width = 640,
                                              .max_height = 480,
                                              .dots_per_inch = 100,
                                              .preferred_band_rows = 8};

class TemplateDriver final : public RasterDevice {
 public:
  TemplateDriver() : RasterDevice(template_traits) {}

 private:
  // Bring the device from whatever state it is in to the first scan line.
  DeviceStatus do_begin_page(const Page&) override { return DeviceStatus::ok; }
  // Send band.rows scan lines from band.y on; page() is the page that was begun.
  DeviceStatus do_put_band(const Band&) override { return DeviceStatus::ok; }
  // Send what is held back, and make the page visible.
  DeviceStatus do_end_page() override { return DeviceStatus::ok; }
  // The page is lost: forget what is held back.
  void do_abort() override {}
};

}  // namespace halfspace
