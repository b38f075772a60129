// reaches_level.hpp - one dot, one level, for sure: what every shader asks where its own filter cannot tell.
#pragma once

#include <cstdint>

#include "firmware/core/shade.hpp"

namespace halfspace {

// True when the face reaches level k at page dot (x, y): a filter in 62-bit mantissas, then exact arithmetic. For every k.
[[nodiscard]] bool reaches_level(const ShadeJob& job, std::int32_t x, std::int32_t y, std::int32_t k);

// The level at a dot, sought between two that enclose it.
[[nodiscard]] std::int32_t level_between(const ShadeJob& job, std::int32_t x, std::int32_t y, std::int32_t low,
                                         std::int32_t high);

}  // namespace halfspace
