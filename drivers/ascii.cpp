#include "drivers/ascii.hpp"

#include <algorithm>

namespace halfspace {

DeviceStatus AsciiDriver::do_begin_page(const Page& page) {
  writer_.reset();
  writer_.put("halfspace spans 1\npage ");
  writer_.put_number(page.width);
  writer_.put(" ");
  writer_.put_number(page.height);
  writer_.put(" levels ");
  writer_.put_number(page.levels);
  writer_.put(" background ");
  writer_.put_number(page.background);
  writer_.put("\n");
  return writer_.status();
}

void AsciiDriver::put_row(std::int32_t y, std::span<const std::uint8_t> levels) {
  bool begun = false;
  for (auto span = levels.begin(); span != levels.end();) {
    const std::uint8_t level = *span;
    const auto end = std::find_if(span, levels.end(), [level](std::uint8_t other) { return other != level; });
    if (level != page().background) {
      if (!begun) writer_.put_number(y);
      begun = true;
      writer_.put(" ");
      writer_.put_number(static_cast<std::int32_t>(span - levels.begin()));
      writer_.put("-");
      writer_.put_number(static_cast<std::int32_t>(end - levels.begin()) - 1);
      writer_.put(":");
      writer_.put_number(level);
    }
    span = end;
  }
  if (begun) writer_.put("\n");
}

DeviceStatus AsciiDriver::do_put_band(const Band& band) {
  const std::size_t row_bytes = page().row_bytes();
  for (std::int32_t row = 0; row < band.rows; ++row) {
    put_row(band.y + row, band.bytes.subspan(static_cast<std::size_t>(row) * row_bytes, row_bytes));
  }
  return writer_.status();
}

DeviceStatus AsciiDriver::do_end_page() {
  writer_.put("end ");
  writer_.put_number(page().height);
  writer_.put("\n");
  return writer_.flush();
}

}  // namespace halfspace
