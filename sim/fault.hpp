// fault.hpp - faults as data, for every simulator: what fails, at which call, and for how many calls.
#pragma once

#include <cstdint>

#include "hal/device_status.hpp"

namespace halfspace {

struct Fault {
  static constexpr std::size_t forever = SIZE_MAX;

  DeviceStatus status = DeviceStatus::ok;
  std::size_t at_call = 0;  // calls of the port, of any kind, before it begins
  std::size_t calls = 0;    // how long it lasts
};

class FaultLine {
 public:
  void set(const Fault& fault) { fault_ = fault; }
  [[nodiscard]] std::size_t calls() const { return calls_; }

  // What the next call meets: ok, or the fault.
  DeviceStatus next_call() {
    const std::size_t call = calls_++;
    const bool struck = call >= fault_.at_call && call - fault_.at_call < fault_.calls;
    return struck ? fault_.status : DeviceStatus::ok;
  }

 private:
  Fault fault_;
  std::size_t calls_ = 0;
};

}  // namespace halfspace
