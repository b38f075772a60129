// ssd1306.hpp - a simulated SSD1306 module: 128 x 64 dots, commands parsed, its memory visible.
//   Stricter than the controller: unknown commands, arguments missing or out of range, a window that wraps
//   round, a byte written twice in one window, data in a memory that is shown before it has been written: all
//   are violations.
// Glass    The panel is mounted as on the common modules: segment remap (A1) and reversed scan (C8) show it
// upright. Source   Solomon Systech, SSD1306 data sheet, rev. 1.1, sections 8.7, 9 and 10.
#pragma once

#include <array>
#include <vector>

#include "hal/display_port.hpp"
#include "sim/fault.hpp"
#include "sim/sheet.hpp"
#include "sim/violation.hpp"

namespace halfspace {

class SimulatedSsd1306 final : public DisplayPort {
 public:
  static constexpr int columns = 128;
  static constexpr int pages = 8;

  DeviceStatus command(std::span<const std::uint8_t> bytes) override;
  DeviceStatus data(std::span<const std::uint8_t> bytes) override;

  void set_fault(const Fault& fault) { faults_.set(fault); }

  // What the glass shows, 1 = dark as ink is; all dark while the display is off.
  [[nodiscard]] PaperSheet glass() const;
  [[nodiscard]] bool is_on() const { return on_; }
  // The display memory, page by page.
  [[nodiscard]] const std::array<std::uint8_t, 1024>& memory() const { return memory_; }
  [[nodiscard]] const std::vector<Violation>& violations() const { return violations_; }
  [[nodiscard]] std::size_t calls() const { return faults_.calls(); }

 private:
  enum class Addressing : std::uint8_t { horizontal, vertical, page };

  DeviceStatus violate(const char* what);
  DeviceStatus apply(std::uint8_t command, std::span<const std::uint8_t> arguments);
  DeviceStatus set_range(int& first, int& last, int& at, int limit, std::span<const std::uint8_t> arguments);
  DeviceStatus set_page_address(std::uint8_t command);
  DeviceStatus switch_on();
  DeviceStatus store(std::uint8_t byte);
  void advance();
  void enter_window();

  Addressing addressing_ = Addressing::page;
  int first_column_ = 0, last_column_ = columns - 1, column_ = 0;
  int first_page_ = 0, last_page_ = pages - 1, page_ = 0;
  bool window_full_ = false;
  bool on_ = false, charge_pump_ = false, inverted_ = false, all_lit_ = false;
  bool remapped_ = false, scan_reversed_ = false;
  std::size_t bytes_taken_ = 0;
  std::array<std::uint8_t, 1024> memory_{};
  std::array<bool, 1024> written_{};  // since power on
  std::array<bool, 1024> written_in_window_{};
  std::vector<Violation> violations_;
  FaultLine faults_;
};

}  // namespace halfspace
