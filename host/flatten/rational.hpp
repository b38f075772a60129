// rational.hpp - small integers that given numbers are exact multiples of, where there are any.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/flatten/real.hpp"

namespace halfspace {

// Integers up to 2^bits in the proportions of `values`, by continued fractions of their ratios to the largest; none
// unless they meet every ratio to within 2^-84. Not all values are 0. That a ratio of no meaning passes by chance has
// a probability of 2^(2 bits - 84), and then it is as close as any other rounding.
[[nodiscard]] std::optional<std::vector<mpz_class>> small_proportions(std::span<const Real> values, int bits);

// A decimal literal, exactly: digits 10^exponent.
struct Decimal {
  mpz_class digits;
  long exponent = 0;
};
[[nodiscard]] Decimal decimal_of(const std::string& text);
[[nodiscard]] mpq_class decimal_to_rational(const std::string& text);
[[nodiscard]] mpz_class power_of_ten(long exponent);  // not negative

}  // namespace halfspace
