// job_reader.hpp - numbers out of a byte source, a small buffer at a time.
// Errors  A short or malformed job sets failed() and yields zeros from then on; the caller checks once per
// record. Memory  64 bytes of buffer.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/job_format.hpp"
#include "firmware/core/wide.hpp"

namespace halfspace {

class JobReader {
 public:
  explicit JobReader(ByteSource& source) : source_(source) {}

  std::uint8_t byte() {
    if (next_ == end_ && !refill()) return 0;
    return buffer_[next_++];
  }
  std::uint32_t unsigned_number();  // varint, at most 32 bits
  std::int64_t number();            // zigzag varint, at most 64 bits
  // number() where the value must lie in [low, high]; otherwise the job is malformed.
  std::int32_t number_in(std::int32_t low, std::int32_t high);
  // number() where |value| <= limit.
  std::int64_t number_within(std::int64_t limit);

  // A wide number; one that does not fit Bits is malformed.
  template <int Bits>
  Wide<Bits> wide() {
    const int length = byte();
    if (length > Bits / 8) failed_ = true;
    Wide<Bits> value;
    std::uint8_t last = 0;
    for (int i = 0; i < length && !failed_; ++i) {
      last = byte();
      put_byte(value, i, last);
    }
    if ((last & 0x80U) != 0) {
      for (int i = length; i < Bits / 8; ++i) put_byte(value, i, 0xff);
    }
    return failed_ ? Wide<Bits>() : value;
  }

  // A record's reader found a value that cannot be.
  void fail() { failed_ = true; }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool refill();
  std::uint64_t varint(int max_bits);

  template <int Bits>
  static void put_byte(Wide<Bits>& value, int i, std::uint8_t b) {
    constexpr int per_limb = limb_bits / 8;
    const Limb shifted = static_cast<Limb>(b) << (i % per_limb * 8);
    value.set_limb(i / per_limb, value.limb(i / per_limb) | shifted);
  }

  ByteSource& source_;
  std::array<std::uint8_t, 64> buffer_{};
  std::size_t next_ = 0, end_ = 0;
  bool failed_ = false;
};

// Reads magic and header. False: not a job, a version this core does not know, or values out of range.
[[nodiscard]] bool read_header(JobReader& in, JobHeader& header);

}  // namespace halfspace
