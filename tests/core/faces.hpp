// faces.hpp - faces for the core's tests, and what is true of them at a dot, computed by GMP from the definitions in
// firmware/core/face.hpp and host/flatten/integer_scene.hpp alone.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <vector>

#include "firmware/core/exact.hpp"
#include "host/flatten/integer_scene.hpp"
#include "tests/core/numbers.hpp"

namespace halfspace::testing {

struct TestFace {
  std::array<mpz_class, 10> c;
  ActiveFace active;
};

// z = (p + s sqrt(q)) / d in page dots, d > 0.
struct ExactDepth {
  mpz_class p, q, d;
  int s = 0;
};

// A face as the core holds it once its record is read; `lighting` makes a root face's surface.
[[nodiscard]] TestFace make_face(FaceKind kind, const std::array<mpz_class, 10>& c, std::array<std::int64_t, 3> origin,
                                 int sheet, int light_sign, std::uint32_t order, const Lighting& lighting);
[[nodiscard]] TestFace random_face(Dice& dice, FaceKind kind, int coefficient_bits, const Lighting& lighting);
// An ellipsoid about (x, y) of some dots' radius, a cone with its apex there, a cylinder: what scenes are made of.
[[nodiscard]] TestFace solid_face(Dice& dice, std::int64_t x, std::int64_t y, std::int64_t radius,
                                  const Lighting& lighting);
[[nodiscard]] Lighting random_lighting(Dice& dice);

// Nothing where the face has no point over the dot.
[[nodiscard]] std::optional<ExactDepth> depth_at(const TestFace& face, std::int32_t x, std::int32_t y);
[[nodiscard]] int compare(const ExactDepth& f, const ExactDepth& g);
[[nodiscard]] bool reaches(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k,
                           std::int32_t x, std::int32_t y);
[[nodiscard]] std::int32_t level_at(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t x,
                                    std::int32_t y);
// The narrowest exact arithmetic that the job writer would ask for with these faces on a page of `side` dots a side; nullptr
// when it would refuse one of them.
[[nodiscard]] const ExactModule* exact_for(std::initializer_list<const TestFace*> faces, const Lighting& lighting,
                                           std::int32_t levels, std::int32_t side);

struct DotRun {
  std::int32_t x0, x1;
};
// The longest runs of dots 0 .. width - 1 of line y over which the face stays one piece: a root face's D >= 0, a rational
// one's b without a change of sign.
[[nodiscard]] std::vector<DotRun> runs_of(const TestFace& face, std::int32_t y, std::int32_t width);

}  // namespace halfspace::testing
