// brute_force.hpp - presence of a face at a dot, twice and independently: from the half-spaces, and from the resolved cells.
#pragma once

#include <optional>
#include <string>

#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace::test {

// The first broken promise of resolved_scene.hpp that the structure alone shows, or none.
[[nodiscard]] std::optional<std::string> broken_structure(const IntegerScene& scene, const ResolvedScene& resolved);

// The first dot of the page where cells and spans do not say what the half-spaces say, or none.
[[nodiscard]] std::optional<std::string> wrong_dot(const IntegerScene& scene, const ResolvedScene& resolved);

}  // namespace halfspace::test
