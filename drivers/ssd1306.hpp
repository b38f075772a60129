// ssd1306.hpp - the common 128 x 64 OLED: 8 pages of 128 columns, a byte is 8 dots of one column, the top one
// in the least significant bit. A set bit is lit: light, where the page's ink bit is 0.
//   page: set-up commands, the whole display as the window, 8 times 128 bytes of data
// Range   A smaller page lies in the top left corner; the rest stays dark.
// Memory  One page of the display: 128 bytes.
// Source  Solomon Systech, SSD1306 data sheet, rev. 1.1, sections 8.7, 9 and 10.
#pragma once

#include <array>

#include "hal/clock.hpp"
#include "hal/display_port.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits ssd1306_traits{.name = "ssd1306",
                                             .width = 128,
                                             .height = 64,
                                             .max_width = 128,
                                             .max_height = 64,
                                             .dots_per_inch = 149,  // 0.96 inch diagonal
                                             .paper = Paper::black,
                                             .preferred_band_rows = 8};

class Ssd1306Driver final : public RasterDevice {
 public:
  Ssd1306Driver(DisplayPort& port, Clock& clock) : RasterDevice(ssd1306_traits), port_(port), clock_(clock) {}

 private:
  DeviceStatus do_begin_page(const Page& page) override;
  DeviceStatus do_put_band(const Band& band) override;
  DeviceStatus do_end_page() override;
  void do_abort() override {}  // the next page sets everything up again

  DeviceStatus command(std::span<const std::uint8_t> bytes);
  void light_row(std::int32_t row_of_page, std::span<const std::uint8_t> ink);
  DeviceStatus put_columns();

  DisplayPort& port_;
  Clock& clock_;
  std::array<std::uint8_t, 128> columns_{};
};

}  // namespace halfspace
