// view_reader.hpp - reads the parameters of a view: "vrp 0 0 0 dop .3 .3 -1 whh 5".
#pragma once

#include <vector>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/token_stream.hpp"

namespace halfspace {

// One or more, in order. False after an error. Checked here: sizes above 0, a front plane before the back
// one, vectors that are not zero. What depends on the defaults (vup along vpn) is the flattener's.
[[nodiscard]] bool read_view_parameters(TokenStream& tokens, DiagnosticLog& log,
                                        std::vector<ViewParameter>& parameters);

}  // namespace halfspace
