// Where points of the world come to lie on the page: axes, transforms, arrays, names.
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

std::array<double, 3> ball_at(const std::string& transforms) {
  return centre_of(flat(ball_placed(transforms), page(200, 200)).bodies.at(0));
}

TEST(Conventions, PageAxes) {
  expect_near(ball_at(""), {100, 100, 0});
  expect_near(ball_at("=tx 2"), {120, 100, 0});
  expect_near(ball_at("=ty 2"), {100, 80, 0});
  expect_near(ball_at("=tz 2"), {100, 100, 20});
  expect_near(ball_at("=tx 2 =ty 2 =tz 2"), {120, 80, 20});
}

TEST(Conventions, IntegerInputStaysExact) {
  const IntegerScene scene = flat(straight_view + small_ball, page(200, 200));
  const IntegerHalfSpace& h = scene.bodies.at(0).half_spaces.at(0);
  EXPECT_EQ(h.c[0], 2);  // 100 lies between two dot centres
  EXPECT_EQ(h.c[6] * h.c[6] + h.c[7] * h.c[7] + h.c[8] * h.c[8] - h.c[0] * h.c[9], 4 * 100);
  EXPECT_EQ(radius_of(scene.bodies[0]), 10);
}

TEST(Conventions, RotationsFollowTheRightHandOnRowVectors) {
  expect_near(ball_at("=tx 3 =rz 90"), {100, 70, 0}, 0);    // x to y
  expect_near(ball_at("=ty 3 =rx 90"), {100, 100, 30}, 0);  // y to z
  expect_near(ball_at("=tz 3 =ry 90"), {130, 100, 0}, 0);   // z to x
  expect_near(ball_at("=tx 4 =rz 30"), {100 + 40 * 0.86602540378443865, 80, 0}, 1e-4);
}

TEST(Conventions, TranslationMovesAlongOneAxisOrAll) {
  expect_near(ball_at("=tx 3 =ty 2 =tz 1"), {130, 80, 10}, 0);
  expect_near(ball_at("=ta 3"), {130, 70, 30}, 0);
  expect_near(ball_at("=tx 1 =ta -2.5"), {85, 125, -25}, 0);
}

TEST(Conventions, TransformsConcatenateLeftToRight) {
  expect_near(ball_at("=rz 90 =tx 3"), {130, 100, 0});
  expect_near(ball_at("=tx 1 =sa 2 =tx 1"), {130, 100, 0});
  EXPECT_NEAR(radius_of(flat(ball_placed("=sa 2.5"), page(200, 200)).bodies.at(0)), 25, 1e-4);
}

// y' = y + amount x: the ball's centre (2, 0, 0) moves up by 3 * 2.
TEST(Conventions, ShearMovesTheSecondAxisAlongTheFirst) {
  const IntegerBody body = flat(ball_placed("=tx 2 =vxy 3"), page(200, 200)).bodies.at(0);
  const IntegerHalfSpace& h = body.half_spaces.at(0);
  const mpq_class centre = value_at(body, h, {120, 40, 0});
  EXPECT_LT(centre, 0);
  EXPECT_EQ(value_at(body, h, {121, 40, 0}), value_at(body, h, {119, 40, 0}));
  EXPECT_EQ(value_at(body, h, {120, 41, 5}), value_at(body, h, {120, 39, 5}));
}

TEST(Conventions, CopiesOfAnArrayAccumulateTheDelta) {
  const std::string text = straight_view + "definition d; " + small_ball + "enddef; array row (d =tx 4) 4 =rz 90;";
  const IntegerScene scene = flat(text, page(200, 200));
  ASSERT_EQ(scene.bodies.size(), 4U);
  expect_near(centre_of(scene.bodies[0]), {140, 100, 0});
  expect_near(centre_of(scene.bodies[1]), {100, 60, 0});
  expect_near(centre_of(scene.bodies[2]), {60, 100, 0});
  expect_near(centre_of(scene.bodies[3]), {100, 140, 0});
  EXPECT_EQ(scene.bodies[3].name, "row[3]/ball");
}

TEST(Conventions, AChildsTransformComesBeforeItsParents) {
  const std::string text = straight_view + "definition d; " + small_ball +
                           "enddef; definition e; array pair (d =tx 1) 2 =tx 2; enddef;"
                           "array turned (e =rz 90) 2 =tz 5;";
  const IntegerScene scene = flat(text, page(200, 200));
  ASSERT_EQ(scene.bodies.size(), 4U);
  expect_near(centre_of(scene.bodies[1]), {100, 70, 0});
  expect_near(centre_of(scene.bodies[2]), {100, 90, 50});
  EXPECT_EQ(scene.bodies[1].name, "turned[0]/pair[1]/ball");
}

TEST(Conventions, BodiesKeepTheOrderOfTheText) {
  const std::string text = straight_view + "definition d; " + small_ball +
                           "enddef; quadric q <1 1 1 0 0 0 0 0 0 -4>;"
                           "body first <q>; instance second (d); body third <q>;";
  const IntegerScene scene = flat(text, page(200, 200));
  ASSERT_EQ(scene.bodies.size(), 3U);
  EXPECT_EQ(scene.bodies[0].name, "first");
  EXPECT_EQ(scene.bodies[1].name, "second/ball");
  EXPECT_EQ(scene.bodies[2].name, "third");
}

TEST(Conventions, AHalfSpaceAndItsComplementAreTheSameIntegers) {
  const std::string text = straight_view +
                           "quadric s <1 2 3 .1 .2 .3 0 0 0 -7>; plane p <1 .3 .7 .1>;"
                           "quadric outer <1 1 1 0 0 0 0 0 0 -90>; body a <s p>; body b <outer !s !p>;";
  const IntegerScene scene = flat(text, page(200, 200));
  const IntegerBody& a = scene.bodies.at(0);
  const IntegerBody& b = scene.bodies.at(1);
  for (const std::array<mpq_class, 3>& point : {std::array<mpq_class, 3>{3, 5, 7}, {111, 2, -30}, {50, 60, 1}}) {
    EXPECT_EQ(value_at(a, a.half_spaces[0], point), value_at(b, b.half_spaces[1], point));
    EXPECT_EQ(value_at(a, a.half_spaces[1], point), value_at(b, b.half_spaces[2], point));
  }
  EXPECT_FALSE(a.half_spaces[0].complement);
  EXPECT_TRUE(b.half_spaces[1].complement);
}

TEST(Conventions, LocalCoordinatesAreSmallAndTheBoxHoldsTheBody) {
  const IntegerScene scene = flat(ball_placed("=tx 5 =ty 5"), page(200, 200));
  const IntegerBody& body = scene.bodies.at(0);
  EXPECT_NEAR(body.origin[0], 150, 1);
  EXPECT_NEAR(body.origin[1], 50, 1);
  EXPECT_EQ(body.x0, 139);
  EXPECT_EQ(body.x1, 160);
  EXPECT_EQ(body.y0, 39);
  EXPECT_EQ(body.y1, 60);
}

TEST(Conventions, BodiesOffThePageShowOnNoDot) {
  const IntegerScene scene = flat(ball_placed("=tx 1000000"), page(200, 200));
  const IntegerBody& body = scene.bodies.at(0);
  EXPECT_LT(body.x1, body.x0);
  EXPECT_LT(body.origin[0], 200);
  expect_near(centre_of(body), {10000100, 100, 0}, 1e-4);
}

TEST(Conventions, TheSameSceneGivesTheSameIntegers) {
  const std::string text =
      "quadric q <1 2 3 .1 .2 .3 .4 .5 .6 -7>; plane p <.1 .2 .3 -.1>; body b <q p>; view v cop 1 2 -9;";
  const IntegerBody a = flat(text, page(999, 777)).bodies.at(0);
  const IntegerBody b = flat(text, page(999, 777)).bodies.at(0);
  EXPECT_EQ(a.half_spaces[0].c, b.half_spaces[0].c);
  EXPECT_EQ(a.half_spaces[1].c, b.half_spaces[1].c);
}

// Numbers that every host, compiler and level of optimisation has to reproduce.
TEST(Conventions, KnownIntegers) {
  const std::string text =
      "quadric c <1 0 1 0 0 0 0 0 0 -4>; plane t <0 1 0 -2>; plane u <0 1 0 2>;"
      "body can <c t !u>; view v dop .3 .3 -1;";
  const IntegerBody body = flat(text, page(640, 480)).bodies.at(0);
  std::string digits;
  for (const IntegerHalfSpace& h : body.half_spaces) {
    for (const mpz_class& c : h.c) digits += c.get_str() + " ";
  }
  EXPECT_EQ(digits,
            "4761189460225 363141222544 4398046511104 0 -1263768961024 0 2380593639105 181570611272 -631884480512 "
            "-179142390937535688 0 -524288 -150653 -106075562 0 0 0 0 0 0 0 -524288 -150653 105551274 0 0 0 0 0 0 ");
}

}  // namespace
}  // namespace halfspace
