// limits.hpp - the proof that the core's fixed widths hold a face or an arc, made from magnitudes before it
// is written.
#pragma once

#include <optional>
#include <string>

#include "firmware/core/job_format.hpp"
#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// Bits of the quantities that firmware/core/exact.cpp forms for one face, over every dot of the scissor.
struct FaceBits {
  int p = 0, q = 0, d = 0;  // z = (p + s sqrt(q)) / d
  int normal = 0;           // u of the largest component of d * N
  int linear = 0;           // c0 x + c1 y + c3 of a plane, b of a root face: kept in 128 bits
};

[[nodiscard]] FaceBits face_bits(const IntegerScene& scene, const IntegerBody& body,
                                 const IntegerHalfSpace& half_space);

// What is too large, in words; nothing when every width holds.
[[nodiscard]] std::optional<std::string> check_face(const IntegerScene& scene, const FaceBits& face);
// Two depths compared exactly: `largest` holds the maxima over all faces of the job.
[[nodiscard]] std::optional<std::string> check_depths(const IntegerScene& scene, const FaceBits& largest);

// The narrowest kind whose registers hold the arc's form on every dot and line it may visit; nothing if none
// does.
[[nodiscard]] std::optional<ArcKind> arc_kind(const IntegerScene& scene, const Arc& arc);

}  // namespace halfspace
