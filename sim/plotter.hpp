// plotter.hpp - simulated electrostatic plotters, stricter than the real ones: whatever would misprint, or
// work by luck, is recorded as a violation with its byte offset, and refused as a protocol error. Paper Lines
// plotted between two feeds make one page; feeds and margins are no part of it. Text    There is no character
// generator: in print mode only the bytes that move the paper are taken. Faults  set_fault strikes any call
// by its number; limit_paper ends the roll after a number of lines;
//         limit_transfer makes writes partial.
#pragma once

#include <vector>

#include "hal/plotter_port.hpp"
#include "sim/fault.hpp"
#include "sim/sheet.hpp"
#include "sim/violation.hpp"

namespace halfspace {

class SimulatedPlotter : public PlotterPort {
 public:
  DeviceStatus set_mode(PlotterMode mode) final;
  DeviceStatus function(PlotterFunction function) final;
  Accepted write(std::span<const std::uint8_t> bytes) final;

  // The job is over: a picture still inside the plotter is a violation.
  void close();

  void set_fault(const Fault& fault) { faults_.set(fault); }
  void limit_paper(std::size_t lines) { paper_lines_ = lines; }
  void limit_transfer(std::size_t bytes) { transfer_limit_ = bytes; }

  [[nodiscard]] const std::vector<Violation>& violations() const { return violations_; }
  [[nodiscard]] const std::vector<PaperSheet>& pages() const { return pages_; }
  [[nodiscard]] std::size_t calls() const { return faults_.calls(); }

 protected:
  explicit SimulatedPlotter(std::size_t line_bytes) : line_bytes_(line_bytes) {}
  ~SimulatedPlotter() = default;

  DeviceStatus violate(const char* what);
  void feed() { fed_ = true; }
  void drop_page();          // what was plotted since the last feed
  DeviceStatus fill_line();  // the rest of the line is blank
  [[nodiscard]] bool in_line() const { return !line_.empty(); }
  [[nodiscard]] PlotterMode mode() const { return mode_; }

 private:
  // Each returns ok, or has recorded a violation.
  virtual DeviceStatus enter_mode() = 0;  // mode() changes if it does
  virtual DeviceStatus do_function(PlotterFunction function) = 0;
  virtual DeviceStatus check_write(std::span<const std::uint8_t> bytes) = 0;
  virtual DeviceStatus print(std::uint8_t byte) = 0;
  virtual const char* unfinished() const = 0;  // what a job must do before it closes

  Accepted take_dots(std::span<const std::uint8_t> bytes);
  Accepted take_text(std::span<const std::uint8_t> bytes);
  void print_line();

  std::size_t line_bytes_;
  std::size_t paper_lines_ = SIZE_MAX;
  std::size_t transfer_limit_ = PlotterPort::transfer_limit;
  std::size_t bytes_taken_ = 0;
  PlotterMode mode_ = PlotterMode::print;
  bool fed_ = true;
  std::vector<std::uint8_t> line_;
  std::vector<PaperSheet> pages_;
  std::vector<Violation> violations_;
  FaultLine faults_;
};

// Modes and remote functions as vp(4) has them. A job: reset, clear, a mode; it must end with a feed.
class SimulatedVersatec final : public SimulatedPlotter {
 public:
  SimulatedVersatec() : SimulatedPlotter(880) {}

 private:
  enum class Readiness : std::uint8_t { unknown, reset, cleared, mode_set };

  DeviceStatus enter_mode() override;
  DeviceStatus do_function(PlotterFunction function) override;
  DeviceStatus check_write(std::span<const std::uint8_t> bytes) override;
  DeviceStatus print(std::uint8_t byte) override;
  const char* unfinished() const override;

  DeviceStatus do_clear();
  DeviceStatus do_feed(const char* within_line);

  Readiness readiness_ = Readiness::unknown;
};

// Commands as va(4) has them. A job: plot, auto step; it must end with a form feed in print mode.
class SimulatedVarian final : public SimulatedPlotter {
 public:
  SimulatedVarian() : SimulatedPlotter(264) {}

 private:
  DeviceStatus enter_mode() override;
  DeviceStatus do_function(PlotterFunction function) override;
  DeviceStatus check_write(std::span<const std::uint8_t> bytes) override;
  DeviceStatus print(std::uint8_t byte) override;
  const char* unfinished() const override;

  bool mode_set_ = false;
  bool steps_ = false;  // AUTOSTEP in force
};

}  // namespace halfspace
