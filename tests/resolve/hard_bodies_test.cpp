// Bodies that the paper calls illegal or dangerous, and others where structure degenerates exactly on a scan line.
#include <gtest/gtest.h>

#include "host/resolve/resolve.hpp"
#include "tests/resolve/body_maker.hpp"
#include "tests/resolve/brute_force.hpp"

namespace halfspace::test {
namespace {

using Bodies = std::vector<IntegerHalfSpace>;

struct HardBody {
  const char* name;
  Bodies half_spaces;
};

void PrintTo(const HardBody& body, std::ostream* out) { *out << body.name; }

Bodies with(Bodies first, const Bodies& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Bodies box(long x, long y, long z) {
  return {plane(1, 0, 0, -x),  plane(-1, 0, 0, -x), plane(0, 1, 0, -y),
          plane(0, -1, 0, -y), plane(0, 0, 1, -z),  plane(0, 0, -1, -z)};
}

// x^2 + z^2 <= r2 about the y axis; x^2 + y^2 <= r2 along the rays.
IntegerHalfSpace upright_cylinder(long r2) { return sum_of_squares({{1, 0, 0, 0}, {0, 0, 1, 0}}, -r2); }
IntegerHalfSpace end_on_cylinder(long r2) { return sum_of_squares({{1, 0, 0, 0}, {0, 1, 0, 0}}, -r2); }
IntegerHalfSpace upright_cone(long apex) {
  return sum_of_squares({{2, 0, 0, 0}, {0, 0, 2, 0}, {0, 1, 0, -apex, -1}}, 0);
}

std::vector<HardBody> hard_bodies() {
  const IntegerHalfSpace ball = sphere(0, 0, 0, 100);
  return {
      {"cube", box(9, 7, 5)},
      {"sphere", {ball}},
      {"sphere touched by its limb plane", {ball, plane(1, 0, 0, -10)}},
      {"sphere cut through its limb", {ball, plane(0, 0, 1, 0)}},
      {"sphere touched from outside: one point", {ball, plane(-1, 0, 0, 10)}},
      {"sphere touched at the point nearest to the eye", {ball, plane(0, 0, 1, 10)}},
      {"sphere coincident with itself", {ball, ball}},
      {"sphere and its complement: the surface alone", {ball, complement_of(ball)}},
      {"point", {sphere(0, 0, 0, 0)}},
      {"empty quadric", {sphere(0, 0, 0, -1)}},
      {"everything but a point", with(box(9, 9, 9), {complement_of(sphere(0, 0, 0, 0))})},
      {"line", {sum_of_squares({{1, 0, 0, 0}, {0, 1, 1, 0}}, 0), plane(0, 1, 0, -7), plane(0, -1, 0, -7)}},
      {"line along a scan line", {sum_of_squares({{0, 1, 0, -3}, {0, 0, 1, 0}}, 0)}},
      {"cone with its apex inside", {upright_cone(2), plane(0, 1, 0, -15), plane(0, -1, 0, -15)}},
      {"cone cut at its apex", {upright_cone(2), plane(0, -1, 0, 2), plane(0, 1, 0, -15)}},
      {"cone towards the eye", {sum_of_squares({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0, -1}}, 0)}},
      {"cone with a ruling along the rays", {quadric({1, 0, 0, 0, 1, 0, 0, 0, 0, 0})}},
      {"double plane", with(box(9, 9, 9), {sum_of_squares({{1, 2, 3, 0}}, 0)})},
      {"pair of planes", with(box(9, 9, 9), {quadric({1, -1, 0, 0, 0, 0, 0, 0, 0, 0})})},
      {"pair of irrational planes", with(box(9, 9, 9), {quadric({1, 0, -2, 0, 0, 0, 0, 0, 0, 0})})},
      {"pair of parallel planes", with(box(9, 9, 9), {sum_of_squares({{1, 0, 1, 0}}, -16)})},
      {"plane cutting its own pair", with(box(9, 9, 9), {quadric({1, 0, -1, 0, 0, 0, 0, 0, 0, 0}), plane(1, 0, 1, 0)})},
      {"quadric that is a plane", with(box(9, 9, 9), {quadric({0, 0, 0, 0, 0, 0, 1, 2, 3, 1})})},
      {"constants", {ball, plane(0, 0, 0, 0), quadric({0, 0, 0, 0, 0, 0, 0, 0, 0, -1})}},
      {"never", {ball, plane(0, 0, 0, 1)}},
      {"pyramid of four planes and a redundant one",
       {plane(1, 1, 1, -9), plane(-1, 1, 1, -9), plane(1, -1, 1, -9), plane(-1, -1, 1, -9), plane(0, 0, 1, -9),
        plane(0, 0, -1, 0)}},
      {"three planes through one line",
       {plane(1, 0, 1, 0), plane(-1, 0, 1, 0), plane(0, 0, 1, 0), plane(0, 0, -1, -9)}},
      {"coincident planes", with(box(9, 9, 9), box(9, 9, 9))},
      {"flat box", box(9, 9, 0)},
      {"box of one line", box(9, 0, 4)},
      {"box of one column", box(0, 9, 4)},
      {"box of one dot", box(0, 0, 4)},
      {"box turned away from itself", {plane(1, 0, 0, 3), plane(-1, 0, 0, 2), plane(0, 0, 1, 0)}},
      {"planes along the rays", {plane(1, 0, 0, -3), plane(1, 2, 0, -9), plane(-3, 1, 0, -9), plane(0, 0, 1, 0)}},
      {"one plane", {plane(1, 2, 3, 4)}},
      {"two planes", {plane(1, 2, 3, 4), plane(-3, 1, 1, 2)}},
      {"upright tube",
       {upright_cylinder(100), complement_of(upright_cylinder(64)), plane(0, 1, 0, -9), plane(0, -1, 0, -9)}},
      {"tube end on",
       {end_on_cylinder(100), complement_of(end_on_cylinder(25)), plane(0, 0, 1, -9), plane(1, 2, -3, -9)}},
      {"mitred cylinder", {upright_cylinder(100), plane(1, 1, 0, -9), plane(2, -1, 1, -9)}},
      {"limb on a cutting plane", {upright_cylinder(100), plane(0, 0, 1, 0), plane(1, 0, 0, -10)}},
      {"nested spheres", {ball, complement_of(sphere(0, 0, 0, 64)), plane(1, 1, 1, 0)}},
      {"nested spheres, not concentric", {ball, complement_of(sphere(2, 1, 3, 16))}},
      {"disjoint spheres", {sphere(-9, 0, 0, 25), sphere(9, 0, 0, 25)}},
      {"quadrics kept apart by planes",
       {sum_of_squares({{1, 0, 0, 0}, {0, 0, 1, 0}}, -100), complement_of(sphere(0, 12, 0, 64)), plane(0, 1, 0, -3),
        plane(0, -1, 0, -9)}},
      {"paraboloid", {quadric({1, 1, 0, 0, 0, 0, 0, 0, -2, -40}), plane(0, 0, 1, -30)}},
      {"paraboloid coincident with itself",
       {quadric({1, 1, 0, 0, 0, 0, 0, 0, -2, -40}), quadric({2, 2, 0, 0, 0, 0, 0, 0, -4, -80})}},
      {"saddle z = xy", with(box(9, 9, 30), {quadric({0, 0, 0, 1, 0, 0, 0, 0, -1, 0})})},
      {"hyperbolic cylinder xz = 1: a pole on a column of dots", {quadric({0, 0, 0, 0, 0, 1, 0, 0, 0, -1})}},
      {"yz = 1: a pole on a scan line", {quadric({0, 0, 0, 0, 1, 0, 0, 0, 0, -1})}},
      {"a surface with whole rays in it", {quadric({0, 0, 0, 0, 1, 1, 1, 1, 0, 0}), plane(0, 1, 0, -5)}},
      {"transparent bounds", {ball, transparent(plane(0, 0, -1, 0)), transparent(plane(1, 1, 0, -3))}},
      {"hyperboloid with its waist between two lines",
       {quadric({4, -4, 4, 0, 0, 0, 0, 4, 0, 0}), plane(0, 0, 1, -12), plane(0, 0, -1, -12)}},
  };
}

class HardBodies : public testing::TestWithParam<HardBody> {};

TEST_P(HardBodies, EveryDotOfEveryFaceIsRight) {
  const IntegerScene scene = page_with(GetParam().half_spaces);
  const ResolveResult result = resolve(scene, true);
  ASSERT_TRUE(result.diagnostics.empty()) << result.diagnostics[0].message;
  const auto broken = broken_structure(scene, result.scene);
  EXPECT_FALSE(broken) << *broken;
  const auto wrong = wrong_dot(scene, result.scene);
  EXPECT_FALSE(wrong) << *wrong;
}

INSTANTIATE_TEST_SUITE_P(Resolve, HardBodies, testing::ValuesIn(hard_bodies()));

TEST(Resolve, ASphereIsTwoCellsBetweenTwoArcs) {
  const ResolvedScene resolved = resolve(page_with({sphere(0, 0, 0, 100)}), true).scene;
  EXPECT_EQ(resolved.faces.size(), 2U);
  EXPECT_EQ(resolved.arcs.size(), 2U);
  EXPECT_EQ(resolved.cells.size(), 2U);
  EXPECT_TRUE(resolved.spans.empty());  // the lines of its poles belong to the cells
  for (const Arc& arc : resolved.arcs) {
    EXPECT_EQ(arc.y0, 10);
    EXPECT_EQ(arc.y1, 30);
  }
}

TEST(Resolve, FacesShareTheirArcs) {
  const ResolvedScene resolved = resolve(page_with({sphere(0, 0, 0, 100), plane(1, 2, 5, 0)}), true).scene;
  EXPECT_EQ(resolved.faces.size(), 3U);
  EXPECT_EQ(resolved.arcs.size(), 4U);  // two of the limb, two of the section
}

TEST(Resolve, OnlyTheScissorIsResolved) {
  IntegerScene scene = page_with({plane(1, 2, 3, 4), sphere(0, 0, 0, 300)});
  scene.scissor = {5, 12, 31, 20};
  const ResolveResult result = resolve(scene, true);
  EXPECT_FALSE(broken_structure(scene, result.scene));
  const auto wrong = wrong_dot(scene, result.scene);
  EXPECT_FALSE(wrong) << *wrong;
}

// The box says where a body is; what shows is decided by the half-spaces alone.
TEST(Resolve, ABoxDecidesNoDot) {
  IntegerScene scene = page_with({sphere(0, 0, 0, 100)});
  const std::size_t cells = resolve(scene).scene.cells.size();
  scene.bodies[0].x1 = scene.bodies[0].x0 - 1;
  EXPECT_EQ(resolve(scene).scene.cells.size(), cells);
}

TEST(Resolve, ExitsAreLeftOutOfAClosedBodyOnly) {
  EXPECT_EQ(resolve(page_with({sphere(0, 0, 0, 100)})).scene.faces.size(), 1U);
  EXPECT_EQ(resolve(page_with({sphere(0, 0, 0, 100)}), true).scene.faces.size(), 2U);
  EXPECT_EQ(resolve(page_with({complement_of(sphere(0, 0, 0, 100))})).scene.faces.size(), 2U);
}

}  // namespace
}  // namespace halfspace::test
