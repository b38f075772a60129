// root_surface.hpp - the polynomials of a root face, each made once: D when it enters, the others when a dot of it is seen.
//   z = (-b + s sqrt(D)) / a;  N = a * normal = u + v sqrt(D), u linear in x and y, v constant, so that
//   |N|^2 = (u.u + v.v D) + 2 u.v sqrt(D):  a quadratic and a linear form, and light . N a linear form and a constant.
// Error   A rounded coefficient is off by less than 1, so a value by less than (|x| + |y| + 1)^2 units: see
//         `quadratic_error_bits` and `linear_error_bits`. Values stay below 2^value_bits.
// Source  Ressler 1985, 6.4 ("piecewise matrix multiplication"); the reduction to D, A + B sqrt(D) is ours.
#pragma once

#include "firmware/core/face.hpp"

namespace halfspace {

inline constexpr int value_bits = 122;
// |x|, |y| < 2^17: the page is at most 2^15 dots and a frame's origin is on it or near it (host/flatten).
inline constexpr int coordinate_bits = 17;
inline constexpr int quadratic_error_bits = 2 * (coordinate_bits + 2);
inline constexpr int linear_error_bits = coordinate_bits + 2;

void make_discriminant(ActiveFace& face);
// After that.
void make_root_surface(ActiveFace& face, const Lighting& lighting);

}  // namespace halfspace
