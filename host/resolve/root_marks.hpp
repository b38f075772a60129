// root_marks.hpp - between which scan lines, or exactly on which, the real roots of an integer polynomial lie.
// Since only dots matter, a root's floor and whether it is an integer are all the resolver needs of it.
//   mark 2 i      a root lies on line i
//   mark 2 i + 1  a root may lie strictly between the lines i and i + 1
// Promise  Every real root in [first, last] has its mark. A mark 2 i is always a root; a mark 2 i + 1 may be one too many:
//          an extremum there came close to 0. Readers only split at marks, so a mark too many costs time, never a dot.
// Exact    Signs on lines are taken in doubles; the exact coefficients are made only where these do not tell.
// Cost     For degree n, n^2/2 bisections of at most log2(last - first) steps: no root is isolated or refined.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "host/algebra/polynomial.hpp"
#include "host/resolve/interval_curve.hpp"
#include "host/resolve/interval_polynomial.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

using Mark = std::int64_t;

// Sorted, none twice. The zero polynomial and constants have none. Of degrees below IntervalPolynomial's capacity.
[[nodiscard]] std::vector<Mark> root_marks(const Polynomial& p, std::int64_t first, std::int64_t last);

// The same of a polynomial that is known in intervals, and exactly when that is asked for. `multiple`: marks of multiple roots, which are beyond
// intervals; of these it is not asked.
[[nodiscard]] std::vector<Mark> root_marks(const IntervalPolynomial& near, const std::function<Polynomial()>& exact,
                                           std::int64_t first, std::int64_t last,
                                           const std::vector<Mark>& multiple = {});

// The y where the roots in x of a curve appear, meet, or go to infinity, and where the curve contains a whole line y = const.
[[nodiscard]] Polynomial turning_lines(const Curve& p);

// A polynomial that vanishes at every y where two curves without a common component meet.
[[nodiscard]] Polynomial meeting_lines(const Curve& p, const Curve& q);
[[nodiscard]] IntervalPolynomial meeting_lines(const IntervalCurve& p, const IntervalCurve& q);

}  // namespace halfspace
