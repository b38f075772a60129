// Input that is wrong, degenerate or out of all measure: a clear word and an end, whatever it is.
#include "host/flatten/real.hpp"
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

void expect_complaint(const std::string& text, const std::string& part, const FlattenOptions& options = page(99, 99)) {
  EXPECT_NE(complaints(text, options).find(part), std::string::npos) << text << "\nsays " << complaints(text, options);
}

TEST(Errors, NameTheStatementAndTheRemedy) {
  expect_complaint(small_ball + "\nview v dop 0 1 0;", "vup is parallel to vpn (the opposite of dop)");
  expect_complaint(small_ball + "\nview v dop 0 0 -1 vup 0 0 3;", "test.uq:3:19: error: vup is parallel to vpn");
  expect_complaint(small_ball + "view v vpn 0 0 1 dop 1 0 0;", "dop is parallel to the view plane; turn");
  expect_complaint(small_ball + "view v vpn 0 0 1 cop 3 4 0;", "cop lies in the view plane through vrp; move");
  expect_complaint(small_ball + "view v vpn 0 0 -1 dop 0 0 -1;", "write its opposite");
  expect_complaint(small_ball + "view v vpn 0 0 -1 cop 0 0 -5;", "write its opposite");
}

std::string complaints_of(const Scene& scene) {
  std::string all;
  for (const Diagnostic& d : flatten(scene, page(99, 99)).diagnostics) all += format(d) + "\n";
  return all;
}

// What the parser refuses, from whoever builds a scene without it.
TEST(Errors, OfScenesThatNoParserHasSeen) {
  Scene scene = scene_of("definition d; " + small_ball + "enddef; instance i (d =sx 2); view v fbp 1 3;");
  scene.views[0].parameters[0].values[0] = {"4", 4};
  EXPECT_NE(complaints_of(scene).find("front clipping plane of fbp lies behind the back"), std::string::npos);
  std::get<InstanceStatement>(scene.top.placements[0]).transforms[0] = ScaleAllTransform{{"0", 0}};
  EXPECT_NE(complaints_of(scene).find("'i' scales by 0"), std::string::npos);
}

TEST(Errors, NoHalfSpaceIsTooDegenerate) {
  for (const char* constant : {"0", "1", "-1"}) {
    Scene scene = scene_of("plane p <1 0 0 0>; body b <p>;" + straight_view);
    scene.top.planes[0].coefficients[0] = {"0", 0};
    scene.top.planes[0].coefficients[3] = {constant, 0};
    const FlattenResult result = flatten(scene, page(99, 99));
    ASSERT_EQ(result.scene.bodies.size(), 1U);
    EXPECT_EQ(result.scene.bodies[0].half_spaces.at(0).c[3], std::stoi(constant));
  }
}

TEST(Errors, OfThePage) {
  expect_complaint(small_ball, "has no dot", page(0, 5));
  expect_complaint(small_ball, "has no dot", page(5, -1));
  const FlattenResult result = flatten(scene_of(small_ball), page(32768, 5));
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::limit);
  FlattenOptions options = page(5, 5);
  options.levels = 257;
  expect_complaint(small_ball, "2 to 256", options);
}

TEST(Limits, OfPlacedBodies) {
  const std::string text = "definition d; " + small_ball +
                           "enddef; definition e; array a (d) 2000 =tx 1; enddef;\n"
                           "array b (e) 501 =ty 1;";
  const FlattenResult result = flatten(scene_of(text), page(99, 99));
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::limit);
  EXPECT_EQ(format(result.diagnostics[0]),
            "test.uq:3:1: error: 'b' brings the picture to more than 100000 bodies; place fewer copies");
}

TEST(Limits, ArraysOfNothingCostNothing) {
  std::string text = "definition d0; plane p <1 0 0 0>; enddef;";
  for (int i = 1; i < 9; ++i) {
    const std::string k = std::to_string(i);
    text += "definition d" + k + "; array a (d" + std::to_string(i - 1) + ") 1000000 =tx 1; enddef;";
  }
  const std::string all = text + small_ball + "instance i (d8);";
  EXPECT_EQ(flat(all, page(9, 9)).bodies.size(), 1U);
}

TEST(Limits, OfNesting) {
  std::string text = "definition d0; " + small_ball + "enddef;";
  for (int i = 1; i < 900; ++i) {
    text += "definition d" + std::to_string(i) + "; instance i (d" + std::to_string(i - 1) + "); enddef;";
  }
  Scene scene = scene_of(text + "instance i (d899);" + straight_view);
  EXPECT_EQ(complaints_of(scene), "");
  for (int i = 900; i < 5000; ++i) {
    Group group = scene.definitions.back();
    std::get<InstanceStatement>(group.placements[0]).definition = group.id;
    group.id = std::string("d").append(std::to_string(i));
    scene.definitions.push_back(group);
  }
  std::get<InstanceStatement>(scene.top.placements[0]).definition = "d4999";
  EXPECT_NE(complaints_of(scene).find("nested more than 1000 deep"), std::string::npos);
}

// A scene that is drawn within the promise, or a complaint.
void expect_outcome(const std::string& text) {
  const FlattenResult result = flatten(scene_of(text), page(99, 99));
  if (has_errors(result.diagnostics)) return;
  EXPECT_EQ(result.scene.bodies.size(), 1U) << text;
  EXPECT_LE(result.scene.bound, 1.0 / 256) << text;
}

TEST(Limits, NumbersOfAnySize) {
  const std::string number[] = {"1e308", "-1e308", "1e-308", "0", "1e20", "-3"};
  for (const std::string& a : number) {
    for (const std::string& b : number) {
      for (const std::string& view : {std::string(), straight_view, std::string("view v cop 3 4 -9 whw 3 whh 2;"),
                                      "view v vrp " + a + " 0 0 cop 0 0 " + b + " whw 1 whh 1;"}) {
        const std::string bodies = "plane p <" + a + " " + b + " 1 " + b + ">; quadric q <" + a + " 1 " + b + " 0 " +
                                   a + " 0 1 0 " + b + " -1>; body x <p q>;";
        const std::string moved = "definition d; " + small_ball + "enddef; instance i (d =tx " + a + " =sy " +
                                  (b == "0" ? "1" : b) + " =rz " + a + " =vxy " + b + ");";
        expect_outcome(bodies + view);
        expect_outcome(moved + view);
      }
    }
  }
}

TEST(Limits, TransformsThatLeaveTheRangeSaySo) {
  std::string scales;
  for (int i = 0; i < 9; ++i) scales += " =sx 1e308 =sy 1e-308";
  expect_complaint("definition d; quadric s <1 1 1 2 3 4 5 6 7 -1>; body b <s>; enddef; instance i (d " + scales + ");",
                   "beyond 10^4900");
}

TEST(Limits, DegenerateHalfSpacesAreTaken) {
  for (const char* text :
       {"quadric q <0 0 0 0 0 0 1 0 0 0>; body b <q>;", "quadric q <1 1 1 0 0 0 0 0 0 0>; body b <q>;",
        "quadric q <1 1 1 0 0 0 0 0 0 1>; body b <q>;", "quadric q <1 0 0 0 0 0 0 0 0 0>; body b <q q !q>;"}) {
    EXPECT_EQ(flat(text + straight_view, page(99, 99)).bodies.size(), 1U) << text;
  }
}

// The giant shares four planes with the box, whose half-size is 20 dots.
std::string box_and_giant(const std::string& near) {
  return "plane l <-1 .1 0 -20>; plane r <1 .2 .1 -20>; plane d <0 -1 .1 -20>; plane u <0 1 .1 -20>;"
         "plane f <0 0 -1 -20>; plane k <0 0 1 -20>; plane far <1 .3 0 -15000>; plane near <-1 .1 0 " +
         near + ">; body box (l r d u f k); body giant (near far d u f k); view v dop .1 .2 -1 ";
}

TEST(Limits, AGiantOffThePageIsHeldToThePage) {
  EXPECT_LT(flat(box_and_giant("100") + "whw 32 whh 32;", page(64, 64)).bound, 0x1p-13);
}

TEST(Limits, AGiantLeavesASmallBodyItsAccuracy) {
  const IntegerScene scene = flat(box_and_giant("-20") + "whw 16000 whh 16000;", page(32000, 32000));
  for (const IntegerHalfSpace& h : scene.bodies.at(0).half_spaces) EXPECT_LT(h.bound, 0x1p-13) << h.name;
}

// A window a hundred times as wide as the eye is far away has normals as exact as any; one 10^9 times as wide is refused.
TEST(Limits, OfWideViews) {
  const auto window = [](const std::string& half) {
    return "quadric s <1 1 1 0 0 0 0 0 -2 3>; body b (s); view v cop 0 0 -1 whw " + half + " whh " + half + ";";
  };
  const IntegerScene wide = flat(window("50"), page(200, 200));
  EXPECT_GE(wide.lighting.normal_matrix[0][0], 1 << 9);
  EXPECT_NE(complaints(window("1e9"), page(200, 200)).find("too near to the view plane"), std::string::npos);
}

// A wedge with an angle of a billionth, seen along its sides: the edge is 2 10^10 dots behind vrp.
TEST(Limits, AWedgeAlongTheRaysEndsWhereItShould) {
  const IntegerScene scene = flat(straight_view +
                                      "plane side <1 0 0.000000001 -1>; plane other <-1 0 0 -1>; plane y <0 1 0 0>;"
                                      "plane z <0 0 1 0>; body wedge (side other y !z);",
                                  page(200, 200));
  const IntegerBody& wedge = scene.bodies[0];
  const auto off = [&](const IntegerHalfSpace& h, int x, long z) {  // dots from (x, 0, z)
    return mpq_class(value_at(wedge, h, {x, 0, mpz_class(z)}) / h.c[0]).get_d();
  };
  EXPECT_NEAR(off(wedge.half_spaces[0], 90, 20'000'000'000), 0, 1e-3);
  EXPECT_NEAR(off(wedge.half_spaces[0], 110, 0), 0, 1e-3);
  EXPECT_NEAR(off(wedge.half_spaces[1], 90, 20'000'000'000), 0, 1e-3);
}

// Two bodies' sides are the same near vrp, but not as deep as a wedge goes, or a body without end.
TEST(Limits, PlanesMateAsDeepAsTheirBodiesGo) {
  const std::string surfaces =
      "plane side <1 0 0.000001 -1>; plane end <1 0 0 -1>; plane other <-1 0 0 -1>;"
      "plane y <0 1 0 0>; plane y1 <0 -1 0 -1>; plane z <0 0 1 0>; plane back <0 0 1 -5>;";
  const auto bodies_share_a_side = [&](const std::string& bodies) {
    const IntegerScene scene = flat(straight_view + surfaces + bodies, page(200, 200));
    const auto slope = [&](std::size_t body) {
      const auto& c = scene.bodies[body].half_spaces[0].c;
      return mpq_class(mpq_class(c[2]) / c[0]);
    };
    return slope(0) == slope(1);
  };
  EXPECT_TRUE(bodies_share_a_side("body a (side other y y1 !z back); body b (end other y y1 !z back);"));
  EXPECT_FALSE(bodies_share_a_side("body a (side other y y1 !z); body b (end other y y1 !z back);"));
  EXPECT_FALSE(bodies_share_a_side("body a (side other y y1 !z back); body b (end other y y1 !z);"));
}

TEST(Real, DecimalsAndIntegersRoundTrip) {
  EXPECT_EQ(decimal_to_real("0.5") * 2, 1);
  EXPECT_EQ(decimal_to_real("-1.25e2"), -125);
  EXPECT_EQ(decimal_to_real("1e-308") * decimal_to_real("1e308") > Real(1) - power_of_two(-100), true);
  EXPECT_EQ(round_to_integer(Real(5) / 2), 3);
  EXPECT_EQ(round_to_integer(Real(-5) / 2), -3);
  EXPECT_EQ(round_to_integer(power_of_two(200)), mpz_class(1) << 200);
  EXPECT_EQ(round_to_integer(power_of_two(-200)), 0);
  const mpz_class large = (mpz_class(1) << 112) + 1;
  EXPECT_EQ(round_to_integer(to_real(large)), large);
  EXPECT_EQ(floor_of(Real(-5) / 2), -3);
}

TEST(Real, RootsAreGoodToTheLastBit) {
  EXPECT_EQ(square_root(9), 3);
  EXPECT_EQ(square_root(Real(1) / 4) * 2, 1);
  const Real two = square_root(2) * square_root(2);
  EXPECT_LT(static_cast<double>(magnitude(two - 2)), 1e-33);
  EXPECT_EQ(square_root(power_of_two(-3000)), power_of_two(-1500));
}

TEST(Real, QuarterTurnsAreExact) {
  for (const char* turns : {"90", "-270", "450", "90.0e0", "3690"}) {
    EXPECT_EQ(sine_cosine_of_degrees(turns).sine, 1) << turns;
    EXPECT_EQ(sine_cosine_of_degrees(turns).cosine, 0) << turns;
  }
  EXPECT_EQ(sine_cosine_of_degrees("30").sine * 2, 1);
  EXPECT_EQ(sine_cosine_of_degrees("1e308").sine, sine_cosine_of_degrees("280").sine);
}

}  // namespace
}  // namespace halfspace
