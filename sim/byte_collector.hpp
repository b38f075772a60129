// byte_collector.hpp - the far end of a byte stream: keeps what it is sent, with faults and partial writes on
// demand.
#pragma once

#include <algorithm>
#include <vector>

#include "hal/byte_sink.hpp"
#include "sim/fault.hpp"

namespace halfspace {

class ByteCollector final : public ByteSink {
 public:
  Accepted write(std::span<const std::uint8_t> bytes) override {
    if (const DeviceStatus fault = faults_.next_call(); fault != DeviceStatus::ok) return {fault, 0};
    const std::size_t count = std::min(bytes.size(), transfer_limit_);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return {DeviceStatus::ok, count};
  }

  void set_fault(const Fault& fault) { faults_.set(fault); }
  void limit_transfer(std::size_t bytes) { transfer_limit_ = bytes; }
  void clear() { bytes_.clear(); }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] std::size_t calls() const { return faults_.calls(); }

 private:
  std::size_t transfer_limit_ = SIZE_MAX;
  std::vector<std::uint8_t> bytes_;
  FaultLine faults_;
};

}  // namespace halfspace
