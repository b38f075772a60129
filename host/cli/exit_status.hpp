// exit_status.hpp - what every command returns to the shell; a contract (README, --help).
#pragma once

#include "host/scene/diagnostic.hpp"

namespace halfspace {

enum class ExitStatus : int {
  drawn = 0,
  scene_wrong = 1,
  command_line_wrong = 2,
  device_or_file_failed = 3,
  limit_exceeded = 4,
};

// Prints every diagnostic to standard error (warnings unless quiet) and says what they amount to.
ExitStatus report(const Diagnostics& diagnostics, bool quiet);

// One error without a place in a file; `file`, if any, is named in front.
ExitStatus fail(ExitStatus status, const std::string& message, const std::string& file = "");

}  // namespace halfspace
