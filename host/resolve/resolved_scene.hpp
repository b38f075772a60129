// resolved_scene.hpp - faces and their regions on the page: trapezoids between monotone arcs, exact on every dot.
//
//     face f on scan lines y0..y1            left arc            right arc
//                                              |  f f f f f f f f f  |
//     a cell is the CLOSED set of dots x with  left root <= x <= right root  on each of its lines.
//
// A face is one sheet of one half-space's surface. Its cells are all dots where the sheet exists, every other half-space of the
// body holds, and the half-space is opaque. Cells of one face are disjoint. Coordinates of curves are local
// dots of the body's frame; scan lines (y0, y1, row) and dot columns are page dots.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace halfspace {

// value(x, y) = q0 x^2 + q1 x y + q2 y^2 + q3 x + q4 y + q5, common factors removed. A line has q0 = q1 = q2 = 0.
struct Curve {
  std::array<mpz_class, 6> q;
};

// Which root in x the arc follows on a scan line, with the curve's sign normalised so that
//   single  value is of first order in x with a positive coefficient (q1 y + q3 > 0) on every line of the arc;
//           right of the root is value > 0.
//   left, right  q0 > 0: the smaller or the larger root (equal for a double root).
enum class Branch : std::uint8_t { single, left, right };

// Where another quadric of the body changes sign on a sheet z = (-b + t sqrt(d)) / a: the value there is p + r sqrt(d) up to a positive
// factor, p and d quadratic, r linear; t is taken into r.
struct RadicalForm {
  Curve p, r, d;
};

// The same on a sheet without z^2: a polynomial of fourth degree, coefficients of
// x^4 x^3y x^2y^2 xy^3 y^4  x^3 x^2y xy^2 y^3  x^2 xy y^2  x y  1.
struct QuarticForm {
  std::array<mpz_class, 15> q;
};

// A line beside a curve: at + step (y - y0) on scan line y, in 2^-16 dots of the body's frame; y0 is its window's first line.
struct Separator {
  std::int64_t at = 0, step = 0;
};

// Lines on which the form of an arc changes its sign exactly once between two separators: at the arc's root. A dot at or left of
// `left` is left of the root, one at or right of `right` is right of it. No separator: the scissor's edge.
struct Window {
  std::int32_t y0 = 0, y1 = -1;  // page scan lines, inclusive
  std::optional<Separator> left, right;
};

// How to tell one root of a RadicalForm or QuarticForm from the others.
struct Guide {
  bool rising = true;           // the form is negative left of the root
  bool missing_right = false;   // dots of a window with d < 0 lie right of the root, else left
  std::vector<Window> windows;  // ascending, without gaps, all lines of the arc
};

struct Arc {
  std::uint32_t body = 0;
  std::variant<Curve, RadicalForm, QuarticForm> form;
  Branch branch = Branch::single;  // of a Curve
  Guide guide;                     // of the other forms
  std::int32_t y0 = 0, y1 = -1;    // page scan lines, inclusive, on which the root exists and follows one branch
};

// The sheet of a = 0 surfaces (planes; quadrics without z^2) is `only`; else front is the smaller z.
enum class Sheet : std::uint8_t { only, front, back };

struct Face {
  std::uint32_t body = 0;
  std::uint32_t half_space = 0;  // index in the body
  Sheet sheet = Sheet::only;
};

inline constexpr std::uint32_t no_arc = 0xffffffff;  // the scissor's edge bounds the cell on this side

struct Cell {
  std::uint32_t face = 0;
  std::uint32_t left = no_arc, right = no_arc;  // indices into arcs; equal: only a dot exactly on the arc shows
  std::int32_t y0 = 0, y1 = -1;                 // page scan lines, inclusive, within both arcs' lines
};

// One scan line of a face where the structure is singular (a vertex exactly on the line): dots x0..x1, page frame.
struct LineSpan {
  std::uint32_t face = 0;
  std::int32_t y = 0, x0 = 0, x1 = -1;
};

struct ResolvedScene {
  std::vector<Arc> arcs;
  std::vector<Face> faces;  // in tie order: body, half-space, front before back
  std::vector<Cell> cells;
  std::vector<LineSpan> spans;
};

}  // namespace halfspace
