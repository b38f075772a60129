// Rays along an asymptote meet a quadric once: the integers must keep z^2 out, or a second sheet stands far away.
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

struct Asymptotic {
  const char* name;
  const char* quadrics;  // none has z^2, all have another term in z
};
void PrintTo(const Asymptotic& a, std::ostream* out) { *out << a.name; }

const Asymptotic parallel[] = {
    {"Cone", "quadric a <.7 .31 0 .13 2 .9 0 0 0 0>; body t (a);"},
    {"Cone2", "quadric a <-.7 .31 0 .13 .2 .9 0 0 0 0>; body t (!a);"},
    {"Hyperboloid", "quadric a <.7 .31 0 .13 2 .9 .1 .2 .3 -1>; body t (a);"},
    {"PlanesThatMeet", "quadric a <.7 0 0 .35 1.1 2.2 0 0 0 0>; body t (a);"},
    {"HyperbolicCylinder", "quadric a <.7 0 0 .35 1.1 2.2 0 0 0 -.3>; body t (a);"},
    {"HyperbolicParaboloid", "quadric a <.7 0 0 .35 1.1 2.2 .3 .1 0 0>; body t (a);"},
    {"ShellsOfAHyperboloid",
     "quadric a <1 0 0 0 2 0 2 4 0 -4>; quadric b <1 0 0 0 2 0 2 4 0 -2>; quadric c <1 0 0 0 2 0 2 4 0 0>;"
     "body t (a !b !c);"},
    {"ShellsOfAHyperbolicParaboloid",
     "quadric a <.7 0 0 .35 1.1 2.2 .3 .1 0 0>; quadric b <.7 0 0 .35 1.1 2.2 .3 .1 0 1>; body t (a !b);"},
    {"ShellsOfAHyperbolicCylinder",
     "quadric a <.7 0 0 .35 1.1 2.2 0 0 0 -.3>; quadric b <.7 0 0 .35 1.1 2.2 0 0 0 0>; body t (a !b);"},
};

void expect_no_square_of_z(const IntegerBody& body, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& c = body.half_spaces[i].c;
    EXPECT_EQ(c[2], 0) << body.half_spaces[i].name;
    EXPECT_TRUE(c[4] != 0 || c[5] != 0) << body.half_spaces[i].name;
    EXPECT_LT(body.half_spaces[i].bound, 1.0 / 1024);
  }
}

class AlongAsymptotes : public ::testing::TestWithParam<Asymptotic> {};

TEST_P(AlongAsymptotes, NoSecondSheetAppears) {
  const std::string placed = "definition d; " + std::string(GetParam().quadrics) +
                             " enddef; instance i (d =rz 33 =sx 1.7 =sy .9 =vxy .4 =tx .31 =ty .17 =tz .1);";
  for (const std::string view : {"view v dop 0 0 -1 whw 3 whh 3;", "view v dop 0 0 -1 vpn -2 0 5 whw 3 whh 3;"}) {
    const IntegerBody body = flat(placed + view, page(640, 480)).bodies.at(0);
    expect_no_square_of_z(body, body.half_spaces.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Parallel, AlongAsymptotes, ::testing::ValuesIn(parallel),
                         [](const auto& test) { return std::string(test.param.name); });

// The eye, at (.3, .2, -1), lies on the first surface; behind the second, where there is one.
const Asymptotic central[] = {
    {"Cone", "quadric a <1 2 -.17 0 0 0 0 0 0 0>; body t (a);"},
    {"Cylinder", "quadric a <1 1 0 0 0 0 0 0 0 -.13>; body t (a);"},
    {"Tube", "quadric a <1 1 0 0 0 0 0 0 0 -.13>; quadric b <1 1 0 0 0 0 0 0 0 -.05>; body t (a !b);"},
    {"NestedBalls", "quadric a <1 1 1 0 0 0 0 0 0 -1.13>; quadric b <1 1 1 0 0 0 0 0 0 -.5>; body t (a !b);"},
};

class FromASurface : public ::testing::TestWithParam<Asymptotic> {};

TEST_P(FromASurface, TheEyeStaysOnIt) {
  const std::string view = "view v cop .3 .2 -1 vrp 0 0 1 whw 1.3 whh 1.1;";
  expect_no_square_of_z(flat(GetParam().quadrics + view, page(640, 480)).bodies.at(0), 1);
}

INSTANTIATE_TEST_SUITE_P(Central, FromASurface, ::testing::ValuesIn(central),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace halfspace
