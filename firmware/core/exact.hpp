// exact.hpp - the two questions of a dot, answered without rounding: which face is nearer, and is a level
// reached. Method  A face's depth at a dot is z = (p + s sqrt(q)) / d. Every question is then the sign of a
// form P + R sqrt(q)
//         (or A + B sqrt(q1) + C sqrt(q2) for two depths), settled by comparing squares.
// Ranges  A job says how many bits its forms can need (host/job/limits proves it); the narrowest module that holds them answers.
// Cost    Thousands of instructions: only where the filters of depth.hpp and shade.hpp cannot tell (well
// under 1 %).
#pragma once

#include <cstdint>

#include "firmware/core/face.hpp"

namespace halfspace {

// The answers in one width, linked only where a table of modules names it.
struct ExactModule {
  std::int32_t bits;
  // sign(z_f - z_g) at page dot (x, y), where both faces are.
  int (*compare_depth)(const ActiveFace& f, const ActiveFace& g, std::int32_t x, std::int32_t y);
  // True when the face reaches level k, 0 <= k < levels, at page dot (x, y): (levels - 1) * intensity >= k.
  bool (*reaches_level)(const ActiveFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k,
                        std::int32_t x, std::int32_t y);
};

inline constexpr int exact_widths = 3;
extern const ExactModule exact_384, exact_768, exact_1152;

// A rational face has no point over the dots where b = 0.
[[nodiscard]] bool is_absent(const ActiveFace& face, std::int32_t x, std::int32_t y);

}  // namespace halfspace
