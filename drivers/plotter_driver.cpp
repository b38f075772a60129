#include "drivers/plotter_driver.hpp"

#include <algorithm>

namespace halfspace {

DeviceStatus PlotterDriver::set_mode(PlotterMode mode) {
  return retry_while_busy(clock_, driver_patience_ms, [&] { return port_.set_mode(mode); });
}

DeviceStatus PlotterDriver::function(PlotterFunction function) {
  return retry_while_busy(clock_, driver_patience_ms, [&] { return port_.function(function); });
}

DeviceStatus PlotterDriver::send_text(std::span<const std::uint8_t> bytes) {
  return write_all(port_, clock_, bytes, PlotterPort::transfer_limit).status;
}

DeviceStatus PlotterDriver::send_dots(std::span<const std::uint8_t> bytes) {
  const Accepted sent = write_all(port_, clock_, bytes, PlotterPort::transfer_limit);
  line_phase_ = (line_phase_ + sent.count) % line_bytes_;
  return sent.status;
}

DeviceStatus PlotterDriver::fill_line() {
  if (line_phase_ == 0) return DeviceStatus::ok;
  const auto blank = std::span(buffer_).first(line_bytes_ - line_phase_);
  std::fill(blank.begin(), blank.end(), std::uint8_t{0});
  return send_dots(blank);
}

DeviceStatus PlotterDriver::flush() {
  const std::size_t count = staged_;
  staged_ = 0;
  return send_dots(std::span(buffer_).first(count));
}

DeviceStatus PlotterDriver::stage(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const std::size_t count = std::min(bytes.size(), buffer_.size() - staged_);
    std::copy_n(bytes.begin(), count, buffer_.begin() + static_cast<std::ptrdiff_t>(staged_));
    staged_ += count;
    bytes = bytes.subspan(count);
    if (staged_ < buffer_.size()) continue;
    if (const DeviceStatus status = flush(); status != DeviceStatus::ok) return status;
  }
  return DeviceStatus::ok;
}

DeviceStatus PlotterDriver::stage_blank(std::size_t count) {
  constexpr std::array<std::uint8_t, 64> blank{};
  DeviceStatus status = DeviceStatus::ok;
  while (count > 0 && status == DeviceStatus::ok) {
    const std::size_t piece = std::min(count, blank.size());
    status = stage(std::span(blank).first(piece));
    count -= piece;
  }
  return status;
}

DeviceStatus PlotterDriver::do_begin_page(const Page&) {
  if (dirty_) {
    if (const DeviceStatus status = recover(); status != DeviceStatus::ok) return status;
  }
  staged_ = 0;
  line_phase_ = 0;
  dirty_ = true;
  return start();
}

DeviceStatus PlotterDriver::do_put_band(const Band& band) {
  const std::size_t row_bytes = page().row_bytes();
  DeviceStatus status = DeviceStatus::ok;
  for (auto rest = band.bytes; !rest.empty() && status == DeviceStatus::ok; rest = rest.subspan(row_bytes)) {
    status = stage(rest.first(row_bytes));
    if (status == DeviceStatus::ok) status = stage_blank(line_bytes_ - row_bytes);
  }
  return status;
}

DeviceStatus PlotterDriver::do_end_page() {
  if (const DeviceStatus status = flush(); status != DeviceStatus::ok) return status;
  const DeviceStatus status = finish();
  if (status == DeviceStatus::ok) dirty_ = false;
  return status;
}

void PlotterDriver::do_abort() {
  if (dirty_ && recover() == DeviceStatus::ok) dirty_ = false;
}

}  // namespace halfspace
