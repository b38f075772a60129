// byte_sink.hpp - where a driver's bytes go: a file, a pipe, a USB end point, a simulator.
// Order   Bytes arrive in the order they are written; a write may take only the first of them.
// Owner   The bytes are lent until write returns.
// Errors  count > 0 only with ok. ok with count 0 means busy. Any other status: nothing of this call was
// taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/device_status.hpp"

namespace halfspace {

struct [[nodiscard]] Accepted {
  DeviceStatus status = DeviceStatus::ok;
  std::size_t count = 0;  // bytes taken
};

class ByteSink {
 public:
  virtual Accepted write(std::span<const std::uint8_t> bytes) = 0;

 protected:
  ~ByteSink() = default;
};

}  // namespace halfspace
