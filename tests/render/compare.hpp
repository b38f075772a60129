// compare.hpp - a drawn picture beside the exact oracle's, and how many random scenes a run takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::testing {

// The number of wrong dots and the first of them, in words; empty if every dot is right. With `trust_boxes` the oracle skips
// bodies outside their boxes (full pages).
[[nodiscard]] std::string first_difference(const IntegerScene& scene, const std::vector<std::int16_t>& drawn,
                                           bool trust_boxes = false);

// HALFSPACE_RANDOM_BODIES, or `standard` (a twentieth of it under the address sanitizer).
[[nodiscard]] std::uint64_t random_count(std::uint64_t standard);

}  // namespace halfspace::testing
