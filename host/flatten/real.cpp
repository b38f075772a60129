#include "host/flatten/real.hpp"

#include <mpfr.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace halfspace {
namespace {

// IEEE binary128 as two words: 112 bits of fraction below 15 of exponent and the sign.
using Words = std::array<std::uint64_t, 2>;
static_assert(std::endian::native == std::endian::little && sizeof(Real) == sizeof(Words));
constexpr int exponent_bias = 16383;
constexpr int fraction_bits = 112;

struct Parts {
  mpz_class mantissa;  // signed, below 2^113
  int exponent = 0;    // value = mantissa * 2^exponent
};

// Subnormal numbers (below 10^-4931) count as 0.
Parts parts_of(Real v) {
  const auto words = std::bit_cast<Words>(v);
  const int biased = static_cast<int>(words[1] >> 48 & 0x7fff);
  if (biased == 0) return {};
  Parts parts;
  const std::uint64_t high = (words[1] & 0xffffffffffffU) | 0x1000000000000U;
  const Words mantissa{words[0], high};
  mpz_import(parts.mantissa.get_mpz_t(), 2, -1, sizeof(std::uint64_t), 0, 0, mantissa.data());
  if (words[1] >> 63 != 0) parts.mantissa = -parts.mantissa;
  parts.exponent = biased - exponent_bias - fraction_bits;
  return parts;
}

// m * 2^exponent, m cut to its 113 leading bits.
Real scaled(const mpz_class& m, long exponent) {
  if (m == 0) return 0;
  mpz_class top = abs(m);
  const long excess = static_cast<long>(mpz_sizeinbase(top.get_mpz_t(), 2)) - (fraction_bits + 1);
  if (excess > 0) {
    top >>= static_cast<unsigned long>(excess);
    exponent += excess;
  }
  Words words{};
  mpz_export(words.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, top.get_mpz_t());
  const Real whole = Real(words[1]) * power_of_two(64) + Real(words[0]);
  const long limit = exponent_bias - fraction_bits - 1;
  if (exponent > limit) return (m < 0 ? -1 : 1) * power_of_two(exponent_bias) * 2;  // infinite
  if (exponent < -limit) return 0;
  return (m < 0 ? -whole : whole) * power_of_two(static_cast<int>(exponent));
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
  if (!(v > 0)) return 0;
  Parts parts = parts_of(v);
  const int shift = 114 + (parts.exponent & 1);  // the exponent left over must be even
  parts.mantissa <<= static_cast<unsigned long>(shift);
  return scaled(sqrt(parts.mantissa), (parts.exponent - shift) / 2);
}

Real decimal_to_real(const std::string& text) {
  Mpfr value(fraction_bits + 1);
  mpfr_set_str(value.get(), text.c_str(), 10, MPFR_RNDN);
  return value.to_real();
}

Real to_real(const mpz_class& v) { return scaled(v, 0); }

mpz_class round_to_integer(Real v) {
  Parts parts = parts_of(v);
  if (parts.exponent >= 0) return parts.mantissa << static_cast<unsigned long>(parts.exponent);
  const auto shift = static_cast<unsigned long>(-parts.exponent);
  if (shift > fraction_bits + 2) return 0;
  const mpz_class size = (abs(parts.mantissa) + (mpz_class(1) << (shift - 1))) >> shift;
  return v < 0 ? mpz_class(-size) : size;
}

Real nearest_whole(Real v) { return to_real(round_to_integer(v)); }

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
