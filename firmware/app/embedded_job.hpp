// embedded_job.hpp - a job that is part of the firmware, and the modules it names.
// Memory  All of it is constant: it stays in flash and is read from there.
#pragma once

#include "firmware/core/engine.hpp"

namespace halfspace {

struct EmbeddedJob {
  std::span<const std::uint8_t> bytes;
  Modules modules;  // null where the job has no such arc: the linker leaves that kind out
  Shader shader = Shader::isqrt;
};

// Defined by the object that the build makes from a scene; a firmware links one.
extern const EmbeddedJob embedded_job;

}  // namespace halfspace
