// display_port.hpp - the wires of a small display controller: commands and data, told apart by a pin or a
// byte.
//   SPI: the D/C pin is low for a command, high for data. I2C: control byte 0x00 before commands, 0x40 before
//   data.
// Order   One command call carries whole commands, each with all its arguments.
// Errors  All of the bytes are taken, or (any status but ok) none. busy: make the same call again.
#pragma once

#include <cstdint>
#include <span>

#include "hal/device_status.hpp"

namespace halfspace {

class DisplayPort {
 public:
  virtual DeviceStatus command(std::span<const std::uint8_t> bytes) = 0;
  virtual DeviceStatus data(std::span<const std::uint8_t> bytes) = 0;

 protected:
  ~DisplayPort() = default;
};

}  // namespace halfspace
