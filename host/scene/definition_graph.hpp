// definition_graph.hpp - which definition draws which: none unknown, inside itself or nested too deep.
#pragma once

#include "host/scene/names.hpp"

namespace halfspace {

// How deep definitions may be nested by instances and arrays: later stages may recurse on them.
inline constexpr int deepest_nesting = 1000;

// Cost   Linear in the definitions and their uses; no recursion.
void check_definition_uses(const SceneDraft& draft, DiagnosticLog& log);

}  // namespace halfspace
