// byte_writer.hpp - collects a driver's small writes into blocks, and remembers the first error.
// After an error everything put is dropped until reset(): a driver looks at the status once per call of its
// own.
#pragma once

#include <array>
#include <charconv>
#include <string_view>

#include "drivers/write_all.hpp"

namespace halfspace {

class ByteWriter {
 public:
  ByteWriter(ByteSink& sink, Clock& clock) : sink_(sink), clock_(clock) {}

  void reset() {
    used_ = 0;
    status_ = DeviceStatus::ok;
  }

  void put(std::uint8_t byte) {
    if (used_ == block_.size()) (void)flush();
    block_[used_++] = byte;
  }

  void put(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) put(byte);
  }

  void put(std::string_view text) {
    for (const char c : text) put(static_cast<std::uint8_t>(c));
  }

  void put_number(std::int32_t value) {
    std::array<char, 11> digits{};  // -2147483648 is the longest
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    put(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
  }

  [[nodiscard]] DeviceStatus status() const { return status_; }

  DeviceStatus flush() {
    if (status_ == DeviceStatus::ok) {
      status_ = write_all(sink_, clock_, std::span(block_).first(used_)).status;
    }
    used_ = 0;
    return status_;
  }

 private:
  ByteSink& sink_;
  Clock& clock_;
  DeviceStatus status_ = DeviceStatus::ok;
  std::size_t used_ = 0;
  std::array<std::uint8_t, 1024> block_{};
};

}  // namespace halfspace
