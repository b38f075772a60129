// view_reader.hpp - reads the parameters of a view: "vrp 0 0 0 dop .3 .3 -1 whh 5".
#pragma once

#include <vector>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/token_stream.hpp"

namespace halfspace {

// One or more, in order. Checked here: sizes above 0, a front plane before the back one, and vectors that are
// not zero. What needs more than one parameter to judge (vup along vpn) is the flattener's. False after an
// error.
[[nodiscard]] bool read_view_parameters(TokenStream& tokens, DiagnosticLog& log,
                                        std::vector<ViewParameter>& parameters);

}  // namespace halfspace
