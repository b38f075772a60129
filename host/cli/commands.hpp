// commands.hpp - the commands of the program, each with what its options say.
#pragma once

#include <string>

#include "host/cli/output_page.hpp"
#include "host/cli/pipeline.hpp"

namespace halfspace {

struct RenderRequest {
  SceneRequest scene;
  PageRequest page;
  std::string output;
  std::string shader = "isqrt";
  std::int32_t stride = default_stride;  // of shader stride
  bool statistics = false;
  std::string statistics_file;
};

[[nodiscard]] ExitStatus run_render(const RenderRequest& request);

struct InfoRequest {
  SceneRequest scene;
  PageRequest page;
};

[[nodiscard]] ExitStatus run_info(const InfoRequest& request);

}  // namespace halfspace
