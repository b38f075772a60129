// pipeline.hpp - from a parsed scene to a job, with what each stage made and took: the road every command shares.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/device_table.hpp"
#include "host/cli/exit_status.hpp"
#include "host/job/job_writer.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// What the user may say about the page; zero, empty or nothing: the device's own.
struct PageRequest {
  std::string device = "varian";
  std::optional<std::string> size;  // "WxH" in dots
  std::int32_t dpi = 0;
  std::int32_t levels = 0;
  std::string background;  // "black" or "white"
  std::string screen;      // empty: clustered
};

struct PageChoice {
  const KnownDevice* device = nullptr;
  Page page;
  Screen screen = Screen::clustered;
  std::int32_t dpi = 0;
  ExitStatus status = ExitStatus::drawn;  // anything else: refused, and said why
};

[[nodiscard]] PageChoice choose_page(const PageRequest& request);

// Tells of a screen on a device that needs none.
void warn_of_needless(const PageRequest& request, const PageChoice& choice);

struct StageTimes {
  double read = 0, flatten = 0, resolve = 0, job = 0, draw = 0;  // seconds
};

struct Pipeline {
  IntegerScene scene;
  ResolvedScene resolved;
  JobResult job;
  StageTimes times;
  ExitStatus status = ExitStatus::drawn;
};

struct SceneRequest {
  std::vector<std::string> paths;
  std::string language;
  std::string view;
  bool quiet = false;
};

// Reads, flattens, resolves and writes the job; `measure` as in JobOptions.
[[nodiscard]] Pipeline make_job(const SceneRequest& request, const PageChoice& choice, bool measure);

// Seconds of processor time that this thread has used.
[[nodiscard]] double processor_seconds();

}  // namespace halfspace
