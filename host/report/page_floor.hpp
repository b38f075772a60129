// page_floor.hpp - the least that any program takes: filling a page's dots with stipple words and nothing else.
#pragma once

#include "host/report/subject.hpp"

namespace halfspace {

// Nanoseconds a dot of the page.
[[nodiscard]] double page_floor_ns(const PageSize& size, int runs);

}  // namespace halfspace
