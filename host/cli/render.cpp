#include "firmware/core/memory_source.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/statistics.hpp"

namespace halfspace {

ExitStatus run_render(const RenderRequest& request) {
  const PageChoice choice = choose_page(request.page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  const auto output = choose_output(request.draw.output, *choice.device);
  if (!output) return ExitStatus::command_line_wrong;

  if (!request.scene.quiet) {
    warn_of_needless(request.page, choice);
    warn_of_density(request.page.dpi, *output, *choice.device);
  }
  const Pipeline pipeline = make_job(request.scene, choice, wanted(request.draw.statistics));
  if (pipeline.status != ExitStatus::drawn) return pipeline.status;
  MemorySource job(pipeline.job.bytes);
  const DrawnPage drawn = draw_page(job, {.device = choice.device,
                                          .dpi = choice.dpi,
                                          .output = *output,
                                          .shader = shader_named(request.draw.shader),
                                          .stride = request.draw.stride,
                                          .quiet = request.scene.quiet,
                                          .job_name = ""});
  if (drawn.status != ExitStatus::drawn) return drawn.status;
  return write_statistics(request.draw.statistics, *output, &pipeline, drawn);
}

}  // namespace halfspace
