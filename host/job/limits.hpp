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
  int p = 0, q = 0, d = 0;  // z = (p + s sqrt(q)) / d; q = 0: no root
  int normal = 0;           // u of the largest component of d * N
  int linear = 0;           // c0 x + c1 y + c3 of a plane, b of a root face: kept in 128 bits

  void extend(const FaceBits& other);  // the larger of each
  [[nodiscard]] bool covers(const FaceBits& other) const;
};

[[nodiscard]] FaceBits face_bits(const IntegerScene& scene, const IntegerBody& body,
                                 const IntegerHalfSpace& half_space);
// Not less than those, and mostly the same, in a hundredth of the time. They have a root if those have.
[[nodiscard]] FaceBits face_bits_above(const IntegerScene& scene, const IntegerBody& body,
                                       const IntegerHalfSpace& half_space);

// What is too large for the core's filters, in words; nothing when every width holds.
[[nodiscard]] std::optional<std::string> check_face(const FaceBits& face);

// Bits, sign included, that exact arithmetic (firmware/core/exact.cpp) may need for a face's levels, and for any two depths: the
// maxima over the faces with a root, and over all faces.
[[nodiscard]] int level_bits(const IntegerScene& scene, const FaceBits& face);
[[nodiscard]] int depth_bits(const IntegerScene& scene, const FaceBits& roots, const FaceBits& all);

// The narrowest kind whose registers hold the arc's form on every dot and line it may visit; nothing if none
// does.
[[nodiscard]] std::optional<ArcKind> arc_kind(const IntegerScene& scene, const Arc& arc);

[[nodiscard]] inline bool is_line(const Curve& curve) { return curve.q[0] == 0 && curve.q[1] == 0 && curve.q[2] == 0; }

// Every separator and its step within `largest_separator`.
[[nodiscard]] bool separators_fit(const Arc& arc);

}  // namespace halfspace
