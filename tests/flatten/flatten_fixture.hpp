// flatten_fixture.hpp - scenes from text, and integer scenes read back as geometry on the page.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "host/flatten/flatten.hpp"
#include "host/scene/parse.hpp"

namespace halfspace {

inline Scene scene_of(const std::string& text) {
  const SourceText source{"test.uq", text};
  ParseResult parsed = parse_uniquadrix({&source, 1});
  for (const Diagnostic& d : parsed.diagnostics) ADD_FAILURE() << format(d);
  return std::move(parsed.scene);
}

inline FlattenOptions page(std::int32_t width, std::int32_t height) {
  FlattenOptions options;
  options.width = width;
  options.height = height;
  options.levels = 65;
  return options;
}

inline IntegerScene flat(const std::string& text, const FlattenOptions& options) {
  FlattenResult result = flatten(scene_of(text), options);
  for (const Diagnostic& d : result.diagnostics) ADD_FAILURE() << format(d);
  return std::move(result.scene);
}

// The messages of a scene that is not to pass, one a line.
inline std::string complaints(const std::string& text, const FlattenOptions& options) {
  std::string all;
  for (const Diagnostic& d : flatten(scene_of(text), options).diagnostics) all += format(d) + "\n";
  return all;
}

// A half-space's value at a point of the page, exactly.
inline mpq_class value_at(const IntegerBody& body, const IntegerHalfSpace& h, const std::array<mpq_class, 3>& p) {
  const mpq_class half(1, 2);
  const mpq_class x = p[0] - half - mpz_class(body.origin[0]);
  const mpq_class y = p[1] - half - mpz_class(body.origin[1]);
  const mpq_class z = p[2] - mpz_class(body.origin[2]);
  const auto& c = h.c;
  if (h.kind == HalfSpaceKind::plane) return c[0] * x + c[1] * y + c[2] * z + c[3];
  return c[0] * x * x + c[1] * y * y + c[2] * z * z +
         2 * (c[3] * x * y + c[4] * y * z + c[5] * x * z + c[6] * x + c[7] * y + c[8] * z) + c[9];
}

// The centre of a sphere or ellipsoid with axes along x, y, z: page dots.
inline std::array<double, 3> centre_of(const IntegerBody& body, std::size_t half_space = 0) {
  const auto& c = body.half_spaces[half_space].c;
  const auto coordinate = [&](std::size_t i) {
    return mpq_class(-c[6 + i], c[i]).get_d() + static_cast<double>(body.origin[i]);
  };
  return {coordinate(0) + 0.5, coordinate(1) + 0.5, coordinate(2)};
}

// Half the width of a sphere: page dots.
inline double radius_of(const IntegerBody& body, std::size_t half_space = 0) {
  const auto& c = body.half_spaces[half_space].c;
  const mpz_class square = c[6] * c[6] + c[7] * c[7] + c[8] * c[8] - c[0] * c[9];
  return mpf_class(sqrt(mpf_class(square, 256)) / c[0]).get_d();
}

inline void expect_near(const std::array<double, 3>& a, const std::array<double, 3>& b, double tolerance = 1e-3) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "coordinate " << i;
}

// Dot (100, 100) of a 200 x 200 page is the origin, 10 dots to a unit, seen along z.
inline const std::string straight_view = "view v dop 0 0 -1 whw 10 whh 10;\n";
inline const std::string small_ball = "quadric s <1 1 1 0 0 0 0 0 0 -1>; body ball <s>;\n";
inline std::string ball_placed(const std::string& transforms) {
  return straight_view + "definition d; " + small_ball + "enddef; instance i (d " + transforms + ");";
}

}  // namespace halfspace
