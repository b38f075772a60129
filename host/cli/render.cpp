#include <fmt/core.h>

#include <cstdio>

#include "host/cli/commands.hpp"
#include "host/cli/statistics.hpp"
#include "host/picture/simulated_device.hpp"

namespace halfspace {
namespace {

ExitStatus write_statistics(const RenderRequest& request, bool picture_on_output, const Pipeline& pipeline,
                            const DrawnPage& drawn) {
  // Tables go where the picture does not.
  ExitStatus status = ExitStatus::drawn;
  if (request.statistics) {
    const std::string text = statistics_text(pipeline, drawn);
    if (picture_on_output) {
      fmt::print(stderr, "{}", text);
    } else {
      status = write_text("-", text);
    }
  }
  if (status != ExitStatus::drawn || request.statistics_file.empty()) return status;
  return write_text(request.statistics_file, statistics_json(pipeline, drawn));
}

Shader shader_named(const std::string& name) {
  if (name == "stride") return Shader::stride;
  return name == "jordan" ? Shader::jordan : Shader::isqrt;
}

}  // namespace

ExitStatus run_render(const RenderRequest& request) {
  const PageChoice choice = choose_page(request.page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  const DeviceTraits& traits = choice.device->traits;
  const bool text_device = choice.device->kind == DeviceKind::ascii || choice.device->kind == DeviceKind::braille;
  const std::string output = request.output.empty() && text_device ? "-" : request.output;
  if (output.empty()) {
    return fail(ExitStatus::command_line_wrong,
                fmt::format("-o is missing: name the file that {} writes", traits.name));
  }
  if (const auto error = check_output_name(output, traits)) return fail(ExitStatus::command_line_wrong, *error);

  const bool statistics = request.statistics || !request.statistics_file.empty();
  const Pipeline pipeline = make_job(request.scene, choice, statistics);
  if (pipeline.status != ExitStatus::drawn) return pipeline.status;
  const DrawnPage drawn =
      draw_page(choice, pipeline.job, {output, shader_named(request.shader), request.stride, request.scene.quiet});
  if (drawn.status != ExitStatus::drawn) return drawn.status;
  return write_statistics(request, output == "-", pipeline, drawn);
}

}  // namespace halfspace
