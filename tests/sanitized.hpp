// sanitized.hpp - work that is cut under the sanitizers: they take some ten times as long, and look for other faults.
#pragma once

namespace halfspace::testing {

#ifdef HALFSPACE_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

// Rounds of a random test: an eighth of them under the sanitizers.
template <typename Count>
constexpr Count trials(Count count) {
  return sanitized ? count / 8 : count;
}

}  // namespace halfspace::testing
