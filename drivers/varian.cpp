#include "drivers/varian.hpp"

namespace halfspace {

DeviceStatus VarianDriver::start() {
  if (const DeviceStatus status = set_mode(PlotterMode::plot); status != DeviceStatus::ok) return status;
  return function(PlotterFunction::auto_step);
}

DeviceStatus VarianDriver::finish() {
  constexpr std::array<std::uint8_t, 2> eject{'\f', 0};
  if (const DeviceStatus status = set_mode(PlotterMode::print); status != DeviceStatus::ok) return status;
  return send_text(eject);
}

DeviceStatus VarianDriver::recover() {
  if (const DeviceStatus status = fill_line(); status != DeviceStatus::ok) return status;
  return finish();
}

}  // namespace halfspace
