// commands.hpp - the commands of the program, each with what its options say.
#pragma once

#include <string>

#include "host/cli/output_page.hpp"
#include "host/cli/pipeline.hpp"
#include "host/cli/statistics.hpp"

namespace halfspace {

// What is said of a page's drawing, whether its job is made on the way or ready.
struct PictureRequest {
  std::string output;
  std::string shader = "auto";
  std::int32_t stride = default_stride;  // of the shader stride
  StatisticsRequest statistics;
};

[[nodiscard]] inline Shader shader_named(const std::string& name) {
  if (name == "contour") return Shader::contour;
  if (name == "jordan") return Shader::jordan;
  if (name == "isqrt") return Shader::isqrt;
  return name == "stride" ? Shader::stride : Shader::automatic;
}

struct RenderRequest {
  SceneRequest scene;
  PageRequest page;
  PictureRequest draw;
};

[[nodiscard]] ExitStatus run_render(const RenderRequest& request);

struct CompileRequest {
  SceneRequest scene;
  PageRequest page;
  std::string output;
};

[[nodiscard]] ExitStatus run_compile(const CompileRequest& request);

struct RunRequest {
  std::string path;
  std::string device = PageRequest().device;
  std::int32_t dpi = 0;
  PictureRequest draw;
  bool quiet = false;
};

[[nodiscard]] ExitStatus run_job(const RunRequest& request);

struct InfoRequest {
  SceneRequest scene;
  PageRequest page;
  std::string page_option;  // the first that was said of those which a job has settled already, if any
};

[[nodiscard]] ExitStatus run_info(const InfoRequest& request);

struct ReportRequest {
  std::string folder = "docs/report";
  std::string probe;  // a list of jobs to draw while callgrind counts (host/report/instructions.hpp); empty: none
  bool quick = false;
};

[[nodiscard]] ExitStatus run_report(const ReportRequest& request);

}  // namespace halfspace
