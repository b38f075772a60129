#include <fmt/core.h>

#include <cstdio>
#include <optional>

#include "host/cli/commands.hpp"
#include "host/cli/statistics.hpp"
#include "host/picture/simulated_device.hpp"
#include "host/picture/write_bytes.hpp"

namespace halfspace {
namespace {

ExitStatus write_statistics(const RenderRequest& request, const Pipeline& pipeline, const DrawnPage& drawn) {
  // Tables go where the picture does not.
  if (request.statistics) fmt::print(request.output == "-" ? stderr : stdout, "{}", statistics_text(pipeline, drawn));
  if (request.statistics_file.empty()) return ExitStatus::drawn;
  const std::string json = statistics_json(pipeline, drawn);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(json.data());
  if (const auto error = write_bytes(request.statistics_file, {bytes, json.size()})) {
    return fail(ExitStatus::device_or_file_failed, *error);
  }
  return ExitStatus::drawn;
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
  const Shader shader = request.shader == "jordan" ? Shader::jordan : Shader::isqrt;
  const DrawnPage drawn = draw_page(choice, pipeline.job, {output, shader, request.scene.quiet});
  if (drawn.status != ExitStatus::drawn) return drawn.status;
  return write_statistics(request, pipeline, drawn);
}

}  // namespace halfspace
