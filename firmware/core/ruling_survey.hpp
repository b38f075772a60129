// ruling_survey.hpp - a cone's or cylinder's rulings: the pencil that they form on the page, and where levels change across it.
#pragma once

#include <cstdint>

#include "firmware/core/shade.hpp"

namespace halfspace {

// Fills job.contours' lines and entries from dots x0 .. x1 of line y, where the face is; false, and no entries, where they do not
// fit the block or cannot be told well enough.
[[nodiscard]] bool survey_rulings(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);

}  // namespace halfspace
