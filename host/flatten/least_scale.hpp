// least_scale.hpp - how many bits a surface needs: few, so that what is computed from them stays short.
#pragma once

#include <algorithm>

namespace halfspace {

// What `attempt(bits)` makes of the least bits below `limit` that suffice, or a false value. Steps of eight find some that do; from
// there it goes down while one less does too.
template <class Attempt>
auto with_least_bits(int limit, Attempt attempt) {
  constexpr int step = 8;
  int bits = 0;
  auto found = attempt(bits);
  while (!found && bits < limit - 1) {
    bits = std::min(bits + step, limit - 1);
    found = attempt(bits);
  }
  while (found && bits > 0) {
    auto less = attempt(--bits);
    if (!less) break;
    found = std::move(less);
  }
  return found;
}

}  // namespace halfspace
