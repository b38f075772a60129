#include "host/algebra/content.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

namespace halfspace {
namespace {

static_assert(GMP_NUMB_BITS == 64);

// v != 0.
mp_bitcnt_t trailing_zeros(const mpz_class& v) {
  const mp_limb_t low = mpz_getlimbn(v.get_mpz_t(), 0);
  return low != 0 ? static_cast<mp_bitcnt_t>(std::countr_zero(low)) : mpz_scan1(v.get_mpz_t(), 0);
}

bool is_power_of_two(const mpz_class& v, mp_bitcnt_t zeros) {
  const auto top = static_cast<mp_size_t>(mpz_size(v.get_mpz_t())) - 1;
  const mp_limb_t limb = mpz_getlimbn(v.get_mpz_t(), top);
  return std::has_single_bit(limb) && zeros >= static_cast<mp_bitcnt_t>(64 * top);
}

// None: nothing tells that the content is a power of two.
std::optional<mp_bitcnt_t> twos_of_content(std::span<const mpz_class> all) {
  mp_bitcnt_t least = std::numeric_limits<mp_bitcnt_t>::max();
  bool is_told = false;
  for (const mpz_class& v : all) {
    if (sgn(v) == 0) continue;
    const mp_bitcnt_t zeros = trailing_zeros(v);
    least = std::min(least, zeros);
    is_told = is_told || is_power_of_two(v, zeros);
  }
  return is_told ? std::optional(least) : std::nullopt;
}

mpz_class common_divisor(std::span<const mpz_class> all) {
  mpz_class common = 0;
  for (const mpz_class& v : all) {
    if (sgn(v) == 0) continue;
    mpz_gcd(common.get_mpz_t(), common.get_mpz_t(), v.get_mpz_t());
    if (common == 1) break;
  }
  return common;
}

}  // namespace

mpz_class content(std::span<const mpz_class> all) {
  if (const auto twos = twos_of_content(all)) return mpz_class(1) << *twos;
  return common_divisor(all);
}

void divide_by_content(std::span<mpz_class> all) {
  if (const auto twos = twos_of_content(all)) {
    if (*twos == 0) return;
    for (mpz_class& v : all) mpz_tdiv_q_2exp(v.get_mpz_t(), v.get_mpz_t(), *twos);
    return;
  }
  const mpz_class common = common_divisor(all);
  if (common <= 1) return;
  for (mpz_class& v : all) mpz_divexact(v.get_mpz_t(), v.get_mpz_t(), common.get_mpz_t());
}

}  // namespace halfspace
