// job_bytes.hpp - the numbers of a job as bytes: what firmware/core/job_reader.hpp reads back.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <span>
#include <vector>

namespace halfspace {

class JobBytes {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void unsigned_number(std::uint64_t value);  // varint
  void number(std::int64_t value);            // zigzag varint
  void wide(const mpz_class& value);          // length, then two's complement

  void append(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::span<const std::uint8_t> between(std::size_t first, std::size_t last) const {
    return std::span(bytes_).subspan(first, last - first);
  }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

// Bits of |value|; 0 for 0.
[[nodiscard]] inline int bits_of(const mpz_class& value) {
  return value == 0 ? 0 : static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

}  // namespace halfspace
