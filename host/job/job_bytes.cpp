#include "host/job/job_bytes.hpp"

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
  // n bytes hold -2^(8n-1) .. 2^(8n-1) - 1; a negative value -v is written as the complement of v - 1.
  const bool negative = sgn(value) < 0;
  const mpz_class below = negative ? mpz_class(-value - 1) : mpz_class();
  const mpz_srcptr bits = negative ? below.get_mpz_t() : value.get_mpz_t();
  const std::size_t length = sgn(value) == 0 ? 0 : (mpz_sgn(bits) == 0 ? 0 : mpz_sizeinbase(bits, 2)) / 8 + 1;
  static_assert(GMP_NUMB_BITS == 64);
  byte(static_cast<std::uint8_t>(length));
  for (std::size_t i = 0; i < length; ++i) {
    const auto part = static_cast<std::uint8_t>(mpz_getlimbn(bits, static_cast<mp_size_t>(i / 8)) >> (8 * (i % 8)));
    byte(negative ? static_cast<std::uint8_t>(~part) : part);
  }
}

}  // namespace halfspace
