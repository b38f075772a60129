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
  // n bytes hold -2^(8n-1) .. 2^(8n-1) - 1; a negative value is written as value + 2^(8n).
  const int length = value == 0 ? 0 : bits_of(value < 0 ? mpz_class(-value - 1) : value) / 8 + 1;
  byte(static_cast<std::uint8_t>(length));
  mpz_class bits = value;
  if (bits < 0) bits += mpz_class(1) << (8 * length);
  const std::size_t start = bytes_.size();
  bytes_.resize(start + static_cast<std::size_t>(length));
  if (bits != 0) mpz_export(bytes_.data() + start, nullptr, -1, 1, 0, 0, bits.get_mpz_t());
}

}  // namespace halfspace
