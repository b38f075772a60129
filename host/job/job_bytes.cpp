#include "host/job/job_bytes.hpp"

#include <bit>

namespace halfspace {

void JobBytes::grow() { bytes_.resize(2 * size_ + 64); }

void JobBytes::unsigned_number(std::uint64_t value) {
  constexpr std::size_t longest = 10;
  std::uint8_t* const first = room(longest);
  std::uint8_t* out = first;
  for (; value >= 0x80U; value >>= 7) *out++ = static_cast<std::uint8_t>(value | 0x80U);
  *out++ = static_cast<std::uint8_t>(value);
  size_ -= longest - static_cast<std::size_t>(out - first);
}

void JobBytes::number(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  unsigned_number(value < 0 ? ~(bits << 1) : bits << 1);
}

void JobBytes::wide(const mpz_class& value) {
  if (sgn(value) == 0) return byte(0);
  // n bytes hold -2^(8n-1) .. 2^(8n-1) - 1; a negative value -v is the complement of v - 1.
  static_assert(GMP_NUMB_BITS == 64);
  const mpz_srcptr size = value.get_mpz_t();
  const auto limbs = static_cast<mp_size_t>(mpz_size(size));
  const bool negative = sgn(value) < 0;
  const mp_limb_t top = mpz_getlimbn(size, limbs - 1);
  const bool is_power =
      negative && std::has_single_bit(top) && mpz_scan1(size, 0) >= 64 * static_cast<mp_bitcnt_t>(limbs - 1);
  const std::size_t bits = 64 * static_cast<std::size_t>(limbs - 1) + static_cast<std::size_t>(std::bit_width(top));
  const std::size_t length = (is_power ? bits - 1 : bits) / 8 + 1;
  byte(static_cast<std::uint8_t>(length));
  std::uint8_t* out = room(length);
  bool carry = negative;
  for (std::size_t i = 0; i < length; i += 8, out += 8) {  // whole limbs
    mp_limb_t limb = mpz_getlimbn(size, static_cast<mp_size_t>(i / 8));
    if (negative) limb = ~limb + (carry ? 1 : 0);
    carry = carry && limb == 0;
    for (std::size_t k = 0; k < 8; ++k) out[k] = static_cast<std::uint8_t>(limb >> (8 * k));
  }
}

}  // namespace halfspace
