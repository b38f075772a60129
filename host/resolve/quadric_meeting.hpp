// quadric_meeting.hpp - do two quadrics of one body meet where all its other half-spaces hold?
// Edges between two quadrics are not traced: on a quadric's sheet another quadric's sign is sampled, which is right as long as
// it does not vanish on the shown part of the sheet.
// Sound  "Apart" is proved by interval arithmetic with outward rounding; anything else counts as meeting.
// Cost   At most `budget` boxes a sheet; a body whose pencil of quadrics holds a constant (coaxial tubes, concentric spheres)
//        needs one box.
#pragma once

#include <optional>

#include "host/resolve/scan_rows.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

struct QuadricMeeting {
  std::uint32_t other = 0;  // the half-space that meets the sheets' own
  double x = 0, y = 0;      // local dots
};

[[nodiscard]] std::optional<QuadricMeeting> find_meeting(const Sheets& sheets, const Extent& extent);

}  // namespace halfspace
