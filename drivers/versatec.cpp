#include "drivers/versatec.hpp"

namespace halfspace {

DeviceStatus VersatecDriver::start() {
  if (const DeviceStatus status = function(PlotterFunction::reset); status != DeviceStatus::ok) return status;
  if (const DeviceStatus status = function(PlotterFunction::clear); status != DeviceStatus::ok) return status;
  return set_mode(PlotterMode::plot);
}

DeviceStatus VersatecDriver::finish() {
  constexpr std::array<std::uint8_t, 6> past_the_toner{'\n', '\n', '\n', '\n', '\n', 0};
  if (const DeviceStatus status = set_mode(PlotterMode::print); status != DeviceStatus::ok) return status;
  if (const DeviceStatus status = send_text(past_the_toner); status != DeviceStatus::ok) return status;
  return function(PlotterFunction::end_of_transmission);
}

DeviceStatus VersatecDriver::recover() {
  if (const DeviceStatus status = function(PlotterFunction::reset); status != DeviceStatus::ok) return status;
  if (const DeviceStatus status = function(PlotterFunction::clear); status != DeviceStatus::ok) return status;
  return function(PlotterFunction::end_of_transmission);
}

}  // namespace halfspace
