// pencil.hpp - what the quadrics through the meeting curve of two others tell about it.
// On P = 0 the value of Q is that of S = Q - t P for every t. So Q keeps its sign there if some S
//   - is +-l^2, a plane's square: the surfaces touch in their sections with that plane, or nowhere if l is constant
//     (shells q and q + k; their image in perspective, where the plane is the horizon; a ball in a tube), or
//   - is semidefinite, with no zero in finite space.
// Complete  The second always exists for surfaces that have no real point in common, at infinity neither (Calabi 1964).
// Exact     Integers and rationals decide; t is one of ten ratios, or found by cutting an interval by witnesses against it,
//           the first of them found in doubles and weighed in intervals.
#pragma once

#include <optional>

#include "host/flatten/integer_scene.hpp"

namespace halfspace {

struct ConstantSign {
  std::optional<IntegerHalfSpace> touching;  // the plane along which the surfaces touch
};

// On the first one's surface the second keeps its sign, but for where they touch. None if that could not be proved.
[[nodiscard]] std::optional<ConstantSign> constant_sign(const IntegerHalfSpace& on, const IntegerHalfSpace& value);

}  // namespace halfspace
