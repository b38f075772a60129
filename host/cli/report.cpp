#include "host/report/report.hpp"

#include <stdexcept>

#include "host/cli/commands.hpp"
#include "host/report/instructions.hpp"

namespace halfspace {

ExitStatus run_report(const ReportRequest& request) {
  try {
    if (request.probe.empty()) {
      write_report(request.quick ? quick_plan() : Plan(), request.folder);
    } else {
      draw_probes(request.probe);
    }
  } catch (const std::runtime_error& error) {
    return fail(ExitStatus::device_or_file_failed, error.what());
  }
  return ExitStatus::drawn;
}

}  // namespace halfspace
