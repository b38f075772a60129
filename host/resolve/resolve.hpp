// resolve.hpp - from half-spaces to faces: body by body, every face's region on the page, exactly (docs/resolve.md).
// Errors  A body in which two quadrics meet is left out, and an error names both and the place; all such bodies are reported.
// Cost    Linear in the number of bodies; in a body's half-spaces n, at most n^3 curve pairs a face, usually far fewer.
#pragma once

#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

struct ResolveResult {
  ResolvedScene scene;
  Diagnostics diagnostics;
};

// Faces that no dot can show (exit_sheets.hpp) are left out unless `all_faces`.
[[nodiscard]] ResolveResult resolve(const IntegerScene& scene, bool all_faces = false);

}  // namespace halfspace
