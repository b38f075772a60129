// summary.hpp - a report's README: the answers first, then the tables they come from.
#pragma once

#include <string>

#include "host/report/findings.hpp"

namespace halfspace {

[[nodiscard]] std::string summary(const Findings& findings);

}  // namespace halfspace
