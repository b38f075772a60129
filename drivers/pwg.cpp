#include "drivers/pwg.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr std::int32_t most_repeats = 256;
constexpr std::size_t longest_run = 128;  // bytes in one piece, repeated or as they are
constexpr std::uint32_t black_colour_space = 3;
constexpr std::int32_t points_per_inch = 72;

std::size_t run_length(std::span<const std::uint8_t> bytes) {
  const auto most = bytes.first(std::min(bytes.size(), longest_run));
  const auto end = std::find_if(most.begin(), most.end(), [&](std::uint8_t b) { return b != bytes[0]; });
  return static_cast<std::size_t>(end - most.begin());
}

// Bytes up to the next pair of equal ones.
std::size_t literal_length(std::span<const std::uint8_t> bytes) {
  const auto most = bytes.first(std::min(bytes.size(), longest_run));
  const auto pair = std::adjacent_find(most.begin(), most.end());
  return std::max<std::size_t>(1, static_cast<std::size_t>(pair - most.begin()));
}

}  // namespace

void PwgDriver::put_text(std::string_view text, std::size_t size) {
  writer_.put(text);
  put_zeros(size - text.size());
}

void PwgDriver::put_big_endian(std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) writer_.put(static_cast<std::uint8_t>(value >> shift));
}

void PwgDriver::put_zeros(std::size_t count) {
  for (; count > 0; --count) writer_.put(std::uint8_t{0});
}

// The offsets are those of the header, not of the stream. Fields that stay 0 ask for the printer's own
// choice.
void PwgDriver::put_header(const Page& page) {
  const auto width = static_cast<std::uint32_t>(page.width);
  const auto height = static_cast<std::uint32_t>(page.height);
  const auto dpi = static_cast<std::uint32_t>(dots_per_inch_);
  const auto points = [dpi](std::uint32_t dots) { return (2 * dots * points_per_inch + dpi) / (2 * dpi); };
  put_text("PwgRaster", 256);  // 0: the format; media colour and type, and the output's purpose, left open
  put_zeros(276 - 256);
  put_big_endian(dpi);  // 276: resolution along and across the line
  put_big_endian(dpi);
  put_zeros(340 - 284);
  put_big_endian(1);  // 340: copies
  put_zeros(352 - 344);
  put_big_endian(points(width));  // 352: size of the page, in points
  put_big_endian(points(height));
  put_zeros(372 - 360);
  put_big_endian(width);
  put_big_endian(height);
  put_zeros(384 - 380);
  put_big_endian(1);  // 384: bits per colour
  put_big_endian(1);  // 388: bits per dot
  put_big_endian(static_cast<std::uint32_t>(page.row_bytes()));
  put_big_endian(0);  // 396: dots are chunky
  put_big_endian(black_colour_space);
  put_zeros(420 - 404);
  put_big_endian(1);  // 420: colours
  put_zeros(452 - 424);
  put_big_endian(1);  // 452: pages in the stream
  put_big_endian(1);  // 456: not mirrored along the feed ...
  put_big_endian(1);  // 460: ... nor across it
  put_zeros(1796 - 464);
}

DeviceStatus PwgDriver::do_begin_page(const Page& page) {
  writer_.reset();
  repeats_ = 0;
  writer_.put("RaS2");
  put_header(page);
  return writer_.status();
}

void PwgDriver::put_line(std::span<const std::uint8_t> line) {
  while (!line.empty()) {
    std::size_t count = run_length(line);
    if (count > 1) {
      writer_.put(static_cast<std::uint8_t>(count - 1));
      writer_.put(line[0]);
    } else {
      count = literal_length(line);
      writer_.put(static_cast<std::uint8_t>(count == 1 ? 0 : 257 - count));  // 256 does not fit: one byte is a run
      writer_.put(line.first(count));
    }
    line = line.subspan(count);
  }
}

void PwgDriver::put_group() {
  if (repeats_ == 0) return;
  writer_.put(static_cast<std::uint8_t>(repeats_ - 1));
  put_line(std::span(line_).first(page().row_bytes()));
  repeats_ = 0;
}

DeviceStatus PwgDriver::do_put_band(const Band& band) {
  const std::size_t row_bytes = page().row_bytes();
  for (auto rest = band.bytes; !rest.empty(); rest = rest.subspan(row_bytes)) {
    const auto row = rest.first(row_bytes);
    if (repeats_ == most_repeats || !std::equal(row.begin(), row.end(), line_.begin())) put_group();
    std::copy(row.begin(), row.end(), line_.begin());
    ++repeats_;
  }
  return writer_.status();
}

DeviceStatus PwgDriver::do_end_page() {
  put_group();
  return writer_.flush();
}

}  // namespace halfspace
