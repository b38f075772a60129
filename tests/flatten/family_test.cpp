// Shells q and q + k: as integers they differ by a multiple of the world's constant 1, and so cannot meet.
#include "host/flatten/family.hpp"

#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

// p s - q t has no coefficient left but one: which, when the second-order parts are made equal by p and q?
void expect_apart(const IntegerBody& body, std::size_t i, std::size_t j, bool perspective, const std::string& text) {
  const auto& s = body.half_spaces.at(i).c;
  const auto& t = body.half_spaces.at(j).c;
  const std::size_t pivot = s[0] != 0 ? 0 : (s[1] != 0 ? 1 : 3);  // none of them depends on z
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
};

TEST(Families, DifferByAConstantOfTheWorld) {
  const std::string box = "plane l <-1 0 0 -3>; plane r <1 0 0 -3>; plane f <0 -1 0 -3>; plane k <0 1 0 -3>;";
  for (const bool perspective : {false, true}) {
    const std::string view = perspective ? "view v cop 5 4 -20 whw 4 whh 4;" : "view v dop 1 2 -3 whw 4 whh 4;";
    for (const char* pair : shells) {
      const std::string text = "definition d; " + std::string(pair) + box +
                               "body t <a !b l r f k>; enddef; instance i (d =rx 13 =ry 17 =vxz .3 =tx .1);" + view;
      const IntegerScene scene = flat(text, page(500, 500));
      expect_apart(scene.bodies.at(0), 0, 1, perspective, text);
      EXPECT_LT(scene.bound, 0x1p-12) << text;
    }
  }
}

TEST(Families, AConeLeadsItsShells) {
  const Scene scene = scene_of(std::string(shells[1]) + "quadric c <2 2 -2 0 0 0 0 1 0 0>; body t <a b c>;");
  const auto kin = kinships_of(scene.top.quadrics);
  EXPECT_EQ(kin.at(0).family, kin.at(1).family);
  EXPECT_NE(kin[0].family, kin.at(2).family);
  EXPECT_EQ(kin[0].rank, 4);
  EXPECT_EQ(kin[1].rank, 3);
  EXPECT_LT(kin[1].ratio, 0);
  EXPECT_EQ(kin[0].constant, -1);
}

}  // namespace
}  // namespace halfspace
