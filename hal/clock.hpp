// clock.hpp - time for deadlines: no driver waits without one.
#pragma once

#include <cstdint>

#include "hal/device_status.hpp"

namespace halfspace {

class Clock {
 public:
  // Milliseconds since any fixed moment. Wraps after 49 days: differences stay right.
  [[nodiscard]] virtual std::uint32_t now_ms() = 0;
  // Called while a driver waits: sleep, yield or wait for an interrupt, at most about a millisecond.
  virtual void pause() = 0;

 protected:
  ~Clock() = default;
};

// Makes the same call until it is no longer busy; timeout once it has stayed busy for patience_ms.
// The call is made at least once, and once more after the last pause.
template <typename Call>
DeviceStatus retry_while_busy(Clock& clock, std::uint32_t patience_ms, Call call) {
  const std::uint32_t start = clock.now_ms();
  for (;;) {
    const bool last = clock.now_ms() - start >= patience_ms;
    const DeviceStatus status = call();
    if (status != DeviceStatus::busy) return status;
    if (last) return DeviceStatus::timeout;
    clock.pause();
  }
}

}  // namespace halfspace
