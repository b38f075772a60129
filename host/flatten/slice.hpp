// slice.hpp - has a body a point in the plane u = c? Decided in integers.
// Method   The plane's section is a figure bounded by conics. Between the lines v = const where a conic turns or two of them meet its
//          structure stays the same, so one line each tells; on a line every half-space holds in at most two intervals.
// Limit    Only what is open and wider than some 2^-112 counts: the caller has made the body that much larger.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>

#include "host/flatten/root_gaps.hpp"

namespace halfspace {

// uu vv ww uv vw uw u v w 1, negative inside.
struct SliceForm {
  std::array<mpz_class, 10> q;
};

// Has the body a point there, as far as |v| and |w| are no larger than 16?
[[nodiscard]] bool meets_plane(std::span<const SliceForm> forms, const Dyadic& u);

}  // namespace halfspace
