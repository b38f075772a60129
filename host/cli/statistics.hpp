// statistics.hpp - what drawing a scene took: the paper's tables 7.1 to 7.3 for any scene, as text or as JSON.
#pragma once

#include <string>

#include "host/cli/output_page.hpp"
#include "host/cli/pipeline.hpp"

namespace halfspace {

// Table 7.1: what the resolver was given and made. Table 7.2: operations of the core. Table 7.3: processor seconds.
[[nodiscard]] std::string statistics_text(const Pipeline& pipeline, const DrawnPage& drawn);
[[nodiscard]] std::string statistics_json(const Pipeline& pipeline, const DrawnPage& drawn);

}  // namespace halfspace
