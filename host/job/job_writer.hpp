// job_writer.hpp - the resolved scene as a job: records sorted by the scan line they enter on, slots already
// assigned. Slots  The host knows every lifetime, so it hands out pool slots (the lowest free one, face by
// face, arc by arc) and the
//        core needs no free lists: its pools are as large as the busiest scan line.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/core/engine.hpp"
#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

struct JobOptions {
  Page page;  // width, height and levels must be the integer scene's
  Screen screen = Screen::clustered;
  bool measure = true;  // sweep once to learn the fullest line; otherwise a span a dot is asked for
};

struct JobResult {
  std::vector<std::uint8_t> bytes;
  JobHeader header;
  Diagnostics diagnostics;  // limits exceeded
};

[[nodiscard]] JobResult write_job(const IntegerScene& scene, const ResolvedScene& resolved, const JobOptions& options);

}  // namespace halfspace
