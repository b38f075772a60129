#include "drivers/braille.hpp"

namespace halfspace {
namespace {

constexpr std::array<std::array<std::uint8_t, 2>, 4> cell_bits{{{1, 8}, {2, 16}, {4, 32}, {64, 128}}};

}  // namespace

static_assert(braille_traits.max_width == 2 * 2048);

DeviceStatus BrailleDriver::do_begin_page(const Page&) {
  writer_.reset();
  cells_.fill(0);
  return DeviceStatus::ok;
}

void BrailleDriver::raise_row(std::int32_t row_of_cell, std::span<const std::uint8_t> ink) {
  const auto& bits = cell_bits[static_cast<std::size_t>(row_of_cell)];
  for (std::size_t x = 0; x < static_cast<std::size_t>(page().width); ++x) {
    const bool inked = (ink[x / 8] >> (7 - x % 8) & 1) != 0;
    if (!inked) cells_[x / 2] = static_cast<std::uint8_t>(cells_[x / 2] | bits[x % 2]);
  }
}

void BrailleDriver::put_cells() {
  const std::size_t count = (static_cast<std::size_t>(page().width) + 1) / 2;
  for (const std::uint8_t cell : std::span(cells_).first(count)) {
    writer_.put(0xE2);  // U+2800 .. U+28FF in UTF-8
    writer_.put(static_cast<std::uint8_t>(0xA0 | cell >> 6));
    writer_.put(static_cast<std::uint8_t>(0x80 | (cell & 0x3F)));
  }
  writer_.put("\n");
  cells_.fill(0);
}

DeviceStatus BrailleDriver::do_put_band(const Band& band) {
  const std::size_t row_bytes = page().row_bytes();
  for (std::int32_t row = 0; row < band.rows; ++row) {
    const std::int32_t y = band.y + row;
    raise_row(y % 4, band.bytes.subspan(static_cast<std::size_t>(row) * row_bytes, row_bytes));
    if (y % 4 == 3 || y + 1 == page().height) put_cells();
  }
  return writer_.status();
}

}  // namespace halfspace
