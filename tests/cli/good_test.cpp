// good_test.cpp - what the program must do when all is well.
#include <map>

#include "drivers/device_table.hpp"
#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Arguments = std::vector<std::string>;
using Bytes = std::vector<std::uint8_t>;

class Good : public CommandLine {
 protected:
  // The bytes that `halfspace render tube.uq MORE -o name` leaves.
  Bytes draw(const std::string& name, const Arguments& more) const {
    Arguments all{"render", tube, "-o", name};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = halfspace(all);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
    const Bytes bytes = folder_.read(name);
    std::filesystem::remove(folder_ / name);
    return bytes;
  }
};

bool starts_with(const Bytes& bytes, const std::string& start) {
  return bytes.size() >= start.size() &&
         std::equal(start.begin(), start.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

TEST_F(Good, EveryDeviceDrawsEveryKindOfOutput) {
  const std::map<std::string, std::string> magic{{".png", "\x89PNG"}, {".tif", "II"},      {".pgm", "P5"},
                                                 {".pbm", "P4"},      {".exr", "v/1\x01"}, {".prn", ""}};
  for (const KnownDevice& device : known_devices) {
    const std::string name(device.traits.name);
    for (const auto& [ending, start] : magic) {
      if (ending == ".pbm" && device.traits.format == DotFormat::gray) continue;
      const Bytes bytes = draw("out" + ending, {"-d", name, "--size", "64x48"});
      EXPECT_FALSE(bytes.empty()) << name << ending;
      EXPECT_TRUE(starts_with(bytes, start)) << name << ending;
    }
  }
  EXPECT_EQ(folder_.names(), Arguments{});
}

TEST_F(Good, StandardOutputHasTheDevicesBytes) {
  for (const KnownDevice& device : known_devices) {
    const std::string name(device.traits.name);
    const Bytes file = draw("out.prn", {"-d", name, "--size", "64x48"});
    const Outcome outcome = halfspace({"render", tube, "-d", name, "--size", "64x48", "-o", "-"});
    EXPECT_EQ(outcome.out, std::string(file.begin(), file.end())) << name;
  }
}

TEST_F(Good, DevicesForTheTerminalNeedNoOutputName) {
  for (const char* device : {"ascii", "braille"}) {
    const Outcome outcome = halfspace({"render", tube, "-d", device, "--size", "64x48"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_FALSE(outcome.out.empty()) << device;
  }
}

TEST_F(Good, SynonymsNameTheSameDevice) {
  EXPECT_EQ(draw("a.prn", {"-d", "varian", "--size", "64x48"}), draw("a.prn", {"-d", "va", "--size", "64x48"}));
}

TEST_F(Good, TheSameSceneGivesTheSameBytes) {
  for (const char* ending : {".png", ".tif", ".prn"}) {
    const std::string name = std::string("a") + ending;
    EXPECT_EQ(draw(name, {"--size", "200x150"}), draw(name, {"--size", "200x150"}));
  }
}

TEST_F(Good, BothShadersGiveTheSameBytes) {
  EXPECT_EQ(draw("a.pgm", {"-d", "gray", "--size", "200x150", "--shader", "isqrt"}),
            draw("a.pgm", {"-d", "gray", "--size", "200x150", "--shader", "jordan"}));
}

TEST_F(Good, BackgroundIsTheCornersColour) {
  const auto corner = [&](const Arguments& more) {
    Arguments all{"-d", "gray", "--size", "64x48"};
    all.insert(all.end(), more.begin(), more.end());
    return draw("a.pgm", all).back();
  };
  EXPECT_EQ(corner({"--background", "white"}), 255);
  EXPECT_EQ(corner({"--background", "black"}), 0);
  EXPECT_EQ(corner({}), 0);
}

TEST_F(Good, LevelsBoundWhatAGrayPictureHolds) {
  const Bytes two = draw("a.pgm", {"-d", "gray", "--size", "64x48", "--levels", "2"});
  const std::size_t header = two.size() - std::size_t{64} * 48;
  for (std::size_t i = header; i < two.size(); ++i) ASSERT_TRUE(two[i] == 0 || two[i] == 255) << i;
}

TEST_F(Good, ScreensDiffer) {
  const Bytes clustered = draw("a.prn", {"--size", "200x150"});
  EXPECT_NE(clustered, draw("a.prn", {"--size", "200x150", "--screen", "bayer"}));
  EXPECT_NE(clustered, draw("a.prn", {"--size", "200x150", "--screen", "blue-noise"}));
}

TEST_F(Good, SceneFromStandardInput) {
  std::ifstream file(tube);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Outcome outcome =
      run({.arguments = {"render", "-", "--size", "64x48", "-o", "a.prn"}, .input = text, .folder = folder_ / "."});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder_.read("a.prn"), draw("b.prn", {"--size", "64x48"}));
}

TEST_F(Good, SeveralFilesMakeOneScene) {
  write("model.uq", ball);
  write("view.uq", view_and_light);
  write("both.uq", ball + view_and_light);
  ASSERT_EQ(halfspace({"render", "model.uq", "view.uq", "--size", "64x48", "-o", "a.prn"}).status, 0);
  ASSERT_EQ(halfspace({"render", "both.uq", "--size", "64x48", "-o", "b.prn"}).status, 0);
  EXPECT_EQ(folder_.read("a.prn"), folder_.read("b.prn"));
}

TEST_F(Good, ViewSelects) {
  write("s.uq", ball + "light l .5; view near dop 0 0 -1 whw 4 whh 4; view far dop 0 0 -1 whw 40 whh 40;");
  const auto dots = [&](const Arguments& more) {
    Arguments all{"render", "s.uq", "--size", "64x48", "-o", "a.prn"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = halfspace(all);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return folder_.read("a.prn");
  };
  EXPECT_EQ(dots({}), dots({"--view", "far"}));
  EXPECT_NE(dots({}), dots({"--view", "near"}));
}

TEST_F(Good, QuietSilencesWarningsAlone) {
  write("warned.uq", ball + "light 2; view v dop 0 0 -1;");
  write("wrong.uq", "body b (x);");
  const Arguments tail{"--size", "64x48", "-o", "a.prn"};
  EXPECT_NE(halfspace({"render", "warned.uq", "--size", "64x48", "-o", "a.prn"}).err.find("warning: "),
            std::string::npos);
  EXPECT_EQ(halfspace({"render", "warned.uq", "--size", "64x48", "-o", "a.prn", "--quiet"}).err, "");
  EXPECT_NE(halfspace({"render", "wrong.uq", "--size", "64x48", "-o", "a.prn", "--quiet"}).err, "");
}

TEST_F(Good, StatisticsGoWhereThePictureDoesNot) {
  const Outcome to_file = halfspace({"render", tube, "--size", "64x48", "-o", "a.prn", "--stats"});
  EXPECT_NE(to_file.out.find("shaded dots"), std::string::npos);
  EXPECT_EQ(to_file.err, "");
  const Outcome to_output = halfspace({"render", tube, "--size", "64x48", "-o", "-", "--stats"});
  EXPECT_NE(to_output.err.find("shaded dots"), std::string::npos);
  const Bytes file = folder_.read("a.prn");
  EXPECT_EQ(to_output.out, std::string(file.begin(), file.end()));
}

TEST_F(Good, StatisticsAreValidJson) {
  draw("a.prn", {"--size", "64x48", "--stats-json", "s.json"});
  EXPECT_EQ(std::system(("python3 -m json.tool " + folder_ / "s.json" + " >/dev/null").c_str()), 0);
  const Bytes bytes = folder_.read("s.json");
  const std::string json(bytes.begin(), bytes.end());
  for (const char* key : {"\"bodies\"", "\"dots\"", "\"core_bytes\"", "\"total\""}) {
    EXPECT_NE(json.find(key), std::string::npos) << key;
  }
}

TEST_F(Good, InfoNamesBoundAndNeeds) {
  const Outcome outcome = halfspace({"info", tube, "--size", "64x48"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* word : {"silhouette bound", "RAM of the core", "needs at once", "64 x 48 dots"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

const Arguments work{
    "render", HALFSPACE_SOURCE_DIR "/scenes/stack_of_bundles.uq", "-d", "gray", "--size", "900x900", "-o", "a.prn"};

TEST_F(Good, WorkTellsATerminalHowFarItIs) {
  const Outcome outcome = run({.arguments = work, .folder = folder_ / ".", .on_terminal = true});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find(" of 900,"), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("\r\x1b[K")) << "the line must be wiped";
}

TEST_F(Good, WorkIsSilentInAPipeOrWhenAskedToBe) {
  EXPECT_EQ(halfspace(work).err, "");
  Arguments quiet = work;
  quiet.emplace_back("--quiet");
  EXPECT_EQ(run({.arguments = quiet, .folder = folder_ / ".", .on_terminal = true}).err, "");
}

TEST_F(Good, TheWidestAndTheTallestPageAreDrawn) {
  for (const char* size : {"32767x16", "16x32767"}) {
    const Bytes page = draw("a.pbm", {"-d", "pwg", "--size", size, "--background", "black"});
    const std::size_t bytes = size == std::string("32767x16") ? std::size_t{4096} * 16 : std::size_t{2} * 32767;
    ASSERT_EQ(page.size(), std::string("P4\n32767 16\n").size() + bytes) << size;
  }
}

}  // namespace
}  // namespace halfspace::testing
