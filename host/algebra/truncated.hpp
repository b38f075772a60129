// truncated.hpp - an integer as a double, cut as mpz_get_d cuts it, in a quarter of the instructions where it has one limb.
#pragma once

#include <gmpxx.h>

#include <bit>

namespace halfspace {

[[nodiscard]] inline double truncated(const mpz_class& value) {
  static_assert(GMP_NUMB_BITS == 64);
  if (mpz_size(value.get_mpz_t()) > 1) return value.get_d();
  const mp_limb_t limb = mpz_getlimbn(value.get_mpz_t(), 0);
  const int excess = static_cast<int>(std::bit_width(limb)) - 53;
  const auto size = static_cast<double>(excess > 0 ? limb >> excess << excess : limb);
  return sgn(value) < 0 ? -size : size;
}

}  // namespace halfspace
