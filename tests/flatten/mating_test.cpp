// Mated planes: what touches in the scene touches in the integers.
#include "host/flatten/mating.hpp"

#include <sstream>

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

// Planes of the page itself, by themselves.
class PlaneBench {
 public:
  explicit PlaneBench(const Vector3& middle) : mating_(middle, 1000) {}
  SurfaceMating::Match add(const std::array<Real, 4>& c, const Region& region,
                           const std::vector<std::uint32_t>& bodies) {
    const RealHalfSpace plane{HalfSpaceKind::plane, {c[0], c[1], c[2], c[3]}};
    return mating_.add({plane, &source_, &identity_matrix}, region, bodies);
  }

 private:
  const PlacedHalfSpace source_{};
  SurfaceMating mating_;
};

TEST(Mating, CostStaysLinearInParallelPlanes) {
  PlaneBench mating({500, 500, 0});
  for (int i = 0; i < 20000; ++i) {
    const Real at = Real(i) / 3;
    const Region box = region_of({{at, 0, 0}, {at + 1, 1, 1}}, 1000);
    mating.add({1, 0, 0, -at}, box, {});
    const SurfaceMating::Match match = mating.add({-2, 0, 0, 2 * at}, box, {});
    ASSERT_EQ(match.leader, static_cast<std::size_t>(i));
    ASSERT_TRUE(match.opposite);
  }
}

// In a box as thin as a line two planes that cross in it agree; in one body they stay two.
TEST(Mating, PlanesOfOneBodyStayApart) {
  PlaneBench mating({0, 0, 0});
  const Region line = region_of({{0, 5, 0}, {0, 5, 100}}, 1000);
  const std::array<Real, 4> flat{0, 1, 0, -5};
  const std::array<Real, 4> tilted{Real(1) / 4096, 1, 0, -5};
  EXPECT_EQ(mating.add(flat, line, {7}).leader, 0U);
  EXPECT_EQ(mating.add(tilted, line, {7}).leader, 1U);
  EXPECT_EQ(mating.add(tilted, line, {8}).leader, 0U);
  EXPECT_EQ(mating.add(flat, line, {7}).leader, 0U);
}

// Equal as surfaces of the page, whichever way they are written: ten points tell quadrics apart.
bool are_same_quadric(const IntegerBody& a, const IntegerHalfSpace& p, const IntegerBody& b,
                      const IntegerHalfSpace& q) {
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        const std::array<mpq_class, 3> point{100 * x, 100 * y, 100 * z};
        if (value_at(a, p, point) != value_at(b, q, point)) return false;
      }
    }
  }
  return true;
}

const char* const quadric_kinds[] = {
    "1 1 1 0 0 0 0 0 0 -1",                              // sphere
    "2.84 1.48 1.76 -.39 .09 -.08 -.22 -.34 .36 -1.57",  // ellipsoid
    "1 -1 1 0 0 0 0 0 0 -1",                             // hyperboloids
    "1 -1 1 0 0 0 0 0 0 .4",
    "1 -1 1 0 0 0 0 0 0 0",  // cone
    "1 0 1 0 0 0 0 .5 0 -1",
    "1 0 -1 0 0 0 0 .5 0 0",  // paraboloids
    "1 0 1 0 0 0 0 0 0 -1",
    "1 0 -1 0 0 0 0 0 0 -.3",  // cylinders
    "0 1 0 0 0 0 0 0 .5 -.2",
    "0 1 0 0 0 0 0 0 0 -.49",  // parabolic cylinder, two parallel planes
    "0 1 -1 0 0 0 0 0 0 0",
    ".3 -.7 0 .1 0 .2 .1 0 .2 .1",  // crossing planes
};

// Two bodies inside one box, bounded by the same surface, which two definitions and instances write each in its own way.
std::string quadrics_meeting(const std::string& first, const std::string& second, const std::string& first_placed,
                             const std::string& second_placed, const std::string& view) {
  const std::string box =
      "plane l <-1 0 0 -1.3>; plane r <1 0 0 -1.3>; plane b <0 -1 0 -1.3>; plane t <0 1 0 -1.3>; "
      "plane f <0 0 -1 -1.3>; plane k <0 0 1 -1.3>;";
  return "definition one;" + box + "quadric q <" + first + ">; body one <q l r b t f k>; enddef;" + "definition two;" +
         box + "quadric q <" + second + ">; body two <!q l r b t f k>; enddef;" + "instance i (one " + first_placed +
         "); instance j (two " + second_placed + ");" + view;
}

// Expects them to be one; `opposite` where the second is written the other way round.
void expect_mated(const std::string& text, bool opposite) {
  const IntegerScene scene = flat(text, page(500, 500));
  const IntegerBody& one = scene.bodies.at(0);
  const IntegerBody& two = scene.bodies.at(1);
  const IntegerHalfSpace& p = one.half_spaces.at(0);
  const IntegerHalfSpace& q = two.half_spaces.at(0);
  EXPECT_TRUE(are_same_quadric(one, p, two, q)) << text;
  EXPECT_EQ(p.complement == q.complement, opposite) << text;
  EXPECT_LT(scene.bound, 0x1p-10 + 0x1p-13) << text;
}

const std::string mating_views[] = {"view v dop 1 2 -3 whw 4 whh 4;", "view v cop 5 4 -20 whw 4 whh 4;"};

std::string times(const std::string& coefficients, double factor) {
  std::istringstream in(coefficients);
  std::ostringstream out;
  out.precision(17);
  for (double v = 0; in >> v;) out << v * factor << " ";
  return out.str();
}

TEST(MatedQuadrics, AreOneWhateverTheirFactor) {
  for (const std::string quadric : quadric_kinds) {
    for (const std::string& view : mating_views) {
      for (const std::string placed : {"", "=sx 1.3 =rz 31", "=vxy -.1 =rx 13 =tx .2 =sa -.66"}) {
        expect_mated(quadrics_meeting(quadric, quadric, placed, placed, view), false);
        expect_mated(quadrics_meeting(quadric, times(quadric, 7), placed, placed, view), false);
        expect_mated(quadrics_meeting(quadric, times(quadric, -3), placed, placed, view), true);
      }
    }
  }
}

TEST(MatedQuadrics, AreOneHoweverTheyAreTurned) {
  for (const std::string& view : mating_views) {
    for (const std::string quadric : {"1 1 1 0 0 0 0 0 0 -1", "1 -1 1 0 0 0 0 0 0 -1", "1 -1 1 0 0 0 0 0 0 0",
                                      "1 0 1 0 0 0 0 .5 0 -1", "1 0 1 0 0 0 0 0 0 -1"}) {
      for (const std::string turn : {"=ry 90", "=ry 180", "=ry 37", "=ry 30 =ry 30 =ry 30"}) {
        const std::string placed = "=vxy -.04 =rx 13";
        expect_mated(quadrics_meeting(quadric, quadric, placed, turn + placed, view), false);
      }
    }
    expect_mated(quadrics_meeting("1 -1 0 0 0 0 0 0 0 0", "1 -1 0 0 0 0 0 0 0 0", "=vxy .2", "=rz 90 =vxy .2", view),
                 true);
    expect_mated(quadrics_meeting("1 2 3 0 0 0 0 0 0 -1", "4 2 3 0 0 0 0 0 0 -1", "", "=sx 2", view), false);
  }
}

// What differs by more than twelve digits say is not the same.
TEST(MatedQuadrics, ThatDifferStay) {
  for (const std::string& view : mating_views) {
    const IntegerScene scene =
        flat(quadrics_meeting("1 1 1 0 0 0 0 0 0 -1", "1 1 1 0 0 0 0 0 0 -1.000001", "", "", view), page(500, 500));
    EXPECT_FALSE(are_same_quadric(scene.bodies.at(0), scene.bodies[0].half_spaces.at(0), scene.bodies.at(1),
                                  scene.bodies[1].half_spaces.at(0)));
  }
}

// One shared wall makes one family of the shells of two groups, in which each has its own walls besides.
TEST(MatedQuadrics, MakeOneFamilyOfTwo) {
  for (const std::string& view : mating_views) {
    const std::string text =
        "definition inner; quadric a <1 .7 0 .1 0 0 0 0 .2 -.3>; quadric b <1 .7 0 .1 0 0 0 0 .2 -1>; body t <!a b>;"
        "enddef; definition outer; quadric b <-3 -2.1 0 -.3 0 0 0 0 -.6 3>; quadric c <2 1.4 0 .2 0 0 0 0 .4 -2.7>;"
        "body t <b c>; enddef; instance i (inner =vxy .1 =rx 11); instance j (outer =vxy .1 =rx 11);" +
        view;
    const IntegerScene scene = flat(text, page(500, 500));
    const IntegerBody& one = scene.bodies.at(0);
    const IntegerBody& two = scene.bodies.at(1);
    EXPECT_TRUE(are_same_quadric(one, one.half_spaces.at(1), two, two.half_spaces.at(0))) << text;
    // Per unit of x^2, b - a and c - a are multiples of one square, so no two of them meet.
    const auto value = [](const IntegerBody& body, std::size_t i, int x, int y, int z) {
      const IntegerHalfSpace& h = body.half_spaces.at(i);
      return mpq_class(value_at(body, h, {mpq_class(x), mpq_class(y), mpq_class(z)}) / h.c[0]);
    };
    const auto apart = [&](int x, int y, int z) {
      const mpq_class common = value(one, 0, x, y, z);
      return std::pair<mpq_class, mpq_class>(value(one, 1, x, y, z) - common, value(two, 1, x, y, z) - common);
    };
    EXPECT_LT(scene.bound, 0x1p-12) << text;
    const auto here = apart(0, 0, -1000);
    for (const auto& point : {apart(77, 300, -700), apart(-20, 30, -2000), apart(500, -9, -1)}) {
      EXPECT_EQ(here.first * point.second, here.second * point.first) << text;
    }
  }
}

// A quadric's value is that of the planes' product, to a factor.
void expect_product(const IntegerBody& body, const IntegerHalfSpace& quadric, const IntegerHalfSpace& p,
                    const IntegerHalfSpace& q, const std::string& text) {
  const auto both = [&](int x, int y, int z) {
    const std::array<mpq_class, 3> point{x, y, z};
    return std::pair<mpq_class, mpq_class>(value_at(body, quadric, point),
                                           value_at(body, p, point) * value_at(body, q, point));
  };
  const auto here = both(1, 2, 3);
  EXPECT_NE(here.first, 0);
  for (const auto& there : {both(100, 7, 9), both(-7, 200, -600), both(0, 0, 0), both(333, 1, 77)}) {
    EXPECT_EQ(here.first * there.second, here.second * there.first) << text;
  }
}

// Pairs of planes, written as quadrics, beside the same planes: what is left of y^2 >= 1 in |y| <= 1 is two plates.
TEST(MatedQuadrics, ThatAreTwoPlanesAreTheirProduct) {
  const std::array<const char*, 3> pairs[] = {
      {"0 1 0 0 0 0 0 0 0 -1", "0 1 0 -1", "0 -1 0 -1"},
      {"0 -.49 0 0 0 0 0 0 0 .1", "0 7 0 -3.1622776601683793319988935", "0 7 0 3.1622776601683793319988935"},
      {"0 -1 1 0 0 0 0 0 0 0", "0 1 -1 0", "0 -3 -3 0"},
      {"0 0 0 1 0 0 0 0 0 0", "1 0 0 0", "0 3 0 0"}};
  for (const auto& [quadric, first, second] : pairs) {
    for (const std::string& view : mating_views) {
      std::string text = "definition d; quadric q <";
      text.append(quadric).append(">; plane a <").append(first).append(">; plane b <").append(second);
      text +=
          ">; plane l <-1 0 0 -1>; plane r <1 0 0 -1>; plane f <0 0 -1 -1>; plane k <0 0 1 -1>;"
          "body plates <!q a b l r f k>; enddef; instance i (d =vxy .31 =rx 17 =rz 23);";
      const IntegerScene scene = flat(text + view, page(500, 500));
      const IntegerBody& body = scene.bodies.at(0);
      expect_product(body, body.half_spaces.at(0), body.half_spaces.at(1), body.half_spaces.at(2), text + view);
      EXPECT_LT(scene.bound, 0x1p-12) << text;
    }
  }
}

TEST(MatedQuadrics, WithoutSquaresArePlanes) {
  const std::string text =
      "definition one; quadric m <0 0 0 0 0 0 .5 .15 .05 -.1>; " + block + " body one <m !l !b t !f k>; enddef;" +
      "definition two; plane r <1 0 0 -1>; " + block +
      " plane m <-3 -.9 -.3 .3>; body two <m r !b t !f k>; enddef; instance i (one =ry 13); instance j (two =ry 13);";
  for (const std::string& view : mating_views) {
    const IntegerScene scene = flat(text + view, page(500, 500));
    const IntegerBody& one = scene.bodies.at(0);
    const IntegerBody& two = scene.bodies.at(1);
    EXPECT_TRUE(are_same_plane(one, one.half_spaces.at(0), two, two.half_spaces.at(0)));
    EXPECT_NE(one.half_spaces[0].complement, two.half_spaces[0].complement);
  }
}

}  // namespace
}  // namespace halfspace
