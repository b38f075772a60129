#include "host/job/job_bytes.hpp"

namespace halfspace {

void JobBytes::grow(std::size_t count) { bytes_.resize(2 * size_ + count + 64); }

// n bytes hold -2^(8n-1) .. 2^(8n-1) - 1; a negative value -v is the complement of v - 1.
void JobBytes::several_limbs(const mpz_class& value) {
  const auto count = mpz_size(value.get_mpz_t());
  const std::span<const mp_limb_t> limbs(mpz_limbs_read(value.get_mpz_t()), count);
  const bool negative = sgn(value) < 0;
  mp_limb_t top = limbs.back();  // of v, or of v - 1
  if (negative && std::all_of(limbs.begin(), limbs.end() - 1, [](mp_limb_t limb) { return limb == 0; })) --top;
  const std::size_t length = (64 * (count - 1) + static_cast<std::size_t>(std::bit_width(top))) / 8 + 1;
  std::uint8_t* out = room(1 + length);
  *out++ = static_cast<std::uint8_t>(length);
  const std::uint8_t* const end = out + length;
  const mp_limb_t turned = negative ? ~mp_limb_t{0} : 0;
  mp_limb_t carry = negative ? 1 : 0;
  for (std::size_t i = 0; out < end; ++i, out += 8) {  // whole limbs
    const mp_limb_t limb = ((i < count ? limbs[i] : 0) ^ turned) + carry;
    if (limb != 0) carry = 0;
    put_limb(limb, out);
  }
  end_at(end);
}

}  // namespace halfspace
