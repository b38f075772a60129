#include "host/flatten/rational.hpp"

#include <cctype>
#include <cstdlib>

namespace halfspace {
namespace {

constexpr int closeness_bits = 84;

bool is_whole(Real v, Real tolerance) { return magnitude(v - nearest_whole(v)) <= tolerance; }

// The least convergent denominator d, up to `limit`, that takes d v to within d * tolerance of an integer; 0 if none.
Real denominator_of(Real v, Real limit, Real tolerance) {
  Real rest = v - nearest_whole(v);
  Real before = 0;
  Real current = 1;
  while (current <= limit) {
    if (is_whole(current * v, current * tolerance)) return current;
    if (rest == 0) return 0;
    const Real inverse = 1 / rest;
    const Real quotient = nearest_whole(inverse);
    rest = inverse - quotient;
    const Real next = magnitude(quotient * current + before);
    before = quotient < 0 ? -current : current;
    current = next;
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
  for (const Real v : values) {
    const Real factor = denominator_of(v / most * common, limit / common, common * tolerance);
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

mpq_class decimal_to_rational(const std::string& text) {
  std::string digits;
  long exponent = 0;
  bool fraction = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      digits += c;
      if (fraction) --exponent;
    } else if (c == '-') {
      digits += c;
    } else if (c == '.') {
      fraction = true;
    } else if (c == 'e' || c == 'E') {
      exponent += std::strtol(text.c_str() + i + 1, nullptr, 10);
      break;
    }
  }
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
  const mpz_class whole(digits, 10);  // a leading zero must not make it octal
  mpq_class result = exponent < 0 ? mpq_class(whole, power) : mpq_class(whole * power);
  result.canonicalize();
  return result;
}

}  // namespace halfspace
