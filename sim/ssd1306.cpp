#include "sim/ssd1306.hpp"

#include <algorithm>

namespace halfspace {
namespace {

struct CommandRange {
  std::uint8_t first, last;
  std::size_t arguments;
};

// Every command taken here. Scrolling, and what another panel would need, is left out: it is a violation.
constexpr std::array<CommandRange, 17> command_set{{
    {0x00, 0x1F, 0},  // column, in page addressing mode
    {0x20, 0x20, 1},  // addressing mode
    {0x21, 0x22, 2},  // window: columns, pages
    {0x40, 0x7F, 0},  // start line
    {0x81, 0x81, 1},  // contrast
    {0x8D, 0x8D, 1},  // charge pump
    {0xA0, 0xA1, 0},  // segment remap
    {0xA4, 0xA7, 0},  // memory or all lit; normal or inverted
    {0xA8, 0xA8, 1},  // multiplex ratio
    {0xAE, 0xAF, 0},  // off, on
    {0xB0, 0xB7, 0},  // page, in page addressing mode
    {0xC0, 0xC0, 0},  // scan direction
    {0xC8, 0xC8, 0},
    {0xD3, 0xD3, 1},  // vertical offset
    {0xD5, 0xD5, 1},  // clock
    {0xD9, 0xDB, 1},  // pre-charge, COM pins, deselect level
    {0xE3, 0xE3, 0},  // nothing
}};

const CommandRange* find_command(std::uint8_t byte) {
  const auto at = std::find_if(command_set.begin(), command_set.end(),
                               [byte](const CommandRange& c) { return byte >= c.first && byte <= c.last; });
  return at == command_set.end() ? nullptr : &*at;
}

}  // namespace

DeviceStatus SimulatedSsd1306::violate(const char* what) {
  violations_.push_back({bytes_taken_, what});
  return DeviceStatus::protocol;
}

DeviceStatus SimulatedSsd1306::command(std::span<const std::uint8_t> bytes) {
  if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return fault;
  while (!bytes.empty()) {
    const CommandRange* const known = find_command(bytes[0]);
    if (known == nullptr) return violate("unknown command");
    const std::size_t length = 1 + known->arguments;
    if (bytes.size() < length) return violate("command without all its arguments");
    const DeviceStatus status = apply(bytes[0], bytes.subspan(1, length - 1));
    if (status != DeviceStatus::ok) return status;
    bytes_taken_ += length;
    bytes = bytes.subspan(length);
  }
  return DeviceStatus::ok;
}

DeviceStatus SimulatedSsd1306::set_range(int& first, int& last, int& at, int limit,
                                         std::span<const std::uint8_t> arguments) {
  if (addressing_ == Addressing::page) return violate("window in page addressing mode");
  if (arguments[0] > arguments[1] || arguments[1] >= limit) return violate("window outside the display");
  first = at = arguments[0];
  last = arguments[1];
  enter_window();
  return DeviceStatus::ok;
}

void SimulatedSsd1306::enter_window() {
  window_full_ = false;
  written_in_window_.fill(false);
}

DeviceStatus SimulatedSsd1306::switch_on() {
  if (!charge_pump_) return violate("display on without the charge pump");
  if (!std::all_of(written_.begin(), written_.end(), [](bool w) { return w; })) {
    return violate("display on before all of its memory is written");
  }
  on_ = true;
  return DeviceStatus::ok;
}

DeviceStatus SimulatedSsd1306::apply(std::uint8_t command, std::span<const std::uint8_t> arguments) {
  switch (command) {
    case 0x20:
      if (arguments[0] > 2) return violate("no such addressing mode");
      addressing_ = static_cast<Addressing>(arguments[0]);
      enter_window();
      return DeviceStatus::ok;
    case 0x21:
      return set_range(first_column_, last_column_, column_, columns, arguments);
    case 0x22:
      return set_range(first_page_, last_page_, page_, pages, arguments);
    case 0x8D:
      charge_pump_ = arguments[0] == 0x14;
      return DeviceStatus::ok;
    case 0xA0:
    case 0xA1:
      remapped_ = command == 0xA1;
      return DeviceStatus::ok;
    case 0xA4:
    case 0xA5:
      all_lit_ = command == 0xA5;
      return DeviceStatus::ok;
    case 0xA6:
    case 0xA7:
      inverted_ = command == 0xA7;
      return DeviceStatus::ok;
    case 0xA8:
      return arguments[0] == 0x3F ? DeviceStatus::ok : violate("not the multiplex ratio of 64 lines");
    case 0xAE:
      on_ = false;
      return DeviceStatus::ok;
    case 0xAF:
      return switch_on();
    case 0xC0:
    case 0xC8:
      scan_reversed_ = command == 0xC8;
      return DeviceStatus::ok;
    case 0xD3:
      return arguments[0] == 0 ? DeviceStatus::ok : violate("vertical offset");
    case 0xDA:
      return arguments[0] == 0x12 ? DeviceStatus::ok : violate("not the COM pins of a 64-line panel");
    default:
      break;
  }
  if (command > 0x40 && command < 0x80) return violate("start line other than 0");
  if (command < 0x20 || (command >= 0xB0 && command < 0xB8)) return set_page_address(command);
  return DeviceStatus::ok;  // timing and contrast do not change the dots
}

DeviceStatus SimulatedSsd1306::set_page_address(std::uint8_t command) {
  if (addressing_ != Addressing::page) return violate("page-mode address in another addressing mode");
  const int column = command < 0x10   ? (column_ & 0xF0) | command
                     : command < 0x20 ? (column_ & 0x0F) | (command & 0x0F) << 4
                                      : column_;
  if (column >= columns) return violate("column outside the display");
  column_ = column;
  if (command >= 0xB0) page_ = command & 7;
  enter_window();
  return DeviceStatus::ok;
}

DeviceStatus SimulatedSsd1306::data(std::span<const std::uint8_t> bytes) {
  if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return fault;
  for (const std::uint8_t byte : bytes) {
    if (const DeviceStatus status = store(byte); status != DeviceStatus::ok) return status;
    ++bytes_taken_;
  }
  return DeviceStatus::ok;
}

DeviceStatus SimulatedSsd1306::store(std::uint8_t byte) {
  if (window_full_) return violate("data beyond the window");
  const std::size_t at = static_cast<std::size_t>(page_) * columns + static_cast<std::size_t>(column_);
  if (written_in_window_[at]) return violate("byte written twice in one window");
  memory_[at] = byte;
  written_[at] = written_in_window_[at] = true;
  advance();
  return DeviceStatus::ok;
}

void SimulatedSsd1306::advance() {
  if (addressing_ == Addressing::page) {
    if (++column_ == columns) window_full_ = true;
    column_ %= columns;
    return;
  }
  const bool across = addressing_ == Addressing::horizontal;
  int& fast = across ? column_ : page_;
  int& slow = across ? page_ : column_;
  const int fast_first = across ? first_column_ : first_page_, fast_last = across ? last_column_ : last_page_;
  const int slow_first = across ? first_page_ : first_column_, slow_last = across ? last_page_ : last_column_;
  if (fast++ < fast_last) return;
  fast = fast_first;
  if (slow++ < slow_last) return;
  slow = slow_first;
  window_full_ = true;
}

PaperSheet SimulatedSsd1306::glass() const {
  PaperSheet sheet{.width = columns, .height = pages * 8};
  sheet.dots.assign(static_cast<std::size_t>(sheet.height) * sheet.row_bytes(), 0xFF);
  for (int y = 0; on_ && y < sheet.height; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int column = remapped_ ? x : columns - 1 - x;
      const int line = scan_reversed_ ? y : sheet.height - 1 - y;
      const auto at = static_cast<std::size_t>(line / 8) * columns + static_cast<std::size_t>(column);
      const int bit = memory_[at] >> line % 8 & 1;
      if (!all_lit_ && (bit != 0) == inverted_) continue;
      sheet.dots[static_cast<std::size_t>(y * columns + x) / 8] ^= static_cast<std::uint8_t>(0x80 >> x % 8);
    }
  }
  return sheet;
}

}  // namespace halfspace
