// transform.hpp - lists of scene transforms as matrices (row vectors, concatenated left to right).
#pragma once

#include <optional>
#include <span>

#include "host/flatten/matrix.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

// The inverse of t1 t2 ... tn, from the exact inverses of each; none where a scale factor is 0.
[[nodiscard]] std::optional<Matrix4> inverse_of(std::span<const Transform> transforms);

}  // namespace halfspace
