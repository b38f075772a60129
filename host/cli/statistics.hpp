// statistics.hpp - what drawing a scene took: the paper's tables 7.1 to 7.3 for any scene, as text or as JSON.
#pragma once

#include <string>

#include "host/cli/output_page.hpp"
#include "host/cli/pipeline.hpp"

namespace halfspace {

struct StatisticsRequest {
  bool table = false;  // printed where the picture does not go
  std::string file;    // JSON; empty: none
};

[[nodiscard]] inline bool wanted(const StatisticsRequest& request) { return request.table || !request.file.empty(); }

// Table 7.1: what the resolver was given and made. Table 7.2: operations of the core. Table 7.3: processor seconds.
// Of a ready job (no pipeline) table 7.1 is the job itself, and table 7.3 its drawing.
[[nodiscard]] ExitStatus write_statistics(const StatisticsRequest& request, const std::string& picture,
                                          const Pipeline* pipeline, const DrawnPage& drawn);

}  // namespace halfspace
