#include "host/flatten/rational.hpp"

#include <cctype>
#include <cstdlib>

namespace halfspace {
namespace {

Real distance_to_whole(Real v) { return magnitude(v - nearest_whole(v)); }

// The least convergent denominator, up to `limit`, that takes v to within 2^-60 of an integer; 0 if there is none.
Real denominator_of(Real v, Real limit) {
  const Real near = power_of_two(-60);
  Real rest = v - nearest_whole(v);
  Real before = 0;
  Real current = 1;
  while (current <= limit) {
    if (distance_to_whole(current * v) <= near) return current;
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
  Real common = 1;
  for (const Real v : values) {
    const Real factor = denominator_of(v / most * common, limit / common);
    if (factor == 0) return std::nullopt;
    common *= factor;
  }
  std::vector<mpz_class> result;
  for (const Real v : values) {
    if (distance_to_whole(v / most * common) > power_of_two(-60)) return std::nullopt;
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
  const mpz_class whole(digits);
  mpq_class result = exponent < 0 ? mpq_class(whole, power) : mpq_class(whole * power);
  result.canonicalize();
  return result;
}

}  // namespace halfspace
