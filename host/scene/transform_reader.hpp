// transform_reader.hpp - reads the transforms of an instance or array: "=rx 90 =ty 5".
#pragma once

#include <vector>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/token_stream.hpp"

namespace halfspace {

// As many as there are, in order. False after an error.
[[nodiscard]] bool read_transforms(TokenStream& tokens, DiagnosticLog& log, std::vector<Transform>& transforms);

}  // namespace halfspace
