#include "sim/decode.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace halfspace {
namespace {

// A place in the stream. The first violation sticks, and everything after it is refused.
class Cursor {
 public:
  explicit Cursor(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool sound() const { return violation_.what.empty(); }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] bool next_is(std::uint8_t byte) const { return left() > 0 && bytes_[at_] == byte; }

  void violate(const char* what) {
    if (sound()) violation_ = {at_, what};
  }

  void expect(std::string_view text, const char* what) {
    for (const char c : text) {
      if (!sound()) return;
      if (!next_is(static_cast<std::uint8_t>(c))) return violate(what);
      ++at_;
    }
  }

  std::int32_t number(std::int32_t least, std::int32_t most, const char* what) {
    std::int32_t value = least;
    if (!sound()) return value;
    const char* const begin = reinterpret_cast<const char*>(bytes_.data()) + at_;
    const auto [end, error] = std::from_chars(begin, begin + left(), value);
    if (error != std::errc{} || value < least || value > most) {
      violate(what);
      return least;
    }
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  std::span<const std::uint8_t> take(std::size_t count, const char* what) {
    if (!sound() || left() < count) {
      violate(what);
      return {};
    }
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  std::uint8_t byte(const char* what) {
    const auto taken = take(1, what);
    return taken.empty() ? std::uint8_t{0} : taken[0];
  }

  Decoded result(PaperSheet sheet) {
    if (left() > 0) violate("bytes after the page");
    if (!sound()) return {std::nullopt, violation_};
    return {std::move(sheet), {}};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  Violation violation_;
};

constexpr std::int32_t largest_page = 32767;

std::uint32_t big_endian(std::span<const std::uint8_t> header, std::size_t at) {
  return std::uint32_t{header[at]} << 24 | std::uint32_t{header[at + 1]} << 16 | std::uint32_t{header[at + 2]} << 8 |
         header[at + 3];
}

// One line of spans, " first-last:level"..., after its scan line number.
void decode_spans_of_row(Cursor& from, std::span<std::uint8_t> row, std::int32_t levels, std::int32_t background) {
  std::int32_t free_from = 0;
  std::int32_t level_before = background;
  do {
    from.expect(" ", "span expected");
    const auto last_dot = static_cast<std::int32_t>(row.size()) - 1;
    const std::int32_t first = from.number(free_from, last_dot, "first dot of a span out of order");
    from.expect("-", "'-' of a span expected");
    const std::int32_t last = from.number(first, last_dot, "last dot of a span out of order");
    from.expect(":", "':' of a span expected");
    const std::int32_t level = from.number(0, levels - 1, "level out of range");
    if (level == background) from.violate("span of the background level");
    if (first == free_from && first > 0 && level == level_before) from.violate("spans that should be one");
    if (!from.sound()) return;
    std::fill(row.begin() + first, row.begin() + last + 1, static_cast<std::uint8_t>(level));
    free_from = last + 1;
    level_before = level;
  } while (!from.next_is('\n'));
  from.expect("\n", "end of line expected");
}

void decode_cell_row(Cursor& from, PaperSheet& sheet, std::int32_t top) {
  constexpr std::uint8_t bits[4][2] = {{1, 8}, {2, 16}, {4, 32}, {64, 128}};
  for (std::int32_t left = 0; left < sheet.width && from.sound(); left += 2) {
    const auto code = from.take(3, "line too short");
    if (code.empty()) return;
    if (code[0] != 0xE2 || (code[1] & 0xFC) != 0xA0 || (code[2] & 0xC0) != 0x80) return from.violate("no braille cell");
    const int cell = (code[1] & 3) << 6 | (code[2] & 0x3F);
    for (std::int32_t dot = 0; dot < 8; ++dot) {
      const std::int32_t x = left + dot % 2, y = top + dot / 2;
      if ((cell & bits[dot / 2][dot % 2]) == 0) continue;
      if (x >= sheet.width || y >= sheet.height) return from.violate("dot raised outside the page");
      sheet.dots[static_cast<std::size_t>(y) * sheet.row_bytes() + static_cast<std::size_t>(x) / 8] &=
          static_cast<std::uint8_t>(~(0x80 >> x % 8));
    }
  }
  from.expect("\n", "end of line expected");
}

// One line of the pieces of drivers/pwg.hpp.
void decode_pieces(Cursor& from, std::vector<std::uint8_t>& line, std::size_t size) {
  line.clear();
  while (line.size() < size && from.sound()) {
    const std::uint8_t head = from.byte("line cut short");
    if (head == 128) return from.violate("clear to end of line, which no driver here writes");
    const std::size_t count = head < 128 ? head + 1U : 257U - head;
    if (count > size - line.size()) return from.violate("piece beyond the end of the line");
    if (head < 128) {
      line.insert(line.end(), count, from.byte("line cut short"));
    } else {
      const auto bytes = from.take(count, "line cut short");
      line.insert(line.end(), bytes.begin(), bytes.end());
    }
  }
}

PaperSheet decode_pwg_header(Cursor& from) {
  from.expect("RaS2", "not PWG Raster");
  const auto header = from.take(1796, "header cut short");
  if (header.empty()) return {};
  const std::uint32_t width = big_endian(header, 372), height = big_endian(header, 376);
  if (width < 1 || width > largest_page || height < 1 || height > largest_page) from.violate("no such page size");
  if (big_endian(header, 384) != 1 || big_endian(header, 388) != 1) from.violate("not one bit a dot");
  if (big_endian(header, 392) != (width + 7) / 8) from.violate("bytes a line that do not fit the width");
  if (big_endian(header, 400) != 3) from.violate("not black");
  return {.width = static_cast<std::int32_t>(width), .height = static_cast<std::int32_t>(height)};
}

}  // namespace

Decoded decode_pgm(std::span<const std::uint8_t> bytes) {
  Cursor from(bytes);
  PaperSheet sheet{.format = DotFormat::gray};
  from.expect("P5\n", "not a binary PGM");
  sheet.width = from.number(1, largest_page, "width out of range");
  from.expect(" ", "space expected");
  sheet.height = from.number(1, largest_page, "height out of range");
  from.expect("\n", "end of line expected");
  sheet.levels = from.number(1, 255, "maxval out of range") + 1;
  from.expect("\n", "end of line expected");
  const auto dots = from.take(static_cast<std::size_t>(sheet.height) * sheet.row_bytes(), "picture cut short");
  const auto over = std::find_if(dots.begin(), dots.end(), [&](std::uint8_t dot) { return dot >= sheet.levels; });
  if (over != dots.end()) from.violate("level above maxval");
  sheet.dots.assign(dots.begin(), dots.end());
  return from.result(std::move(sheet));
}

Decoded decode_spans(std::span<const std::uint8_t> bytes) {
  Cursor from(bytes);
  PaperSheet sheet{.format = DotFormat::gray};
  from.expect("halfspace spans 1\npage ", "not spans of version 1");
  sheet.width = from.number(1, largest_page, "width out of range");
  from.expect(" ", "space expected");
  sheet.height = from.number(1, largest_page, "height out of range");
  from.expect(" levels ", "levels expected");
  sheet.levels = from.number(2, 256, "levels out of range");
  from.expect(" background ", "background expected");
  const std::int32_t background = from.number(0, sheet.levels - 1, "background out of range");
  from.expect("\n", "end of line expected");
  sheet.dots.assign(static_cast<std::size_t>(sheet.height) * sheet.row_bytes(), static_cast<std::uint8_t>(background));
  for (std::int32_t next_y = 0; from.sound() && from.left() > 0 && !from.next_is('e'); ++next_y) {
    next_y = from.number(next_y, sheet.height - 1, "scan line out of order");
    const std::span row = std::span(sheet.dots).subspan(static_cast<std::size_t>(next_y) * sheet.row_bytes());
    decode_spans_of_row(from, row.first(sheet.row_bytes()), sheet.levels, background);
  }
  from.expect("end ", "end of the page expected");
  (void)from.number(sheet.height, sheet.height, "height at the end differs");
  from.expect("\n", "end of line expected");
  return from.result(std::move(sheet));
}

Decoded decode_braille(std::span<const std::uint8_t> bytes, std::int32_t width, std::int32_t height) {
  Cursor from(bytes);
  PaperSheet sheet{.width = width, .height = height};
  sheet.dots.assign(static_cast<std::size_t>(height) * sheet.row_bytes(), 0xFF);
  if (width % 8 != 0) {
    const auto spare_blank = static_cast<std::uint8_t>(0xFF << (8 - width % 8));
    for (std::size_t end = sheet.row_bytes(); end <= sheet.dots.size(); end += sheet.row_bytes()) {
      sheet.dots[end - 1] = spare_blank;
    }
  }
  for (std::int32_t top = 0; top < height && from.sound(); top += 4) decode_cell_row(from, sheet, top);
  return from.result(std::move(sheet));
}

Decoded decode_pwg(std::span<const std::uint8_t> bytes) {
  Cursor from(bytes);
  PaperSheet sheet = decode_pwg_header(from);
  std::vector<std::uint8_t> line;
  for (std::int32_t y = 0; y < sheet.height && from.sound();) {
    const std::int32_t lines = from.byte("page cut short") + 1;
    if (lines > sheet.height - y) from.violate("lines beyond the end of the page");
    decode_pieces(from, line, sheet.row_bytes());
    for (std::int32_t copy = 0; copy < lines && from.sound(); ++copy, ++y) {
      sheet.dots.insert(sheet.dots.end(), line.begin(), line.end());
    }
  }
  return from.result(std::move(sheet));
}

}  // namespace halfspace
