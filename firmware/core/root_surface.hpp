// root_surface.hpp - the polynomials of a root face, each made once: D when it enters, the others when a dot of it is seen.
//   z = (-b + s sqrt(D)) / a;  N = a * normal = u + v sqrt(D), u linear in x and y, v constant, so that
//   |N|^2 = (u.u + v.v D) + 2 u.v sqrt(D):  a quadratic and a linear form, and light . N a linear form and a constant.
// A face whose z is itself a quadratic in x and y, such as a paraboloid seen along its axis, has such forms too: a = D = 1, v = 0.
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
// Whether z is a polynomial and its normal's matrix does not ask for z: then N is linear in x and y.
[[nodiscard]] bool has_polynomial_normal(const ActiveFace& face, const Lighting& lighting);
// After make_discriminant(), or of a face with a polynomial normal.
void make_root_surface(ActiveFace& face, const Lighting& lighting);

}  // namespace halfspace
