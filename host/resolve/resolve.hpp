// resolve.hpp - from half-spaces to faces: body by body, every face's region on the page, exactly (docs/resolve.md).
// Errors  None: every integer scene has its faces.
// Cost    Linear in the number of bodies; in a body's half-spaces n, at most n^3 curve pairs a face, usually far fewer.
#pragma once

#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// Faces that no dot can show (exit_sheets.hpp, hidden_bodies.hpp) are left out unless `all_faces`.
[[nodiscard]] ResolvedScene resolve(const IntegerScene& scene, bool all_faces = false);

}  // namespace halfspace
