// radical_plane.hpp - which of two spheres is nearer, by the plane of the circle in which they meet: without a root.
//   Two front sheets z = m - r whose quadrics have second-order terms in proportion: m_rival - m_face is a constant k > 0 (DepthProof::inner:
//   the face is the inner one), and the squares r r differ by a linear form. The rival lies behind where
//       r_rival <= r_face + k   <=>   r_face >= l,   l = (r_rival^2 - r_face^2 - k^2) / 2 k        linear in x and y
//   which is where the face lies in front of the plane z = m_face - l. So the sign of D - l^2 tells, where l > 0.
//   Along a line D - l^2 is concave: the face is nearer on neighbouring dots alone.
// Exact   A sign is told where it is certain.
// Cost    A dot takes three products; a run its ends and the dots beside where the order changed on the line before, as a rule.
#pragma once

#include "firmware/core/depth_block.hpp"

namespace halfspace {

// Of the inner one of two faces, as above; made once for the pair. k is rival's c2 times the face's times k, so that it is whole.
[[nodiscard]] RadicalPlane radical_plane(const ActiveFace& face, const ActiveFace& rival, const Wide<256>& k);

// Over the dots and lines of a proof, which the face's block holds: 1, the inner face is nearer on all; -1, the rival is; 0, it cannot be told.
[[nodiscard]] int nearer_by_plane(const ActiveFace& inner, const DepthProof& over);

// Dots of a run where the inner face is the nearer one; none: from > to.
struct InnerDots {
  std::int32_t from, to;
};

// Of dots a .. b of line y, which the faces' blocks and their `proof` hold. False: it cannot be told.
[[nodiscard]] bool find_inner_dots(const ActiveFace& inner, DepthProof& proof, std::int32_t y, std::int32_t a,
                                   std::int32_t b, InnerDots& found);

}  // namespace halfspace
