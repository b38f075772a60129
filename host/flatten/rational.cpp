#include "host/flatten/rational.hpp"

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace halfspace {
namespace {

constexpr int closeness_bits = 84;

bool is_whole(Real v, Real tolerance) { return magnitude(v - nearest_whole(v)) <= tolerance; }

// v times; from its product a compiler would make another division.
Bits128 multiple(Bits128 v, std::uint64_t times) {
  const std::uint64_t high = static_cast<std::uint64_t>(v >> 64) * times;
  return (Bits128{high} << 64) + Bits128{static_cast<std::uint64_t>(v)} * times;
}

// The least convergent denominator d, up to `limit` <= 2^32, that takes d v to within d * tolerance of an integer; 0 if none. Fractions of v
// count to 2^-120, what Euclid leaves of them is by how much d v misses an integer: 2^68 at most where it is tolerated, as d times its
// tolerance is, while the one before is 2^119 / d or more, at least 2^19 times as much.
Real denominator_of(Real v, Real limit, Real tolerance) {
  constexpr int unit_bits = 120;
  const auto most = static_cast<std::uint64_t>(limit);
  const Bits128 tolerated = whole_bits(times_power_of_two(tolerance, unit_bits));  // 2^68 at most
  Bits128 whole = Bits128{1} << unit_bits;
  Bits128 rest = whole_bits(times_power_of_two(v - floor_of(v), unit_bits));
  std::uint64_t before = 0;
  std::uint64_t current = 1;
  while (current <= most) {
    std::uint64_t quotient = 0;
    for (; whole >= rest && quotient < 8; ++quotient) whole -= rest;  // there are seldom more
    if (whole >= rest) {
      if (rest <= current * tolerated) return Real(current);
      const Bits128 more = whole / rest;
      if (more > most) return 0;
      quotient += static_cast<std::uint64_t>(more);
      whole -= multiple(rest, static_cast<std::uint64_t>(more));
    }
    if (quotient > most) return 0;
    std::swap(whole, rest);
    before = std::exchange(current, quotient * current + before);
  }
  return 0;
}

}  // namespace

std::optional<std::vector<mpz_class>> small_proportions(std::span<const Real> values, int bits) {
  Real most = 0;
  for (const Real v : values) most = larger(most, magnitude(v));
  const Real limit = power_of_two(bits);
  const Real tolerance = power_of_two(-closeness_bits);
  Real common = 1;
  const auto times_common = [&common](Real v) { return common.is_one() ? v : v * common; };
  for (const Real v : values) {
    if (is_zero(v) || v.size_bits() == most.size_bits()) continue;
    const Real factor = denominator_of(times_common(v / most), limit / common, times_common(tolerance));
    if (factor == 0) return std::nullopt;
    common *= factor;
  }
  std::vector<mpz_class> result;
  for (const Real v : values) {
    if (!is_whole(v / most * common, common * tolerance)) return std::nullopt;
    result.push_back(round_to_integer(v / most * common));
  }
  return result;
}

// Digits are gathered in a word, as many as one holds.
Decimal decimal_of(const std::string& text) {
  constexpr std::uint64_t most = 1'000'000'000'000'000'000;
  Decimal result;
  std::uint64_t gathered = 0;
  std::uint64_t power = 1;
  const auto flush = [&] {
    result.digits = result.digits * power + gathered;
    gathered = 0;
    power = 1;
  };
  bool fraction = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= '0' && c <= '9') {
      if (power == most) flush();
      gathered = gathered * 10 + static_cast<std::uint64_t>(c - '0');
      power *= 10;
      if (fraction) --result.exponent;
    } else if (c == '.') {
      fraction = true;
    } else if (c == 'e' || c == 'E') {
      result.exponent += std::strtol(text.c_str() + i + 1, nullptr, 10);
      break;
    }
  }
  flush();
  if (text.front() == '-') mpz_neg(result.digits.get_mpz_t(), result.digits.get_mpz_t());
  return result;
}

mpq_class decimal_to_rational(const std::string& text) {
  const auto [digits, exponent] = decimal_of(text);
  const mpz_class power = power_of_ten(std::labs(exponent));
  mpq_class result = exponent < 0 ? mpq_class(digits, power) : mpq_class(digits * power);
  result.canonicalize();
  return result;
}

mpz_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

}  // namespace halfspace
