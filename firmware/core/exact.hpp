// exact.hpp - the two questions of a dot, answered without rounding: which face is nearer, and is a level
// reached. Method  A face's depth at a dot is z = (p + s sqrt(q)) / d. Every question is then the sign of a
// form P + R sqrt(q)
//         (or A + B sqrt(q1) + C sqrt(q2) for two depths), settled by comparing squares.
// Ranges  The job writer refuses a face whose forms could outgrow exact_bits (host/job/limits).
// Cost    Thousands of instructions: only where the filters of depth.hpp and shade.hpp cannot tell (well
// under 1 %).
#pragma once

#include <cstdint>

#include "firmware/core/face.hpp"

namespace halfspace {

inline constexpr int exact_bits = 768;

// sign(z_f - z_g) at page dot (x, y), where both faces are.
[[nodiscard]] int compare_depth(const ActiveFace& f, const ActiveFace& g, std::int32_t x, std::int32_t y);

// True when the face reaches level k, 0 <= k < levels, at page dot (x, y): (levels - 1) * intensity >= k.
[[nodiscard]] bool reaches_level(const ActiveFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k,
                                 std::int32_t x, std::int32_t y);

// A rational face has no point over the dots where b = 0.
[[nodiscard]] bool is_absent(const ActiveFace& face, std::int32_t x, std::int32_t y);

}  // namespace halfspace
