// Faces along the axes of the page, lit along them: boundaries between levels are columns or lines of dots that tie exactly.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/render/compare.hpp"
#include "tests/render/draw_levels.hpp"

namespace halfspace {
namespace {

using Quadric = std::array<std::int64_t, 10>;
using Plane = std::array<std::int64_t, 4>;

struct Face {
  const char* name;
  Quadric quadric;
  std::vector<Plane> ends;
};

// Of radius 40, about the origin.
const std::vector<Face>& faces() {
  static const std::vector<Face> all{
      {"sphere", {1, 1, 1, 0, 0, 0, 0, 0, 0, -1600}, {}},
      {"upright cylinder", {1, 0, 1, 0, 0, 0, 0, 0, 0, -1600}, {{0, 1, 0, -44}, {0, -1, 0, -44}}},
      {"cylinder along the lines", {0, 1, 1, 0, 0, 0, 0, 0, 0, -1600}, {{1, 0, 0, -44}, {-1, 0, 0, -44}}},
      {"leaning cylinder", {2, 1, 1, 0, -1, 0, 0, 0, 0, -3200}, {{0, 1, 1, -44}, {0, -1, -1, -44}}},
      {"upright cone", {4, -1, 4, 0, 0, 0, 0, -48, 0, -2304}, {{0, 1, 0, -32}, {0, -1, 0, -40}}},
      {"cone along the lines", {-1, 4, 4, 0, 0, 0, -48, 0, 0, -2304}, {{1, 0, 0, -32}, {-1, 0, 0, -40}}},
      {"cone along the rays", {4, 4, -1, 0, 0, 0, 0, 0, -48, -2304}, {{0, 0, 1, -32}, {0, 0, -1, -40}}},
      {"upright paraboloid", {1, 0, 1, 0, 0, 0, 0, -18, 0, -400}, {{0, 1, 0, -32}}},
  };
  return all;
}

IntegerScene scene_of(const Face& face, const std::array<std::int64_t, 3>& light, std::int32_t levels) {
  IntegerScene scene;
  scene.width = scene.height = 96;
  scene.levels = levels;
  scene.scissor = {0, 0, 95, 95};
  for (std::size_t i = 0; i < 3; ++i) scene.lighting.normal_matrix[i][i] = 1;
  scene.lighting.light = light;
  scene.lighting.unit = scene.lighting.parallel = 1;
  IntegerBody& body = scene.bodies.emplace_back();
  body.origin = {48, 48, 0};
  body.x1 = body.y1 = 95;
  IntegerHalfSpace& quadric = body.half_spaces.emplace_back();
  quadric.kind = HalfSpaceKind::quadric;
  for (std::size_t i = 0; i < 10; ++i) quadric.c[i] = face.quadric[i];
  for (const Plane& end : face.ends) {
    IntegerHalfSpace& plane = body.half_spaces.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) plane.c[i] = end[i];
  }
  return scene;
}

TEST(AxisAlignedFaces, AreExactHoweverTheyAreLit) {
  for (const Face& face : faces()) {
    for (const std::array<std::int64_t, 3>& light : std::vector<std::array<std::int64_t, 3>>{
             {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {3, 4, 0}, {3, 0, -4}}) {
      for (const std::int32_t levels : {2, 11, 41, 81, 256}) {
        const IntegerScene scene = scene_of(face, light, levels);
        const testing::Drawn drawn = testing::draw_levels(scene, Shader::contour);
        ASSERT_EQ(drawn.refusal, "");
        ASSERT_EQ(testing::first_difference(scene, drawn.levels), "")
            << face.name << ", light " << light[0] << " " << light[1] << " " << light[2] << ", " << levels << " levels";
      }
    }
  }
}

// What a dot of a column tells holds for all of them: a level is not asked for again on each line.
TEST(AxisAlignedFaces, OfColumnsAreAskedOnce) {
  for (const std::array<std::int64_t, 3>& light :
       std::vector<std::array<std::int64_t, 3>>{{1, 0, 0}, {0, 0, -1}, {3, 0, -4}}) {
    const testing::Drawn drawn = testing::draw_levels(scene_of(faces()[1], light, 81), Shader::contour);
    constexpr std::uint32_t lines = 89;
    EXPECT_LT(drawn.result.counters.exact_levels, 3 * lines) << light[0] << " " << light[2];
  }
}

}  // namespace
}  // namespace halfspace
