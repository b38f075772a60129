#include "firmware/core/curtain.hpp"

#include <algorithm>
#include <limits>

namespace halfspace {

// A dot at or right of a root may lie up to a dot beyond it: 2 m - e of the roots lies between 2 m - e - 2 and 2 m - e + 1 of the dots.
CrossingRange crossing_range(std::int32_t first, std::int32_t middle, std::int32_t last, std::int32_t x_min,
                             std::int32_t x_max) {
  const std::int32_t least = std::min({first, middle, last});
  const std::int32_t greatest = std::max({first, middle, last});
  if (least <= x_min || greatest > x_max) return {x_min, x_max + 1};
  return {std::min(least, 2 * middle - 1 - std::max(first, last)),
          std::max(greatest, 2 * middle + 1 - std::min(first, last))};
}

void Curtain::open() { std::fill(columns_.begin(), columns_.end(), std::numeric_limits<std::int32_t>::max()); }

}  // namespace halfspace
