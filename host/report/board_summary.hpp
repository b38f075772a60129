// board_summary.hpp - the Cortex-M3's rows as a file and as tables of the report's README.
#pragma once

#include <string>
#include <vector>

#include "host/report/board.hpp"

namespace halfspace {

[[nodiscard]] std::string as_csv(const std::vector<BoardRow>& rows);
[[nodiscard]] std::string board_summary(const std::vector<BoardRow>& rows);

}  // namespace halfspace
