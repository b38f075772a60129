#include "host/job/job_bytes.hpp"

#include <algorithm>

namespace halfspace {

void JobBytes::unsigned_number(std::uint64_t value) {
  while (value >= 0x80U) {
    byte(static_cast<std::uint8_t>(value | 0x80U));
    value >>= 7;
  }
  byte(static_cast<std::uint8_t>(value));
}

void JobBytes::number(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  unsigned_number(value < 0 ? ~(bits << 1) : bits << 1);
}

void JobBytes::wide(const mpz_class& value) {
  if (sgn(value) == 0) return byte(0);
  // n bytes hold -2^(8n-1) .. 2^(8n-1) - 1; a negative value -v is the complement of v, and 1 more: of v's lowest 1 and what is below
  // it nothing changes.
  static_assert(GMP_NUMB_BITS == 64);
  const mpz_srcptr size = value.get_mpz_t();
  const bool negative = sgn(value) < 0;
  const std::size_t bits = mpz_sizeinbase(size, 2);
  const bool is_power = negative && mpn_scan1(mpz_limbs_read(size), 0) + 1 == bits;
  const std::size_t length = (is_power ? bits - 1 : bits) / 8 + 1;
  byte(static_cast<std::uint8_t>(length));
  const std::size_t end = bytes_.size() + length;
  bytes_.resize(end + 7);  // whole limbs
  std::uint8_t* out = &bytes_[end - length];
  bool carry = negative;
  for (std::size_t i = 0; i < length; i += 8, out += 8) {
    mp_limb_t limb = mpz_getlimbn(size, static_cast<mp_size_t>(i / 8));
    if (negative) limb = ~limb + (carry ? 1 : 0);
    carry = carry && limb == 0;
    for (std::size_t k = 0; k < 8; ++k) out[k] = static_cast<std::uint8_t>(limb >> (8 * k));
  }
  bytes_.resize(end);
}

}  // namespace halfspace
