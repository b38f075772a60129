// job_bytes.hpp - the numbers of a job as bytes: what firmware/core/job_reader.hpp reads back.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace halfspace {

class JobBytes {
 public:
  // Memory for so many, which may still become more.
  void reserve(std::size_t count) { bytes_.resize(std::max(bytes_.size(), count + spare)); }

  void byte(std::uint8_t value) {
    *room(1) = value;
    ++size_;
  }
  // varint
  void unsigned_number(std::uint64_t value) {
    std::uint8_t* out = room(10);
    for (; value >= 0x80U; value >>= 7) *out++ = static_cast<std::uint8_t>(value | 0x80U);
    *out++ = static_cast<std::uint8_t>(value);
    end_at(out);
  }
  // zigzag varint
  void number(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    unsigned_number(value < 0 ? ~(bits << 1) : bits << 1);
  }
  // length, then two's complement
  void wide(const mpz_class& value) {
    const mp_limb_t size = mpz_getlimbn(value.get_mpz_t(), 0);
    if (mpz_size(value.get_mpz_t()) > 1 || size > INT64_MAX) return several_limbs(value);
    const mp_limb_t turned = sgn(value) < 0 ? ~mp_limb_t{0} : 0;
    const auto length =
        size == 0 ? 0 : static_cast<std::size_t>(std::bit_width(size + turned)) / 8 + 1;  // turned: of size - 1
    std::uint8_t* const out = room(1 + length);
    *out = static_cast<std::uint8_t>(length);
    put_limb((size ^ turned) - turned, out + 1);
    size_ += 1 + length;
  }

  void append(std::span<const std::uint8_t> bytes) {
    end_at(std::copy(bytes.begin(), bytes.end(), room(bytes.size())));
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const std::uint8_t> between(std::size_t first, std::size_t last) const {
    return std::span(bytes_).subspan(first, last - first);
  }
  [[nodiscard]] std::vector<std::uint8_t> take() {
    bytes_.resize(std::exchange(size_, 0));
    return std::move(bytes_);
  }

 private:
  static constexpr std::size_t spare = 8;

  // Where the next `count` bytes go, with some to spare that may be written to.
  std::uint8_t* room(std::size_t count) {
    if (bytes_.size() - size_ < count + spare) grow(count);
    return bytes_.data() + size_;
  }
  void several_limbs(const mpz_class& value);
  static void put_limb(mp_limb_t limb, std::uint8_t* out) {
    for (std::size_t k = 0; k < 8; ++k) out[k] = static_cast<std::uint8_t>(limb >> (8 * k));
  }
  void end_at(const std::uint8_t* end) { size_ = static_cast<std::size_t>(end - bytes_.data()); }
  [[gnu::noinline]] void grow(std::size_t count);

  std::vector<std::uint8_t> bytes_;  // the first size_ of them
  std::size_t size_ = 0;
};

static_assert(GMP_NUMB_BITS == 64);

// Bits of |value|; 0 for 0.
[[nodiscard]] inline int bits_of(const mpz_class& value) {
  const auto limbs = static_cast<int>(mpz_size(value.get_mpz_t()));
  return limbs == 0 ? 0
                    : 64 * (limbs - 1) + static_cast<int>(std::bit_width(mpz_getlimbn(value.get_mpz_t(), limbs - 1)));
}

}  // namespace halfspace
