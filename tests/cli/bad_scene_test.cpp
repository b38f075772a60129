// bad_scene_test.cpp - scenes that must be refused: by which exit status, where, and with which remedy.
#include <random>

#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

struct BadScene {
  const char* name;
  std::string text;
  int status;
  std::vector<std::string> said;
};
void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.text; }

const std::string in_definition = "definition d; " + ball + "enddef;\n";

std::vector<BadScene> bad_scenes() {
  return {
      {"SeveralSyntaxErrors",
       "plane <1 2>;\nbody b (;\nlight .5;\nwhat now;\n" + view_and_light,
       1,
       {"s.uq:1:11: error: ", "s.uq:2:9: error: ", "s.uq:4:1: error: "}},
      {"UnknownIds",
       "body b (p !r);\ninstance i (x);\n" + view_and_light,
       1,
       {"s.uq:1:9: error: ", "'p'", "s.uq:1:12: error: ", "'r'", "s.uq:2:13: error: ", "'x'", "define it"}},
      {"DuplicateIds", ball + ball + view_and_light, 1, {"s.uq:2:9: error: ", "'q'", "s.uq:2:40: error: ", "'b'"}},
      {"BodyWithoutHalfSpace", "body b ();\n" + view_and_light, 1, {"s.uq:1:1: error: ", "name at least one plane"}},
      {"ZeroPlane", "plane p <0 0 0 1>;\n" + view_and_light, 1, {"s.uq:1:1: error: ", "must not be 0"}},
      {"ZeroQuadric", "quadric q <0 0 0 0 0 0 0 0 0 1>;\n" + view_and_light, 1, {"s.uq:1:1: error: ", "must not be 0"}},
      {"NotANumber",
       "quadric q <nan 1 1 0 0 0 0 0 0 -9>;\n" + view_and_light,
       1,
       {"s.uq:1:12: error: ", "'nan'", "finite decimal"}},
      {"InfiniteNumber", "plane p <1 0 0 1e309>;\n" + view_and_light, 1, {"s.uq:1:16: error: ", "1e308"}},
      {"SingularInstance",
       in_definition + "instance i (d =sx 0);\n" + view_and_light,
       1,
       {"s.uq:3:19: error: ", "other than 0"}},
      {"SingularArray",
       in_definition + "array i (d) 3 =sa 0;\n" + view_and_light,
       1,
       {"s.uq:3:19: error: ", "other than 0"}},
      {"RecursiveDefinition",
       "definition d; instance i (e); enddef;\ndefinition e; instance i (d); enddef;\n",
       1,
       {"s.uq:2:27: error: ", "'d' draws 'e' draws 'd'", "remove one"}},
      {"ParallelUp",
       ball + "light l .3; view v dop 0 0 -1 vup 0 0 1;",
       1,
       {"s.uq:2:31: error: ", "vup", "vpn", "turn"}},
      {"NoCopies",
       in_definition + "array i (d) 0; array j (d) -1; array k (d) 1.5;\n" + view_and_light,
       1,
       {"s.uq:3:13: error: ", "s.uq:3:28: error: ", "s.uq:3:44: error: ", "whole number from 1"}},
      {"TooManyCopies",
       in_definition + "array i (d) 99999999999999999999 =tx 1;\n" + view_and_light,
       4,
       {"s.uq:3:13: error: ", "at most 1000000"}},
      {"TooManyNestedCopies",
       in_definition + "definition e; array i (d) 1000 =tx 1; enddef;\n" +
           "definition f; array i (e) 1000 =ty 1; enddef;\narray i (f) 1000 =tz 1;\n" + view_and_light,
       4,
       {"s.uq:4:15: error: ", "more than 100000 bodies", "place fewer"}},
      {"UnboundedPicture",
       "plane p <0 1 0 0>; body b (p);\nlight l .3; view v dop 0 0 -1;",
       1,
       {"s.uq:1:20: error: ", "'b'", "bound it", "whw and whh"}},
      {"EndOfTheEarth",
       ball + "light l .3; view v cop 0 0 -1e308 whw 1 whh 1;\n",
       4,
       {"s.uq:1:1: error: ", "'q'", "closer together"}},
      {"OpenComment", "{ { }", 1, {"s.uq:1:1: error: "}},
  };
}

class BadSceneTest : public CommandLine, public ::testing::WithParamInterface<BadScene> {};

TEST_P(BadSceneTest, IsRefusedAtItsPlace) {
  const BadScene& scene = GetParam();
  write("s.uq", scene.text);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", "s.uq", "-d", "gray", "--size", "64x64", "-o", "out.png"},
        std::vector<std::string>{"info", "s.uq", "-d", "gray", "--size", "64x64"}}) {
    const Outcome outcome = halfspace(command);
    expect_refusal(outcome, scene.status, scene.said, {"s.uq"});
    EXPECT_LT(outcome.peak_kilobytes, 1'000'000);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BadSceneTest, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& table) { return std::string(table.param.name); });

// Numbers at the ends of their range where a scene may have them: drawn, or refused with a place; never a hang.
struct Extreme {
  const char* name;
  std::string text;
};
void PrintTo(const Extreme& extreme, std::ostream* out) { *out << extreme.text; }

class ExtremeNumbers : public CommandLine, public ::testing::WithParamInterface<Extreme> {};

TEST_P(ExtremeNumbers, AreDrawnOrRefused) {
  write("s.uq", GetParam().text);
  const Outcome outcome = halfspace({"render", "s.uq", "-d", "gray", "--size", "64x64", "-o", "out.pgm"});
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_TRUE(outcome.status == 0 || outcome.status == 1 || outcome.status == 4) << outcome.status << outcome.err;
  EXPECT_EQ(std::filesystem::exists(folder_ / "out.pgm"), outcome.status == 0);
  EXPECT_TRUE(outcome.status == 0 || outcome.err.find("s.uq:") != std::string::npos) << outcome.err;
  EXPECT_LT(outcome.seconds, 30);
}

std::vector<Extreme> extremes() {
  const std::string perspective = "light l .3; light s .7 0 0 -1; view v cop 0 0 -10 whw 4 whh 4";
  const auto quadric = [](const char* coefficients) {
    return std::string("quadric q <") + coefficients + ">; body b (q);\n";
  };
  return {
      {"HugeBall", quadric("1e308 1e308 1e308 0 0 0 0 0 0 -1") + view_and_light},
      {"HugeRadius", quadric("1 1 1 0 0 0 0 0 0 -1e308") + view_and_light},
      {"HugeRadiusInPerspective", quadric("1 1 1 0 0 0 0 0 0 -1e308") + perspective + ";"},
      {"TinyBall", quadric("1e308 1e308 1e308 0 0 0 0 0 0 -1e-308") + view_and_light},
      {"Mixed", quadric("1e308 1e-308 1 -1e308 1e-308 1 1e308 1e-308 -1 -1e308") + view_and_light},
      {"MixedInPerspective", quadric("1e308 1e-308 1 -1e308 1e-308 1 1e308 1e-308 -1 -1e308") + perspective + ";"},
      {"Planes",
       "plane p <1e308 1e-308 1 -1e308>; plane r <1e-308 0 0 -1e-308>; quadric q <1 1 1 0 0 0 0 0 0 -1>;"
       "body b (p r q);" +
           view_and_light},
      {"Scales", in_definition + "instance i (d =sx 1e308 =sy 1e-308 =tz 1e308);" + view_and_light},
      {"Shears", in_definition + "instance i (d =vxy 1e308 =vyx 1e308 =vzx -1e308 =rx 1e308);" + view_and_light},
      {"PowersOfScales", in_definition + "array i (d) 100 =sx 1e308 =ry 1e300;" + view_and_light},
      {"PowersOfSmallScales", in_definition + "array i (d) 100 =sa 1e-308;" + view_and_light},
      {"Light", ball + "light l 1e308; light s -1e308 1e308 -1e-308 1; view v dop 0 0 -1 whw 4 whh 4;"},
      {"Direction", ball + "light l .3; view v dop 1e308 1e-308 -1 vup 1e-308 1e308 1 whw 4 whh 4;"},
      {"HugeWindow", ball + "light l .3; view v dop 0 0 -1 whw 1e308 whh 1e-308;"},
      {"TinyWindow", ball + "light l .3; view v dop 0 0 -1 whw 1e-308 whh 1e-308;"},
      {"FarReference", ball + "light l .3; view v vrp 1e308 -1e308 1e308 dop 0 0 -1 whw 4 whh 4;"},
      {"FarReferenceFitted", ball + "light l .3; view v vrp 1e308 -1e308 1e308 dop 0 0 -1;"},
      {"NearEye", ball + "light l .3; view v cop 0 0 -1e-308 whw 1 whh 1;"},
      {"Clipping", ball + "light l .3; view v dop 0 0 -1 fbp -1e308 1e308;"},
      {"ThinClipping", ball + perspective + " fbp 0 1e-308;"},
  };
}

INSTANTIATE_TEST_SUITE_P(Table, ExtremeNumbers, ::testing::ValuesIn(extremes()),
                         [](const auto& table) { return std::string(table.param.name); });

class RandomBytes : public CommandLine {
 protected:
  static std::string three_megabytes() {
    std::mt19937_64 random(2);
    std::string text(3U << 20U, '\0');
    for (char& byte : text) byte = static_cast<char>(random());
    return text;
  }
};

TEST_F(RandomBytes, AreRefusedAsAScene) {
  write("s.uq", three_megabytes());
  expect_refusal(halfspace({"render", "s.uq", "-o", "out.png"}), 1, {"s.uq:1:", "error: "}, {"s.uq"});
}

TEST_F(RandomBytes, AreRefusedWithoutAKnownEnding) {
  write("noise", three_megabytes());
  expect_refusal(halfspace({"render", "noise", "-o", "out.png"}), 2, {"noise", "--language uq"}, {"noise"});
}

TEST_F(RandomBytes, AreRefusedFromStandardInput) {
  const Outcome outcome =
      run({.arguments = {"render", "-", "-o", "out.png"}, .input = three_megabytes(), .folder = folder_ / "."});
  expect_refusal(outcome, 1, {"<standard input>:1:"}, {});
}

TEST_F(CommandLine, AnEmptySceneIsAnEmptyPageWithAWarning) {
  write("s.uq", "");
  const Outcome outcome = halfspace({"render", "s.uq", "-d", "gray", "--size", "8x8", "-o", "out.pgm"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("nothing to draw"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace halfspace::testing
