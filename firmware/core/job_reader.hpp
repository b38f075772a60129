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
    constexpr int limb_bytes = limb_bits / 8;
    const int length = byte();
    if (length > Bits / 8) failed_ = true;
    Wide<Bits> value;
    const int limbs = failed_ ? 0 : (length + limb_bytes - 1) / limb_bytes;
    bool negative = false;
    for (int i = 0; i < limbs; ++i) {
      const int bits = 8 * std::min(length - i * limb_bytes, limb_bytes);
      Limb limb = 0;
      for (int at = 0; at < bits; at += 8) limb |= static_cast<Limb>(byte()) << at;
      negative = (limb >> (bits - 1)) != 0;
      if (negative && bits < limb_bits) limb |= ~Limb{0} << bits;
      value.set_limb(i, limb);
    }
    for (int i = limbs; negative && i < Wide<Bits>::limbs; ++i) value.set_limb(i, ~Limb{0});
    return failed_ ? Wide<Bits>() : value;
  }

  // A record's reader found a value that cannot be.
  void fail() { failed_ = true; }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool refill();
  std::uint64_t varint(int max_bits);

  ByteSource& source_;
  std::array<std::uint8_t, 64> buffer_{};
  std::size_t next_ = 0, end_ = 0;
  bool failed_ = false;
};

// Reads magic and header. False: not a job, a version this core does not know, or values out of range.
[[nodiscard]] bool read_header(JobReader& in, JobHeader& header);

}  // namespace halfspace
