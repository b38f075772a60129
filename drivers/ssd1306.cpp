#include "drivers/ssd1306.hpp"

#include "drivers/write_all.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t page_rows = 8;  // scan lines in one page of the display

// Dark first, lit last, so that no stale picture flashes up.
constexpr std::uint8_t set_up[] = {
    0xAE,        // display off
    0xD5, 0x80,  // clock: divide by 1, default frequency
    0xA8, 0x3F,  // 64 lines multiplexed
    0xD3, 0x00,  // no vertical offset
    0x40,        // start at line 0
    0x8D, 0x14,  // charge pump on: the modules have no other supply for the panel
    0x20, 0x00,  // horizontal addressing: column by column, then the next page
    0xA1, 0xC8,  // column 127 at segment 0, scanned from the last line: upright as the modules are mounted
    0xDA, 0x12,  // alternate COM pins, as a 64-line panel is wired
    0x81, 0xCF,  // contrast
    0xD9, 0xF1,  // pre-charge for the charge pump
    0xDB, 0x40,  // deselect level
    0xA4, 0xA6,  // show the memory, a set bit is lit
};
constexpr std::uint8_t whole_window[] = {0x21, 0, 127, 0x22, 0, 7};
constexpr std::uint8_t display_on[] = {0xAF};

}  // namespace

DeviceStatus Ssd1306Driver::command(std::span<const std::uint8_t> bytes) {
  return retry_while_busy(clock_, driver_patience_ms, [&] { return port_.command(bytes); });
}

DeviceStatus Ssd1306Driver::do_begin_page(const Page&) {
  columns_.fill(0);
  if (const DeviceStatus status = command(set_up); status != DeviceStatus::ok) return status;
  return command(whole_window);
}

void Ssd1306Driver::light_row(std::int32_t row_of_page, std::span<const std::uint8_t> ink) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(page().width); ++x) {
    const int lit = (ink[x / 8] >> (7 - x % 8) & 1) ^ 1;
    columns_[x] = static_cast<std::uint8_t>(columns_[x] | lit << row_of_page);
  }
}

DeviceStatus Ssd1306Driver::put_columns() {
  const DeviceStatus status = retry_while_busy(clock_, driver_patience_ms, [&] { return port_.data(columns_); });
  columns_.fill(0);
  return status;
}

DeviceStatus Ssd1306Driver::do_put_band(const Band& band) {
  const std::size_t row_bytes = page().row_bytes();
  for (std::int32_t row = 0; row < band.rows; ++row) {
    const std::int32_t y = band.y + row;
    light_row(y % page_rows, band.bytes.subspan(static_cast<std::size_t>(row) * row_bytes, row_bytes));
    if (y % page_rows != page_rows - 1 && y + 1 != page().height) continue;
    if (const DeviceStatus status = put_columns(); status != DeviceStatus::ok) return status;
  }
  return DeviceStatus::ok;
}

DeviceStatus Ssd1306Driver::do_end_page() {
  const std::int32_t used = (page().height + page_rows - 1) / page_rows;
  for (std::int32_t rest = used; rest < ssd1306_traits.height / page_rows; ++rest) {
    if (const DeviceStatus status = put_columns(); status != DeviceStatus::ok) return status;
  }
  return command(display_on);
}

}  // namespace halfspace
