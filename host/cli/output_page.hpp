// output_page.hpp - a job drawn through its driver into the simulated device, and the finished page put under OUT.
#pragma once

#include <optional>
#include <string>

#include "firmware/core/engine.hpp"
#include "host/cli/pipeline.hpp"

namespace halfspace {

struct DrawRequest {
  const KnownDevice* device = nullptr;
  std::int32_t dpi = 0;
  std::string output;
  Shader shader = Shader::automatic;
  std::int32_t stride = default_stride;
  bool quiet = false;
  std::string job_name;  // the job's file, for errors; empty: it lies in memory
};

struct DrawnPage {
  JobHeader header;
  DrawResult result;
  std::size_t job_bytes = 0;
  std::size_t core_bytes = 0;  // RAM lent to the core
  double seconds = 0;          // processor time of core and driver, and of reading the job
  ExitStatus status = ExitStatus::drawn;
};

// Words instead of a page; "-" is standard output.
[[nodiscard]] ExitStatus write_text(const std::string& path, const std::string& text);

[[nodiscard]] bool takes_page(const DeviceTraits& traits, const Page& page);
// The known devices that take it: "gray, ascii".
[[nodiscard]] std::string devices_for(const Page& page);

// The name of OUT; nothing: refused, and said why.
[[nodiscard]] std::optional<std::string> choose_output(const std::string& asked, const KnownDevice& device);

// Tells of a density (0: none was said) that OUT does not record.
void warn_of_density(std::int32_t dpi, const std::string& output, const KnownDevice& device);

// What render and run share: every page is drawn from a job's bytes, and OUT is touched only once the page is whole.
[[nodiscard]] DrawnPage draw_page(ByteSource& job_bytes, const DrawRequest& request);

}  // namespace halfspace
