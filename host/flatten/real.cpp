#include "host/flatten/real.hpp"

#include <mpfr.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace halfspace {
namespace {

using Words = RealWords;  // 112 bits of fraction below 15 of exponent and the sign
constexpr int exponent_bias = 16383;
constexpr int fraction_bits = 112;

__extension__ using Bits128 = unsigned __int128;

struct Parts {
  Bits128 mantissa = 0;  // below 2^113
  int exponent = 0;      // value = +-mantissa * 2^exponent
  bool negative = false;
};

// Subnormal numbers (below 10^-4931) count as 0.
Parts parts_of(Real v) {
  const auto words = std::bit_cast<Words>(v);
  const int biased = static_cast<int>(words[1] >> 48 & 0x7fff);
  if (biased == 0) return {};
  const std::uint64_t high = (words[1] & 0xffffffffffffU) | 0x1000000000000U;
  return {Bits128{high} << 64 | words[0], biased - exponent_bias - fraction_bits, words[1] >> 63 != 0};
}

int bit_width(Bits128 v) {
  const auto high = static_cast<std::uint64_t>(v >> 64);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(v)));
}

// +-mantissa * 2^exponent, the mantissa cut to its 113 leading bits.
Real composed(Bits128 mantissa, long exponent, bool negative) {
  if (mantissa == 0) return 0;
  const int excess = bit_width(mantissa) - (fraction_bits + 1);
  if (excess > 0) {
    mantissa >>= excess;
    exponent += excess;
  }
  const long limit = exponent_bias - fraction_bits - 1;
  if (exponent > limit) return (negative ? -1 : 1) * power_of_two(exponent_bias) * 2;  // infinite
  if (exponent < -limit) return 0;
  if (excess < 0) {
    mantissa <<= -excess;
    exponent += excess;
  }
  const auto biased = static_cast<std::uint64_t>(exponent + exponent_bias + fraction_bits);
  const std::uint64_t high = static_cast<std::uint64_t>(mantissa >> 64) & 0xffffffffffffU;
  return std::bit_cast<Real>(
      Words{static_cast<std::uint64_t>(mantissa), (negative ? std::uint64_t{1} << 63 : 0) | biased << 48 | high});
}

// m * 2^exponent, m cut to its 113 leading bits.
Real scaled(const mpz_class& m, long exponent) {
  static_assert(GMP_NUMB_BITS == 64);
  const auto excess = static_cast<long>(mpz_sizeinbase(m.get_mpz_t(), 2)) - (fraction_bits + 1);
  if (excess <= 0) {
    const Bits128 mantissa = Bits128{mpz_getlimbn(m.get_mpz_t(), 1)} << 64 | mpz_getlimbn(m.get_mpz_t(), 0);
    return composed(mantissa, exponent, m < 0);
  }
  const mpz_class top = abs(m) >> static_cast<unsigned long>(excess);
  return scaled(m < 0 ? mpz_class(-top) : top, exponent + excess);
}

mpz_class to_integer(Bits128 v, bool negative) {
  const Words words{static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(v >> 64)};
  mpz_class result = words[0];
  if (words[1] != 0) mpz_import(result.get_mpz_t(), 2, -1, sizeof(std::uint64_t), 0, 0, words.data());
  if (negative) mpz_neg(result.get_mpz_t(), result.get_mpz_t());
  return result;
}

// Ties away from zero; the exponent is negative.
Bits128 nearest_whole_of(const Parts& parts) {
  const int shift = -parts.exponent;
  if (shift > fraction_bits + 2) return 0;
  return (parts.mantissa + (Bits128{1} << (shift - 1))) >> shift;
}

class Mpfr {
 public:
  explicit Mpfr(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  ~Mpfr() { mpfr_clear(value_); }
  Mpfr(const Mpfr&) = delete;
  Mpfr& operator=(const Mpfr&) = delete;
  mpfr_ptr get() { return value_; }

  // To the nearest of 113 bits.
  [[nodiscard]] Real to_real() {
    mpfr_prec_round(value_, fraction_bits + 1, MPFR_RNDN);
    if (mpfr_zero_p(value_)) return 0;
    mpz_class mantissa;
    const mpfr_exp_t exponent = mpfr_get_z_2exp(mantissa.get_mpz_t(), value_);
    return scaled(mantissa, exponent);
  }

 private:
  mpfr_t value_;
};

constexpr mpfr_prec_t working_bits = 192;

}  // namespace

Real power_of_two(int exponent) {
  return std::bit_cast<Real>(Words{0, static_cast<std::uint64_t>(exponent + exponent_bias) << 48});
}

Real square_root(Real v) {
  const Parts parts = parts_of(v);
  if (!(v > 0) || parts.mantissa == 0) return 0;
  const int shift = 114 + (parts.exponent & 1);  // the exponent left over must be even
  // mantissa 2^shift, of 227 or 228 bits: four limbs, the lowest of them 0
  const Bits128 high = parts.mantissa << (shift - 64);
  const auto carried = static_cast<std::uint64_t>(parts.mantissa >> (192 - shift));
  const std::array<mp_limb_t, 4> square{0, static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(high >> 64),
                                        carried};
  std::array<mp_limb_t, 2> root{};
  mpn_sqrtrem(root.data(), nullptr, square.data(), 4);
  return composed(Bits128{root[1]} << 64 | root[0], (parts.exponent - shift) / 2, false);
}

Real decimal_to_real(const std::string& text) {
  Mpfr value(fraction_bits + 1);
  mpfr_set_str(value.get(), text.c_str(), 10, MPFR_RNDN);
  return value.to_real();
}

Real to_real(const mpz_class& v) { return scaled(v, 0); }

mpz_class round_to_integer(Real v) {
  const Parts parts = parts_of(v);
  if (parts.exponent < 0) return to_integer(nearest_whole_of(parts), parts.negative);
  return to_integer(parts.mantissa, parts.negative) << static_cast<unsigned long>(parts.exponent);
}

Real nearest_whole(Real v) {
  const Parts parts = parts_of(v);
  if (parts.mantissa == 0) return 0;
  return parts.exponent < 0 ? composed(nearest_whole_of(parts), 0, parts.negative) : v;
}

double double_above(Real v) {
  const auto nearest = static_cast<double>(v);
  if (nearest == 0 && v == 0) return 0;
  return std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

SineCosine sine_cosine_of_degrees(const std::string& text) {
  Mpfr angle(working_bits + 1100);  // every decimal up to 10^308 keeps its position in the turn
  Mpfr sine(working_bits);
  Mpfr cosine(working_bits);
  mpfr_set_str(angle.get(), text.c_str(), 10, MPFR_RNDN);
  mpfr_sinu(sine.get(), angle.get(), 360, MPFR_RNDN);
  mpfr_cosu(cosine.get(), angle.get(), 360, MPFR_RNDN);
  return {sine.to_real(), cosine.to_real()};
}

}  // namespace halfspace
