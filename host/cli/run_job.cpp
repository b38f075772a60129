#include "host/cli/commands.hpp"
#include "host/cli/job_input.hpp"
#include "host/cli/statistics.hpp"

namespace halfspace {

ExitStatus run_job(const RunRequest& request) {
  PageRequest page;  // of the device and its density; the rest is the job's
  page.device = request.device;
  page.dpi = request.dpi;
  const PageChoice choice = choose_page(page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  const auto output = choose_output(request.draw.output, *choice.device);
  if (!output) return ExitStatus::command_line_wrong;

  if (!request.quiet) warn_of_density(request.dpi, *output, *choice.device);
  JobFile file(request.path);
  if (!file.is_open()) return ExitStatus::device_or_file_failed;
  const DrawnPage drawn = draw_page(file, {.device = choice.device,
                                           .dpi = choice.dpi,
                                           .output = *output,
                                           .shader = shader_named(request.draw.shader),
                                           .stride = request.draw.stride,
                                           .quiet = request.quiet,
                                           .job_name = file.name()});
  if (drawn.status != ExitStatus::drawn) return drawn.status;
  return write_statistics(request.draw.statistics, *output, nullptr, drawn);
}

}  // namespace halfspace
