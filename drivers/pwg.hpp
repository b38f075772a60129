// pwg.hpp - PWG Raster (PWG 5102.4), the language of driverless printers, one page of 1-bit black.
//   "RaS2", a header of 1796 bytes with big-endian numbers, then groups of equal lines:
//   lines - 1, then one line in pieces:  0 .. 127: the next byte, n + 1 times;  129 .. 255: 257 - n bytes as
//   they are
// Memory  The last line, 4 KiB: it is written when a different one comes.
#pragma once

#include "drivers/byte_writer.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits pwg_traits{.name = "pwg",
                                         .width = 2550,
                                         .height = 3300,
                                         .max_width = 32767,
                                         .max_height = 32767,
                                         .dots_per_inch = 300,
                                         .preferred_band_rows = 16};

class PwgDriver final : public RasterDevice {
 public:
  PwgDriver(ByteSink& sink, Clock& clock, std::int32_t dots_per_inch = pwg_traits.dots_per_inch)
      : RasterDevice(pwg_traits), writer_(sink, clock), dots_per_inch_(dots_per_inch) {}

 private:
  DeviceStatus do_begin_page(const Page& page) override;
  DeviceStatus do_put_band(const Band& band) override;
  DeviceStatus do_end_page() override;
  void do_abort() override { writer_.reset(); }

  void put_header(const Page& page);
  void put_text(std::string_view text, std::size_t size);
  void put_big_endian(std::uint32_t value);
  void put_zeros(std::size_t count);
  void put_line(std::span<const std::uint8_t> line);
  void put_group();

  ByteWriter writer_;
  std::int32_t dots_per_inch_;
  std::int32_t repeats_ = 0;  // equal lines held back, 0 .. 256
  std::array<std::uint8_t, 4096> line_{};
};

}  // namespace halfspace
