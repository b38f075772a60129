// sheet.hpp - one half-space's surface as a function of the dot, and the body's other half-spaces seen from it.
//   surface     a z^2 + b z + c = 0,  b linear and c quadratic in (x, y), a constant and not negative
//   two_sheets  a > 0:  z = (-b -+ sqrt(d)) / 2a,  d = b^2 - 4ac;  front has the minus
//   flat        a plane that no ray lies in: z = -c / b, b constant
//   rational    a = 0, not a plane: z = -c / b where b != 0; where b = 0 the ray meets no point, or lies in the surface
//   none        the surface is parallel to every ray: no face
// On a sheet another half-space's value a' z^2 + b' z + c' has, up to a positive factor, the sign of
//   P + t R sqrt(d)            two_sheets, t = -1 front, 1 back: P quadratic, R linear in (x, y)
//   P                          flat
//   a' c^2 - b' b c + c' b^2   rational: of fourth degree
// On two sheets it vanishes on parts of P^2 - R^2 d = 0, of fourth degree too.
// Source   Ressler 1985, chapter 4, for limbs and sections; the form P + R sqrt(D) is the design's.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/flatten/integer_scene.hpp"
#include "host/resolve/curve_algebra.hpp"
#include "host/resolve/quartic_table.hpp"
#include "host/resolve/traced_curve.hpp"

namespace halfspace {

struct Surface {
  mpz_class a;
  Curve b, c;
  int sense = 1;  // the half-space is sense * value <= 0
};

[[nodiscard]] Surface surface_of(const IntegerHalfSpace& half_space);

// A quadric without terms of second order counts as the plane it is.
[[nodiscard]] bool is_curved(const IntegerHalfSpace& half_space);

enum class SheetShape : std::uint8_t { none, flat, rational, two_sheets };

struct Constraint {
  std::uint32_t half_space = 0;
  Surface surface;
  Curve p, r;                    // unused on a rational sheet
  std::optional<Curve> section;  // on a curved sheet, of a plane: where they meet
  QuarticForm n;                 // on a curved sheet, of a curved surface: P^2 - R^2 d, or the rational sheet's form
};

struct Sheets {
  Sheets(const IntegerBody& body, std::uint32_t index);

  std::uint32_t half_space;
  bool curved;
  SheetShape shape;
  Surface surface;
  Curve d;                              // of two sheets
  std::vector<Constraint> constraints;  // without those on the same surface: their value is 0 on every sheet
};

// Those that the shape has, front before back.
[[nodiscard]] std::span<const Sheet> sheets_in(const Sheets& sheets);

// Is the value of some constraint 0 on a whole part of the surface (a plane, and a pair of planes that contains it)?
[[nodiscard]] bool has_zero_constraint(const Sheets& sheets);

// Where a constraint may vanish: an irreducible curve of degree three or four, on which P^2 = R^2 d on two sheets.
struct TracedQuartic {
  KnownQuartic* curve = nullptr;                  // the table's
  std::vector<std::uint32_t> constraints;         // indices: of whose n it is a factor
  std::vector<const std::vector<Curve>*> others;  // of each of these: the n's other factors of degree one and two
  std::optional<Radical> radical;                 // of the first of them, on two sheets
};

// The curves on which the sheets appear or a constraint may change sign, without common components. A pole comes first.
struct BoundingCurves {
  std::vector<TracedCurve> curves;
  std::vector<TracedQuartic> quartics;
};
[[nodiscard]] BoundingCurves bounding_curves(const Sheets& sheets, QuarticTable& table);

}  // namespace halfspace
