// face.hpp - one sheet of one half-space's surface, as the core keeps it while it crosses the scan line.
//
//   plane     c0 x + c1 y + c2 z + c3 = 0, c2 > 0          z = -(c0 x + c1 y + c3) / c2
//   root      the quadric of ten, c2 = a > 0               z = (-b + sheet sqrt(D)) / a
//   rational  the quadric of ten, c2 = 0                   z = -c / (2 b)
//   with  b = c5 x + c4 y + c8,  D = b^2 - a c,
//         c = c0 x^2 + 2 c3 xy + c1 y^2 + 2 c6 x + 2 c7 y + c9.
// Frame   x, y, z are dots local to the body; local + origin = page. Dot (x, y) means its centre.
// Source  Ressler 1985, (2.1), (2.2), 4.1.1; the coefficients keep the paper's order A B C D E F G H J K.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "firmware/core/job_reader.hpp"

namespace halfspace {

enum class FaceKind : std::uint8_t { plane, root, rational };

// A polynomial in x and y, value = (q0 x^2 + q1 x y + q2 y^2 + q3 x + q4 y + q5) 2^exponent. The coefficients are rounded
// down to make every value fit; with exponent 0 they are exact.
struct ScaledQuadratic {
  std::array<Wide<128>, 6> q;
  std::int16_t exponent = 0;

  [[nodiscard]] Wide<128> at(std::int32_t x, std::int32_t y) const {
    return (q[0].times(x) + q[1].times(y) + q[3]).times(x) + (q[2].times(y) + q[4]).times(y) + q[5];
  }
};
struct ScaledLinear {
  std::array<Wide<128>, 3> q;  // q0 x + q1 y + q2
  std::int16_t exponent = 0;

  [[nodiscard]] Wide<128> at(std::int32_t x, std::int32_t y) const { return q[0].times(x) + q[1].times(y) + q[2]; }
};

// A root face over the page: what the filters of depth.hpp and root_shade.cpp walk on. With s = sqrt(D) 2^-e, 2e the
// discriminant's exponent, and the face's own sheet sign taken in:
//   light . N  = light + light_root s        |N|^2 = square + square_root s
// square_root's exponent is at most square's.
struct RootSurface {
  ScaledQuadratic discriminant;  // its exponent is even
  ScaledLinear light;
  Wide<128> light_root;
  ScaledQuadratic square;
  ScaledLinear square_root;

  [[nodiscard]] bool is_exact() const {
    return (discriminant.exponent | light.exponent | square.exponent | square_root.exponent) == 0;
  }
  // Light and normal are those of a dot's column.
  [[nodiscard]] bool is_upright() const {
    const auto has_y = [](const ScaledQuadratic& p) {
      return !p.q[1].is_zero() || !p.q[2].is_zero() || !p.q[4].is_zero();
    };
    return is_exact() && !has_y(discriminant) && !has_y(square) && light.q[1].is_zero() && square_root.q[1].is_zero();
  }
  // Bits that square_root has below square.
  [[nodiscard]] int square_root_fraction() const { return square.exponent - square_root.exponent; }
};

// Where a face lies on dots x0 .. x1 of lines y0 .. y1, and for planes and root faces its depth there, in 64 bits: depth_block.hpp.
// With t = x - x0, s = y - y0, and n = -b + sheet sqrt(D) in units of the block's own, z = n inverse 2^-shift:
//   -b  b + bx t + by s                                               in 2^-16 units
//   D   d + (dy + dyy s) s + (dx + dxy s + dxx t) t                   d in squares of units; dy, dyy in 2^-y_bits parts of them,
//                                                                     dx, dxy, dxx in 2^-x_bits
struct DepthBlock {
  std::int16_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;
  std::int32_t low = 0, high = 0;  // whole dots of page depth
  std::int64_t b = 0, bx = 0, by = 0;
  std::int64_t d = 0, dx = 0, dy = 0, dxx = 0, dxy = 0, dyy = 0;
  std::int64_t error = 0,
               shallow_error = 0;  // of a depth where the root is at least `shallow`, and below; negative: unknown
  std::int32_t shallow = 0;
  std::int8_t x_bits = 0, y_bits = 0, shift = 0;

  [[nodiscard]] bool holds(std::int32_t y, std::int32_t from, std::int32_t to) const {
    return y0 <= y && y <= y1 && x0 <= from && to <= x1;
  }
};

// Of two spheres, a plane that parts where the one is nearer from where the other is: radical_plane.hpp.
//   l = (c + x x + y y) 2^-fraction        in the inner face's frame, in units of the root of its D
struct RadicalPlane {
  static constexpr std::int16_t missing = INT16_MIN;
  std::int64_t c = 0, x = 0, y = 0;
  std::int16_t fraction = missing;
};

// What is known of a face and a rival on dots x0 .. x1 of lines y0 .. y1: -1, the face is the nearer one; 1, the rival is; 0, it takes a
// closer look. On every line, `inner` is nearer on no dot, on one or on neighbouring ones: -1, the face; 1, the rival; 0, it cannot be told.
// `turn`: on every line it changes once at most; 1, from the face to the rival, left to right; -1, from the rival to the face; 0, it cannot
// be told.
// A rival is told by its order, which no other face has.
struct DepthProof {
  std::uint32_t rival = 0;
  std::int16_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;
  std::int8_t nearer = 0;
  std::int8_t inner : 4 = 0, turn : 4 = 0;
  std::int16_t crossing = -1;  // where the order changed on the last line that asked, or beyond its dots; -1: nowhere
  RadicalPlane radical;

  [[nodiscard]] bool holds(std::int32_t y, std::int32_t from, std::int32_t to) const {
    return y0 <= y && y <= y1 && x0 <= from && to <= x1;
  }
};

// What a line asks for stands in front.
struct ActiveFace {
  DepthBlock block;         // about the dots last asked for
  std::uint32_t order = 0;  // of equally near faces the lowest wins
  FaceKind kind = FaceKind::plane;
  std::int8_t sheet = 0;       // root: -1 front, +1 back
  std::int8_t light_sign = 1;  // -1: the outward normal is against the gradient
  std::uint8_t level = 0;      // plane: its one level
  std::int16_t last_line = 0;  // curved: of its cells, as the job says
  bool ready = false;          // curved: FaceModule::enter was called, as a dot of it was seen
  std::int16_t inverse_exponent = 0;
  std::uint32_t inverse = 0;         // 1 / c2 = inverse 2^-inverse_exponent to one part in 2^30: make_depth()
  std::array<DepthProof, 2> proofs;  // the newest first
  std::int64_t origin_z = 0;
  std::int32_t origin_x = 0, origin_y = 0;
  std::array<Wide<128>, 10> c;
  RootSurface surface;  // of a root face, and of a rational one whose normal is a polynomial
};

// A depth divides by c2 (face.c): a slot that no record filled, or a record that lies, has none.
[[nodiscard]] inline bool has_depth(const ActiveFace& face) {
  return face.kind == FaceKind::rational || face.c[2].sign() > 0;
}

// With line y; at least that, whatever a job says.
[[nodiscard]] inline std::int32_t lines_left(const ActiveFace& face, std::int32_t y) {
  return std::max<std::int32_t>(face.last_line - y, 0) + 1;
}

// Reads what follows the slot number in a face record.
inline void read_face(JobReader& in, Record type, ActiveFace& face) {
  face.order = in.unsigned_number();
  face.origin_x = in.number_in(-largest_origin, largest_origin);
  face.origin_y = in.number_in(-largest_origin, largest_origin);
  face.origin_z = in.number();
  face.kind = type == Record::plane_face  ? FaceKind::plane
              : type == Record::root_face ? FaceKind::root
                                          : FaceKind::rational;
  face.sheet = 0;
  face.block = {};
  face.proofs = {};
  face.ready = false;
  if (face.kind == FaceKind::plane) {
    face.level = in.byte();
  } else {
    const std::uint8_t flags = in.byte();  // bit 0: back sheet; bit 1: normal against the gradient
    if (face.kind == FaceKind::root) face.sheet = (flags & 1U) != 0 ? 1 : -1;
    face.light_sign = (flags & 2U) != 0 ? -1 : 1;
    face.last_line = static_cast<std::int16_t>(in.number_in(0, largest_side - 1));
  }
  const int count = face.kind == FaceKind::plane ? 4 : 10;
  for (int i = 0; i < count; ++i) face.c[i] = in.wide<128>();
}

}  // namespace halfspace
