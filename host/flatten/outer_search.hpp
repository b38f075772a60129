// outer_search.hpp - the outermost points of a body, searched with boxes: quick, never wrong, and not always decided.
// Method   A box in which a half-space fails everywhere is dropped, one in which all hold shows how far the body reaches; others are
//          halved, the outermost first (branch and bound). What is left when the search stops says which surfaces can
//          matter to the rest of the question.
// Frame    Coordinates in which the body lies within +-1.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "host/flatten/bound_form.hpp"

namespace halfspace {

// The part of `whole` that the body can be in; none where there is no body. `thoroughly`: with more trouble before it is left as it is.
[[nodiscard]] std::optional<CentredBox> part_with_body(std::span<const BoundForm> forms, const CentredBox& whole,
                                                       bool thoroughly);

// Can two forms of different families (none: not asked) vanish in one point of the body, anywhere? Yes, if small boxes do not tell.
// The body is best of about size 1: what lies beyond is searched by its directions and the inverse of its distance.
[[nodiscard]] bool may_meet(std::span<const BoundForm> forms, std::span<const std::optional<std::size_t>> families);

using Meeting = std::vector<std::uint32_t>;  // up to three forms that may vanish together, ascending

struct Outermost {
  double known = -std::numeric_limits<double>::infinity();  // the body reaches at least this far
  double bound =
      -std::numeric_limits<double>::infinity();  // and no further than this; less than `known`: nothing is left
  std::set<Meeting> meetings;                    // that lie between
};

// Along `axis` (0, 1, 2) in the direction of `sign`, distances counted that way. Stops early when the two are no further apart than
// `slack`.
[[nodiscard]] Outermost search_outwards(std::span<const BoundForm> forms, const CentredBox& whole, std::size_t axis,
                                        double sign, double slack);

// Has the body a point in the plane where coordinate `axis` is `at`? None: that is not told so easily.
[[nodiscard]] std::optional<bool> meets_plane(std::span<const BoundForm> forms, const CentredBox& whole,
                                              std::size_t axis, double at);

}  // namespace halfspace
