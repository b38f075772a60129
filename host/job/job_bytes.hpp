// job_bytes.hpp - the numbers of a job as bytes: what firmware/core/job_reader.hpp reads back.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace halfspace {

class JobBytes {
 public:
  void byte(std::uint8_t value) { *room(1) = value; }
  void unsigned_number(std::uint64_t value);  // varint
  void number(std::int64_t value);            // zigzag varint
  void wide(const mpz_class& value);          // length, then two's complement

  void append(std::span<const std::uint8_t> bytes) { std::copy(bytes.begin(), bytes.end(), room(bytes.size())); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const std::uint8_t> between(std::size_t first, std::size_t last) const {
    return std::span(bytes_).subspan(first, last - first);
  }
  [[nodiscard]] std::vector<std::uint8_t> take() {
    bytes_.resize(std::exchange(size_, 0));
    return std::move(bytes_);
  }

 private:
  // For `count` bytes more, with 8 behind them that may be written to.
  std::uint8_t* room(std::size_t count) {
    const std::size_t first = std::exchange(size_, size_ + count);
    if (bytes_.size() < size_ + 8) grow();
    return &bytes_[first];
  }

  void grow();

  std::vector<std::uint8_t> bytes_;  // the first size_ of them
  std::size_t size_ = 0;
};

// Bits of |value|; 0 for 0.
[[nodiscard]] inline int bits_of(const mpz_class& value) {
  return value == 0 ? 0 : static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

}  // namespace halfspace
