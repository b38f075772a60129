// output_page.hpp - a job drawn through its driver into the simulated device, and the finished page put under OUT.
#pragma once

#include <string>

#include "firmware/core/engine.hpp"
#include "host/cli/pipeline.hpp"

namespace halfspace {

struct DrawRequest {
  std::string output;
  Shader shader = Shader::isqrt;
  std::int32_t stride = default_stride;
  bool quiet = false;
};

struct DrawnPage {
  DrawResult result;
  std::size_t core_bytes = 0;  // RAM lent to the core
  double seconds = 0;          // processor time of core and driver
  ExitStatus status = ExitStatus::drawn;
};

// Words instead of a page; "-" is standard output.
[[nodiscard]] ExitStatus write_text(const std::string& path, const std::string& text);

[[nodiscard]] DrawnPage draw_page(const PageChoice& choice, const JobResult& job, const DrawRequest& request);

}  // namespace halfspace
