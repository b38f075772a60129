// Mated planes: what touches in the scene touches in the integers.
#include "host/flatten/mating.hpp"

#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

const std::string block =
    "plane l <1 0 0 1>; plane b <0 1 0 1>; plane t <0 1 0 -1>; plane f <0 0 1 1>; plane k <0 0 1 -1>;";

// Equal as planes of the page, whichever way they are written.
bool are_same_plane(const IntegerBody& a, const IntegerHalfSpace& p, const IntegerBody& b, const IntegerHalfSpace& q) {
  for (const std::array<mpq_class, 3>& point :
       {std::array<mpq_class, 3>{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {0, 0, 100}}) {
    if (value_at(a, p, point) != value_at(b, q, point)) return false;
  }
  return true;
}

// Two blocks whose common face is written once as x + 3y + z <= d and once, in another scale, the other way round.
std::string blocks_meeting_at(const std::string& first, const std::string& second) {
  return "definition one; " + block + " plane m <" + first + ">; body one <!l !b t !f k m>; enddef;" +
         "definition two; plane r <1 0 0 -1>; " + block + " plane m <" + second +
         ">; body two <r !b t !f k m>; enddef; instance i (one =ry 13 =rz 21); instance j (two =ry 13 =rz 21);";
}

TEST(Mating, OppositeFacesBecomeOnePlane) {
  const IntegerScene scene = flat(blocks_meeting_at("1 .3 .1 0", "-3 -.9 -.3 0"), page(500, 500));
  const IntegerBody& one = scene.bodies.at(0);
  const IntegerBody& two = scene.bodies.at(1);
  const IntegerHalfSpace& m = one.half_spaces.at(5);
  const IntegerHalfSpace& n = two.half_spaces.at(5);
  EXPECT_TRUE(are_same_plane(one, m, two, n));
  EXPECT_NE(m.complement, n.complement);
}

TEST(Mating, SmallDisagreementsAreClosedAndTheFirstWins) {
  // 10^-6 units are 10^-4 dots.
  const IntegerScene scene = flat(blocks_meeting_at("1 .3 .1 0", "-1 -.3 -.1 -.000001"), page(500, 500));
  const IntegerScene alone = flat(blocks_meeting_at("1 .3 .1 0", "-1 -.3 -.1 0"), page(500, 500));
  const IntegerBody& one = scene.bodies.at(0);
  const IntegerBody& two = scene.bodies.at(1);
  EXPECT_TRUE(are_same_plane(one, one.half_spaces.at(5), two, two.half_spaces.at(5)));
  EXPECT_TRUE(are_same_plane(alone.bodies.at(0), alone.bodies[0].half_spaces.at(5), one, one.half_spaces.at(5)));
  EXPECT_LT(two.half_spaces[5].bound, 0x1p-10 + 0x1p-13);
  EXPECT_GT(two.half_spaces[5].bound, 0);
}

TEST(Mating, LargeDisagreementsStay) {
  const IntegerScene scene = flat(blocks_meeting_at("1 .3 .1 0", "-1 -.3 -.1 -.0001"), page(500, 500));
  const IntegerBody& one = scene.bodies.at(0);
  const IntegerBody& two = scene.bodies.at(1);
  EXPECT_FALSE(are_same_plane(one, one.half_spaces.at(5), two, two.half_spaces.at(5)));
}

TEST(Mating, PlanesThatOnlyCrossStay) {
  const IntegerScene scene = flat(blocks_meeting_at("1 .3 .1 0", "-1 -.301 -.1 0"), page(500, 500));
  const IntegerBody& one = scene.bodies.at(0);
  const IntegerBody& two = scene.bodies.at(1);
  EXPECT_FALSE(are_same_plane(one, one.half_spaces.at(5), two, two.half_spaces.at(5)));
}

TEST(Mating, AMitreOfTwoCylindersIsOnePlane) {
  const std::string text =
      "definition arm; quadric c <1 0 1 0 0 0 0 0 0 -1>; plane m <1 1 0 0>; plane e <0 1 0 5>; body arm <c m !e>; "
      "enddef;"
      "instance a (arm); instance b (arm =sx -1 =rz 90);";
  const IntegerScene scene = flat(text + "view v dop .2 .3 -1;", page(800, 800));
  const IntegerBody& a = scene.bodies.at(0);
  const IntegerBody& b = scene.bodies.at(1);
  const IntegerHalfSpace& m = a.half_spaces.at(1);
  EXPECT_TRUE(are_same_plane(a, m, b, b.half_spaces.at(1)));
}

// Unbounded towards the eye, so its box is a million dots deep: there the values of a plane and of its rounding drift
// apart, but not where the plane is.
TEST(Mating, BoundsStayTightInDeepBoxes) {
  const std::string text =
      "definition d; plane a <1 1.001 0 -1>; plane b <0 1 0 -2>; plane c <0 -2 0 1e-9>; plane e <1 0 0 0>;"
      "body wedge (a b c e); enddef; instance i (d =ry 30 =tz -2.074); view v cop -1 0 0 whw 6.92 whh 6.647;";
  const IntegerScene scene = flat(text, page(64, 64));
  EXPECT_GT(scene.bodies.at(0).origin[2], -(1 << 20));
  EXPECT_LT(scene.bodies.at(0).origin[2], -(1 << 18));
  EXPECT_LT(scene.bound, 1.0 / 1024);
}

TEST(Mating, CostStaysLinearInParallelPlanes) {
  PlaneMating mating({500, 500, 0});
  for (int i = 0; i < 20000; ++i) {
    const Real at = Real(i) / 3;
    const Region box = region_of({{at, 0, 0}, {at + 1, 1, 1}}, 1000);
    mating.add({HalfSpaceKind::plane, {1, 0, 0, -at}}, box, {});
    const PlaneMating::Match match = mating.add({HalfSpaceKind::plane, {-2, 0, 0, 2 * at}}, box, {});
    ASSERT_EQ(match.leader, static_cast<std::size_t>(i));
    ASSERT_TRUE(match.opposite);
  }
}

// In a box as thin as a line two planes that cross in it agree; in one body they stay two.
TEST(Mating, PlanesOfOneBodyStayApart) {
  PlaneMating mating({0, 0, 0});
  const Region line = region_of({{0, 5, 0}, {0, 5, 100}}, 1000);
  const RealHalfSpace flat{HalfSpaceKind::plane, {0, 1, 0, -5}};
  const RealHalfSpace tilted{HalfSpaceKind::plane, {Real(1) / 4096, 1, 0, -5}};
  EXPECT_EQ(mating.add(flat, line, {7}).leader, 0U);
  EXPECT_EQ(mating.add(tilted, line, {7}).leader, 1U);
  EXPECT_EQ(mating.add(tilted, line, {8}).leader, 0U);
  EXPECT_EQ(mating.add(flat, line, {7}).leader, 0U);
}

}  // namespace
}  // namespace halfspace
