// Shells q and q + k: as integers they differ by a multiple of the world's constant 1, and so cannot meet.
#include "host/flatten/family.hpp"

#include "host/flatten/placement.hpp"
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

// p s - q t has no coefficient left but one, when p and q make any other equal?
void expect_apart(const IntegerBody& body, std::size_t i, std::size_t j, bool perspective, const std::string& text) {
  const auto& s = body.half_spaces.at(i).c;
  const auto& t = body.half_spaces.at(j).c;
  std::size_t pivot = 0;
  for (const std::size_t k : {6, 5, 3, 1, 0}) pivot = s[k] != 0 ? k : pivot;  // none of them depends on z
  std::array<mpz_class, 10> apart;
  for (std::size_t k = 0; k < 10; ++k) apart[k] = t[pivot] * s[k] - s[pivot] * t[k];
  for (const std::size_t k : {0, 1, 3, 4, 5, 6, 7}) EXPECT_EQ(apart[k], 0) << text;
  if (perspective) {  // a multiple of (z + oz)^2
    EXPECT_NE(apart[2], 0) << text;
    EXPECT_EQ(apart[8], apart[2] * mpz_class(body.origin[2])) << text;
    EXPECT_EQ(apart[9], apart[8] * mpz_class(body.origin[2])) << text;
  } else {
    EXPECT_NE(apart[9], 0) << text;
    EXPECT_EQ(apart[2], 0) << text;
    EXPECT_EQ(apart[8], 0) << text;
  }
}

const char* const shells[] = {
    "quadric a <1 0 1 0 0 0 0 0 0 -1>; quadric b <1 0 1 0 0 0 0 0 0 -.81>;",
    "quadric a <1 1 -1 0 0 0 0 0 0 -1>; quadric b <-.5 -.5 .5 0 0 0 0 0 0 0>;",
    "quadric a <1 2 3 0 0 0 .1 .2 .3 -1>; quadric b <3 6 9 0 0 0 .3 .6 .9 -2.9999999>;",
    "quadric a <1 -1 0 0 0 0 0 0 0 -.3>; quadric b <1 -1 0 0 0 0 0 0 0 0>;",
    "quadric a <1 .3 0 0 0 0 0 0 1 -.3>; quadric b <1 .3 0 0 0 0 0 0 1 .1>;",
    "quadric a <1 .3 0 0 0 0 .1 0 0 -1>; quadric b <1 .3 0 0 0 0 .1 0 0 -.7>;",
    "quadric a <1 0 0 0 0 0 0 .2 .7 -.3>; quadric b <1 0 0 0 0 0 0 .2 .7 .1>;",
    "quadric a <1 4 0 2 0 0 0 0 0 -.3>; quadric b <1 4 0 2 0 0 0 0 0 -.1>;",
};

void expect_shells_apart(const std::string& planes, const std::string& names, const std::string& view,
                         bool perspective) {
  for (const char* pair : shells) {
    std::string text = "definition d; ";
    text.append(pair).append(planes).append("body t <a !b ").append(names);
    text.append(">; enddef; instance i (d =rx 13 =ry 17 =vxz .3 =tx .1);").append(view);
    const IntegerScene scene = flat(text, page(500, 500));
    expect_apart(scene.bodies.at(0), 0, 1, perspective, text);
    EXPECT_LT(scene.bound, 0x1p-12) << text;
  }
}

const std::string parallel_view = "view v dop 1 2 -3 whw 4 whh 4;";
const std::string perspective_view = "view v cop 5 4 -20 whw 4 whh 4;";

TEST(Families, DifferByAConstantOfTheWorld) {
  const std::string box = "plane l <-1 0 0 -3>; plane r <1 0 0 -3>; plane f <0 -1 0 -3>; plane k <0 1 0 -3>;";
  expect_shells_apart(box, "l r f k", parallel_view, false);
  expect_shells_apart(box, "l r f k", perspective_view, true);
}

// Where a cylinder ends in a point the surface has no normal, and its shells have the same point.
TEST(Families, StayApartUpToTheirVanishingPoint) { expect_shells_apart("", "", perspective_view, true); }

// A tube's walls and bores beside its axis: second-order parts stay proportional, however far the bores are, and
// though one is as long as the pin in it.
TEST(Parallels, StayParallel) {
  const std::string plate =
      "quadric a <1 1 0 0 0 0 0 0 0 -4>; quadric b <2 2 0 0 0 0 0 0 0 -6.7>; quadric c <1 1 0 0 0 0 -.9 .31 0 .9>;"
      "quadric d <1 1 0 0 0 0 5.1 -7.3 0 79>; plane f <0 0 1 -1>; plane k <0 0 -1 -1>;"
      "plane g <0 0 1 -90>; plane h <0 0 -1 -90>; body t (a b !c !d f k); body pin (c g h);";
  for (int turn = 0; turn < 40; ++turn) {
    const IntegerScene scene = flat("definition p; " + plate + " enddef; instance i (p =rx " +
                                        std::to_string(7 * turn) + ".3 =ry 17 =tx .1);" + parallel_view,
                                    page(500, 500));
    const auto& half_spaces = scene.bodies.at(0).half_spaces;
    const auto& first = half_spaces.at(0).c;
    for (std::size_t i = 1; i < 4; ++i) {
      for (std::size_t k = 1; k < 6; ++k) {
        EXPECT_EQ(first[k] * half_spaces.at(i).c[0], first[0] * half_spaces.at(i).c[k]) << "turn " << turn << ' ' << i;
      }
    }
    EXPECT_LT(scene.bound, 0x1p-12);
  }
}

TEST(Families, AreSpheresWhereTheyWere) {
  const IntegerScene scene = flat(
      "definition d; quadric a <1 1 1 0 0 0 .1 .2 .3 -1>; quadric b <3 3 3 0 0 0 .3 .6 .9 -2.9999999>;"
      "body t <a !b>; enddef; instance i (d =rx 13 =ry 17);" +
          parallel_view,
      page(500, 500));
  for (const IntegerHalfSpace& h : scene.bodies.at(0).half_spaces) {
    EXPECT_EQ(h.c[0], h.c[1]);
    EXPECT_EQ(h.c[0], h.c[2]);
    for (const std::size_t mixed : {3, 4, 5}) EXPECT_EQ(h.c[mixed], 0);
  }
}

TEST(Families, KnowWhatTheyAre) {
  const Scene scene = scene_of(std::string(shells[1]) + "quadric c <2 2 -2 0 0 0 0 1 0 0>; body t <a b c>;");
  const auto kin = kinships_of(scene.top.quadrics);
  EXPECT_EQ(kin.at(0).family, kin.at(1).family);
  EXPECT_NE(kin[0].family, kin.at(2).family);
  EXPECT_EQ(kin[0].rank, 4U);
  EXPECT_EQ(kin[1].rank, 3U);
  EXPECT_EQ(kin[1].squares, 3U);
  EXPECT_EQ(kin[0].constant, -1);
  Diagnostics none;
  EXPECT_LT(place_bodies(scene, none).half_spaces.at(1).kin.ratio, 0);
}

}  // namespace
}  // namespace halfspace
