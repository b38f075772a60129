// approximate_roots.hpp - the real roots of a cubic or quartic, guessed in floating point and certified in intervals.
#pragma once

#include <vector>

#include "host/algebra/polynomial.hpp"
#include "host/flatten/interval.hpp"

namespace halfspace {

// How many different real roots a squarefree polynomial of degree 3 or 4 has; -1 if it is not squarefree.
// Source  Signs of the discriminant and of the two seminvariants, as in any book on equations.
[[nodiscard]] int count_of_real_roots(const Polynomial& f);

// Disjoint intervals, ascending, in each of which f changes sign; any number of them.
[[nodiscard]] std::vector<Interval> certain_sign_changes(const Polynomial& f);

}  // namespace halfspace
