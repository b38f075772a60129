// content.hpp - the greatest common divisor of several integers, which is most often a power of two.
#pragma once

#include <gmpxx.h>

#include <span>

namespace halfspace {

// Not negative; 0 where all are 0.
[[nodiscard]] mpz_class content(std::span<const mpz_class> all);

// Nothing where all are 0.
void divide_by_content(std::span<mpz_class> all);

}  // namespace halfspace
