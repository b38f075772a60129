// load_scene.hpp - scene files from disk ("-": standard input) to one parsed Scene.
#pragma once

#include <string>
#include <vector>

#include "host/cli/exit_status.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

struct LoadedScene {
  Scene scene;
  ExitStatus status = ExitStatus::drawn;
};

// Prints every error of every file. `language` overrides the file's ending; only "uq" is known today.
[[nodiscard]] LoadedScene load_scene(const std::vector<std::string>& paths, const std::string& language, bool quiet);

}  // namespace halfspace
