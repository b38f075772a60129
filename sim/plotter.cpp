#include "sim/plotter.hpp"

#include <algorithm>

namespace halfspace {

DeviceStatus SimulatedPlotter::violate(const char* what) {
  violations_.push_back({bytes_taken_, what});
  return DeviceStatus::protocol;
}

DeviceStatus SimulatedPlotter::set_mode(PlotterMode mode) {
  if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return fault;
  if (in_line()) return violate("mode set within a line");
  const DeviceStatus status = enter_mode();
  if (status == DeviceStatus::ok) mode_ = mode;
  return status;
}

DeviceStatus SimulatedPlotter::function(PlotterFunction function) {
  if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return fault;
  return do_function(function);
}

Accepted SimulatedPlotter::write(std::span<const std::uint8_t> bytes) {
  if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return {fault, 0};
  if (bytes.empty()) return {violate("transfer of no bytes"), 0};
  if (bytes.size() > PlotterPort::transfer_limit) return {violate("transfer of more than 16384 bytes"), 0};
  if (const DeviceStatus status = check_write(bytes); status != DeviceStatus::ok) return {status, 0};
  bytes = bytes.first(std::min(bytes.size(), transfer_limit_));
  if (mode_ == PlotterMode::plot) return take_dots(bytes);
  const Accepted taken = take_text(bytes);
  if (mode_ == PlotterMode::print_plot) mode_ = PlotterMode::plot;  // the text was its first transfer
  return taken;
}

Accepted SimulatedPlotter::take_dots(std::span<const std::uint8_t> bytes) {
  std::size_t taken = 0;
  for (; taken < bytes.size() && paper_lines_ > 0; ++taken) {
    line_.push_back(bytes[taken]);
    ++bytes_taken_;
    if (line_.size() == line_bytes_) print_line();
  }
  return {taken > 0 ? DeviceStatus::ok : DeviceStatus::no_paper, taken};
}

Accepted SimulatedPlotter::take_text(std::span<const std::uint8_t> bytes) {
  std::size_t taken = 0;
  for (; taken < bytes.size(); ++taken) {
    if (const DeviceStatus status = print(bytes[taken]); status != DeviceStatus::ok) return {status, 0};
    ++bytes_taken_;
  }
  return {DeviceStatus::ok, taken};
}

void SimulatedPlotter::print_line() {
  if (fed_) pages_.push_back({.width = static_cast<std::int32_t>(line_bytes_ * 8)});
  fed_ = false;
  PaperSheet& page = pages_.back();
  page.dots.insert(page.dots.end(), line_.begin(), line_.end());
  ++page.height;
  line_.clear();
  --paper_lines_;
}

DeviceStatus SimulatedPlotter::fill_line() {
  if (paper_lines_ == 0) return DeviceStatus::no_paper;
  line_.resize(line_bytes_);
  print_line();
  return DeviceStatus::ok;
}

void SimulatedPlotter::drop_page() {
  line_.clear();
  if (!fed_) pages_.pop_back();
  fed_ = true;
}

void SimulatedPlotter::close() {
  if (in_line()) (void)violate("job closed within a line");
  if (!fed_) (void)violate(unfinished());
}

DeviceStatus SimulatedVersatec::enter_mode() {
  if (readiness_ < Readiness::cleared) return violate("mode set before reset and clear");
  readiness_ = Readiness::mode_set;
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVersatec::do_clear() {
  if (readiness_ != Readiness::reset) return violate("clear that does not follow a reset");
  readiness_ = Readiness::cleared;
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVersatec::do_feed(const char* within_line) {
  if (readiness_ < Readiness::cleared) return violate("feed before reset and clear");
  if (in_line()) return violate(within_line);
  if (readiness_ == Readiness::mode_set && mode() == PlotterMode::print_plot) {
    return violate("feed in print-plot mode");
  }
  feed();
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVersatec::do_function(PlotterFunction function) {
  switch (function) {
    case PlotterFunction::reset:
      drop_page();
      readiness_ = Readiness::reset;
      return DeviceStatus::ok;
    case PlotterFunction::clear:
      return do_clear();
    case PlotterFunction::end_of_transmission:
      return do_feed("end of transmission within a line");
    case PlotterFunction::form_feed:
      return do_feed("form feed within a line");
    case PlotterFunction::terminate:
      return in_line() ? fill_line() : violate("terminate without a line begun");
    case PlotterFunction::auto_step:
      return violate("a Versatec has no auto step");
  }
  return violate("no such function");
}

DeviceStatus SimulatedVersatec::check_write(std::span<const std::uint8_t>) {
  return readiness_ == Readiness::mode_set ? DeviceStatus::ok : violate("write before a mode is set");
}

DeviceStatus SimulatedVersatec::print(std::uint8_t byte) {
  constexpr std::uint8_t eot = 4;
  if (byte == '\f' || byte == eot) return do_feed("feed within a line");
  if (byte == '\n' || byte == '\r' || byte == 0) return DeviceStatus::ok;
  return violate("byte that print mode does not take");
}

const char* SimulatedVersatec::unfinished() const { return "job closed without a form feed or end of transmission"; }

DeviceStatus SimulatedVarian::enter_mode() {
  mode_set_ = true;
  steps_ = false;
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVarian::do_function(PlotterFunction function) {
  if (function != PlotterFunction::auto_step) return violate("a Varian has no such function");
  if (in_line()) return violate("auto step within a line");
  if (!mode_set_ || mode() != PlotterMode::plot) return violate("auto step before plot mode");
  steps_ = true;
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVarian::check_write(std::span<const std::uint8_t> bytes) {
  if (!mode_set_) return violate("write before a mode is set");
  if (bytes.size() % 2 != 0) return violate("transfer of an odd number of bytes");
  if (mode() == PlotterMode::plot && !steps_) return violate("dots without auto step");
  return DeviceStatus::ok;
}

DeviceStatus SimulatedVarian::print(std::uint8_t byte) {
  if (byte != '\f' && byte != '\n' && byte != 0) return violate("byte that print mode does not take");
  if (byte == '\f') feed();
  return DeviceStatus::ok;
}

const char* SimulatedVarian::unfinished() const { return "job closed without a form feed"; }

}  // namespace halfspace
