// rational.hpp - small integers that given numbers are exact multiples of, where there are any.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/flatten/real.hpp"

namespace halfspace {

// Integers below 2^bits in the proportions of `values`, by continued fractions of their ratios to the largest; none
// unless every ratio is met to within 2^-60 of an integer. Not all values are 0.
// A chance hit would need a ratio that is within 2^-60 of a fraction with a denominator below 2^bits, bits <= 40.
[[nodiscard]] std::optional<std::vector<mpz_class>> small_proportions(std::span<const Real> values, int bits);

// A decimal literal, exactly.
[[nodiscard]] mpq_class decimal_to_rational(const std::string& text);

}  // namespace halfspace
