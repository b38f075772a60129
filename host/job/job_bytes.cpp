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
  mpz_class rest = value;
  if (rest < 0) rest += mpz_class(1) << (8 * length);
  for (int i = 0; i < length; ++i) {
    byte(static_cast<std::uint8_t>(mpz_class(rest & 0xff).get_ui()));
    rest >>= 8;
  }
}

}  // namespace halfspace
