#include <fmt/core.h>

#include <filesystem>

#include "host/cli/commands.hpp"
#include "host/cli/load_scene.hpp"
#include "host/picture/write_bytes.hpp"

namespace halfspace {
namespace {

// The scene that the job would be written over, if any.
const std::string* overwritten(const CompileRequest& request) {
  for (const std::string& path : request.scene.paths) {
    std::error_code ignored;
    if (std::filesystem::equivalent(path, request.output, ignored)) return &path;
  }
  return nullptr;
}

}  // namespace

ExitStatus run_compile(const CompileRequest& request) {
  const PageChoice choice = choose_page(request.page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  if (request.output.empty()) {
    return fail(ExitStatus::command_line_wrong, "-o is missing: name the job to write, as in scene.hsj");
  }
  if (const std::string* scene = overwritten(request)) {
    return fail(
        ExitStatus::command_line_wrong,
        fmt::format("-o {}: is the scene {} itself; name another file, as in scene.hsj", request.output, *scene));
  }
  const Pipeline pipeline = make_job(request.scene, choice, true);
  if (pipeline.status != ExitStatus::drawn) return pipeline.status;
  if (!request.scene.quiet) warn_of_needless(request.page, choice);
  if (request.page.dpi != 0 && !request.scene.quiet) {
    fmt::print(stderr, "warning: --dpi {}: a job holds no density; say it to halfspace run\n", request.page.dpi);
  }
  const auto error = write_bytes(request.output, pipeline.job.bytes);
  return error ? fail(ExitStatus::device_or_file_failed, *error) : ExitStatus::drawn;
}

}  // namespace halfspace
