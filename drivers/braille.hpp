// braille.hpp - a picture in a text terminal: each character is a Unicode braille cell of 2 x 4 dots, in
// UTF-8.
//   U+2800 + bits:  1   8     A raised dot is light (ink bit 0), as on a screen: a terminal is dark. Empty
//   cells are
//                   2  16     U+2800, not spaces, so that the columns keep their width. Dots beyond the right
//                   and 4  32     lower edge of the page are not raised. One text line per 4 scan lines.
//                  64 128
// Memory  One byte for each cell of a text line: 2 KiB.
#pragma once

#include "drivers/byte_writer.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

inline constexpr DeviceTraits braille_traits{.name = "braille",
                                             .width = 160,
                                             .height = 96,
                                             .max_width = 4096,
                                             .max_height = 32767,
                                             .dots_per_inch = 24,
                                             .paper = Paper::black,
                                             .preferred_band_rows = 4};

class BrailleDriver final : public RasterDevice {
 public:
  BrailleDriver(ByteSink& sink, Clock& clock) : RasterDevice(braille_traits), writer_(sink, clock) {}

 private:
  DeviceStatus do_begin_page(const Page& page) override;
  DeviceStatus do_put_band(const Band& band) override;
  DeviceStatus do_end_page() override { return writer_.flush(); }
  void do_abort() override { writer_.reset(); }

  void raise_row(std::int32_t row_of_cell, std::span<const std::uint8_t> ink);
  void put_cells();

  ByteWriter writer_;
  std::array<std::uint8_t, 2048> cells_{};
};

}  // namespace halfspace
