// device_status.hpp - how every device, port and driver reports: a value, never an exception.
#pragma once

#include <cstdint>

namespace halfspace {

enum class [[nodiscard]] DeviceStatus : std::uint8_t{
    ok,
    busy,          // nothing was taken: make the same call again
    out_of_order,  // a call or a band that the order of raster_device.hpp forbids
    bad_page,      // a page of the wrong dot format, or levels and background out of range
    bad_band,      // a band whose bytes do not match its rows
    too_large,     // a page wider or higher than the device
    offline,       // the device is there, but switched off line
    no_paper,
    protocol,  // the device refused what was sent: a defect of the driver
    io,        // the bytes could not be carried
    timeout    // the device stayed busy beyond the driver's patience
};

// What went wrong and its remedy, for a person.
[[nodiscard]] constexpr const char* describe(DeviceStatus status) {
  switch (status) {
    case DeviceStatus::ok:
      return "no error";
    case DeviceStatus::busy:
      return "the device is busy: try again when it is free";
    case DeviceStatus::out_of_order:
      return "bands out of order: begin a page, send its bands top to bottom, end it";
    case DeviceStatus::bad_page:
      return "the page does not suit the device: check dot format, levels and background";
    case DeviceStatus::bad_band:
      return "a band's bytes do not match its rows";
    case DeviceStatus::too_large:
      return "the page is larger than the device: choose a smaller --size";
    case DeviceStatus::offline:
      return "the device is off line: switch it on line";
    case DeviceStatus::no_paper:
      return "the device is out of paper: load paper";
    case DeviceStatus::protocol:
      return "the device refused the driver's commands: please report this";
    case DeviceStatus::io:
      return "the bytes could not be carried to the device: check cable, file or disk";
    case DeviceStatus::timeout:
      return "the device stayed busy too long: check it, then print again";
  }
  return "unknown status";
}

}  // namespace halfspace
