// least_scale.hpp - how many bits a surface needs: few, so that what is computed from them stays short.
#pragma once

#include <algorithm>

namespace halfspace {

// What `attempt(bits)` makes of the least bits from `least` up and below `limit` that suffice, or a false value. Steps of eight find
// some that do; from there it goes down while one less does too.
template <class Attempt>
auto with_least_bits(int least, int limit, Attempt attempt) {
  constexpr int step = 8;
  int bits = least;
  auto found = attempt(bits);
  while (!found && bits < limit - 1) {
    bits = std::min(bits + step, limit - 1);
    found = attempt(bits);
  }
  while (found && bits > least) {
    auto less = attempt(--bits);
    if (!less) break;
    found = std::move(less);
  }
  return found;
}

}  // namespace halfspace
