// contour.hpp - shading by contours: a visible span is cut where the boundaries between levels cross it, and nothing is computed
// per dot. Each of the ways below shades dots x0 .. x1 of line y exactly as the face's shader dot by dot does, or declines:
//   sphere_contour    faces with |N| constant: a level is an interval about a centre, by one root
//   straight_contour  cylinders and cones: every contour a straight line through one point of the page
//   general_contour   any face: monotone pieces of the intensity, boundaries by certified signs
// Order   A way that returns false has painted nothing; the caller tries the next, then goes dot by dot.
// Exact   Positions carry a proven error; a dot within it of a boundary is asked of reaches_level.
// Memory  FaceContours a face; ShadeJob::scratch, a word a level, shared by all faces.
#pragma once

#include <cstdint>
#include <limits>

#include "firmware/core/general_contour.hpp"
#include "firmware/core/reaches_level.hpp"
#include "firmware/core/shade.hpp"
#include "firmware/core/sphere_contour.hpp"
#include "firmware/core/straight_contour.hpp"

namespace halfspace {

// `curved`: straight or general, not told apart yet.
enum class ContourKind : std::uint8_t { unknown, none, sphere, curved, straight, general };

// For a line of the page.
inline constexpr std::int32_t unknown_line = std::numeric_limits<std::int32_t>::min();
inline constexpr std::int32_t no_line = unknown_line + 1;
inline constexpr std::int32_t all_lines = std::numeric_limits<std::int32_t>::max();

// What a face keeps while it is active; made on the first span that asks.
struct FaceContours {
  ContourKind kind = ContourKind::unknown;
  std::int32_t corner_line = unknown_line;  // of a straight one, once it matters
  std::uint32_t gaps = 0, steps = 0;        // of the last span of two dots or more: levels met from dot to dot
  std::int32_t chosen_until = no_line;      // the line from which its way is compared with others again
  Chance begun;                             // of its way but straight contours
  std::int32_t dear = 0;                    // what its last span by general contours took more than it should have
  SphereContours sphere;
  StraightContours straight;
  GeneralContours general;
  std::span<std::uint32_t> block;  // contour_block_words(), of straight or general contours; none: the pool is used up
};

// Whether the face is of the kind; |N| is constant on some that are no good spheres.
[[nodiscard]] bool has_constant_normal(const RootSurface& surface);
[[nodiscard]] bool has_straight_contours(const ActiveFace& face);
// Whether they take more than 80 bits: then neither the above nor the next can be told.
[[nodiscard]] bool has_wide_coefficients(const ActiveFace& face);
// The line on which D may be a square, as through the apex of a face with straight contours: its root has a corner there and |N| a zero.
// Told from dot (x, y) of the face.
[[nodiscard]] std::int32_t corner_line_of(const ActiveFace& face, std::int32_t x, std::int32_t y);

// Words of a face's block: straight contours' entries, or general ones' tracks; a level has two of either.
constexpr std::size_t contour_block_words(std::int32_t levels) { return 2 * static_cast<std::size_t>(levels) + 16; }

// Makes sphere_contour's registers.
[[nodiscard]] bool make_sphere(const ShadeJob& job, SphereContours& out);

[[nodiscard]] bool sphere_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);
// By the face's last survey; by a new one.
[[nodiscard]] bool straight_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);
[[nodiscard]] bool surveyed_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);
[[nodiscard]] bool general_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1);

// The first of these ways that does not decline; Shader::automatic asks only ways that should be cheaper than dot by dot.
// Linked only where a table of modules names it.
struct ContourModule {
  bool (*shade)(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1);
};
extern const ContourModule all_contours;

}  // namespace halfspace
