// job_test.cpp - a job kept in a file draws what render draws.
#include <algorithm>

#include "drivers/device_table.hpp"
#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Arguments = std::vector<std::string>;
using Bytes = std::vector<std::uint8_t>;

Arguments operator+(Arguments left, const Arguments& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

class Jobs : public CommandLine {
 protected:
  // The bytes that the command leaves under `name`; it says nothing.
  Bytes left_by(const Arguments& command, const std::string& name) const {
    const Outcome outcome = halfspace(command + Arguments{"-o", name});
    EXPECT_EQ(outcome.status, 0) << ::testing::PrintToString(command) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
    return folder_.read(name);
  }

  // Compiled and run, against rendered.
  void expect_same_picture(const std::string& scene, const std::string& device, const Arguments& page,
                           const std::string& output, const Arguments& drawing = {}) const {
    const Arguments on_device{"-d", device};
    left_by(Arguments{"compile", scene} + on_device + page, "a.hsj");
    const Bytes ran = left_by(Arguments{"run", "a.hsj"} + on_device + drawing, "ran" + output);
    EXPECT_FALSE(ran.empty());
    EXPECT_TRUE(ran == left_by(Arguments{"render", scene} + on_device + page + drawing, "rendered" + output))
        << scene << " on " << device;
  }
};

std::vector<std::string> gallery() {
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(HALFSPACE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".uq") scenes.push_back(entry.path().string());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

class GalleryJobs : public Jobs, public ::testing::WithParamInterface<std::string> {};

TEST_P(GalleryJobs, DrawWhatRenderDraws) {
  expect_same_picture(GetParam(), "varian", {"--size", "150x97"}, ".prn");
  expect_same_picture(GetParam(), "gray", {"--size", "67x131"}, ".pgm");
}

INSTANTIATE_TEST_SUITE_P(Scenes, GalleryJobs, ::testing::ValuesIn(gallery()),
                         [](const auto& scene) { return std::filesystem::path(scene.param).stem().string(); });

TEST_F(Jobs, EveryDeviceDrawsThem) {
  for (const KnownDevice& device : known_devices) {
    expect_same_picture(tube, std::string(device.traits.name), {"--size", "64x48"}, ".prn");
  }
}

TEST_F(Jobs, KeepWhatIsSaidOfThePage) {
  const Arguments size{"--size", "150x97"};
  expect_same_picture(tube, "varian", size + Arguments{"--levels", "17", "--background", "black"}, ".prn");
  expect_same_picture(tube, "varian", size + Arguments{"--screen", "blue-noise"}, ".prn");
  expect_same_picture(write("s.uq", ball + "light l .5; view near dop 0 0 -1 whw 4 whh 4; view far dop 0 0 -1;"),
                      "gray", size + Arguments{"--view", "near"}, ".pgm");
}

TEST_F(Jobs, TakeEitherShaderAndAnotherDensityWhenRun) {
  const Arguments size{"--size", "150x97"};
  expect_same_picture(tube, "gray", size, ".pgm", {"--shader", "jordan"});
  expect_same_picture(tube, "varian", size, ".png", {"--dpi", "300"});
  EXPECT_NE(left_by({"run", "a.hsj", "--dpi", "300"}, "300.png"), left_by({"run", "a.hsj", "--dpi", "100"}, "100.png"));
}

TEST_F(Jobs, HoldNoDensityAndCompileSaysSo) {
  const Outcome outcome = halfspace({"compile", tube, "--size", "64x48", "--dpi", "300", "-o", "a.hsj"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("warning: --dpi 300"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder_.read("a.hsj"), left_by({"compile", tube, "--size", "64x48"}, "b.hsj"));
}

TEST_F(Jobs, AreAskedWithoutWordsAboutTheirPage) {
  left_by({"compile", tube, "--size", "64x48"}, "a.hsj");
  for (const Arguments& words :
       {Arguments{"-d", "varian"}, {"--dpi", "300"}, {"--screen", "clustered"}, {"--levels", "65"}}) {
    const Outcome outcome = halfspace(Arguments{"info", "a.hsj"} + words);
    EXPECT_EQ(outcome.status, 2) << words.front();
    EXPECT_NE(outcome.err.find("a job's page is settled; leave it out"), std::string::npos) << outcome.err;
  }
}

TEST_F(Jobs, TellOfWhatMakesNoDifference) {
  const auto said = [this](const Arguments& command) {
    const Outcome outcome = halfspace(command);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const Arguments gray{"-d", "gray", "--size", "64x48"};
  const Arguments varian{"-d", "varian", "--size", "64x48"};
  const std::string screen = "warning: --screen bayer";
  const std::string density = "warning: --dpi 300";
  EXPECT_EQ(said(Arguments{"render", tube, "--screen", "bayer", "-o", "a.png"} + gray).find(screen), 0U);
  EXPECT_EQ(said(Arguments{"compile", tube, "--screen", "bayer", "-o", "g.hsj"} + gray).find(screen), 0U);
  EXPECT_EQ(said(Arguments{"render", tube, "--dpi", "300", "-o", "a.pbm"} + varian).find(density), 0U);
  left_by(Arguments{"compile", tube} + varian, "a.hsj");
  EXPECT_EQ(said({"run", "a.hsj", "--dpi", "300", "-o", "a.prn"}).find(density), 0U);
  EXPECT_EQ(said({"run", "a.hsj", "--dpi", "300", "-o", "a.prn", "--quiet"}), "");
  EXPECT_EQ(said({"run", "a.hsj", "--dpi", "300", "-o", "a.tif"}), "");
  EXPECT_EQ(said({"run", "a.hsj", "-d", "pwg", "--dpi", "300", "-o", "a.prn"}), "");
  EXPECT_EQ(said(Arguments{"render", tube, "--screen", "bayer", "-o", "a.png"} + varian), "");
}

TEST_F(Jobs, RunOnAnyDeviceThatTakesTheirPage) {
  left_by({"compile", tube, "-d", "varian", "--size", "64x48"}, "a.hsj");
  const Bytes picture = left_by({"run", "a.hsj", "-d", "varian"}, "a.pbm");
  for (const char* device : {"versatec", "pwg", "ssd1306"}) {
    EXPECT_EQ(left_by({"run", "a.hsj", "-d", device}, "b.pbm"), picture) << device;
  }
}

TEST_F(Jobs, AreRefusedByADeviceOfAnotherKind) {
  left_by({"compile", tube, "-d", "varian", "--size", "640x480"}, "bilevel.hsj");
  left_by({"compile", tube, "-d", "gray", "--size", "64x48"}, "gray.hsj");
  const Arguments before = folder_.names();
  expect_refusal(halfspace({"run", "bilevel.hsj", "-d", "gray", "-o", "out.png"}), 2,
                 {"bilevel.hsj: error: ", "bilevel page of 640 x 480", "gray takes gray pages", "versatec"}, before);
  expect_refusal(halfspace({"run", "gray.hsj", "-d", "varian", "-o", "out.png"}), 2,
                 {"gray.hsj: error: ", "gray page of 64 x 48", "varian takes bilevel pages", "ascii"}, before);
  expect_refusal(halfspace({"run", "bilevel.hsj", "-d", "ssd1306", "-o", "out.png"}), 4,
                 {"bilevel.hsj: error: ", "640 x 480", "ssd1306", "128 x 64", "versatec"}, before);
}

TEST_F(Jobs, GoThroughPipes) {
  const Arguments page{"--size", "64x48"};
  const Outcome compiled = halfspace(Arguments{"compile", tube, "-o", "-"} + page);
  EXPECT_EQ(compiled.status, 0) << compiled.err;
  const Outcome ran = run({.arguments = {"run", "-", "-o", "-"}, .input = compiled.out, .folder = folder_ / "."});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, halfspace(Arguments{"render", tube, "-o", "-"} + page).out);
}

TEST_F(Jobs, AreTheSameBytesEachTime) {
  const Arguments command{"compile", HALFSPACE_SOURCE_DIR "/scenes/crossing.uq", "--size", "150x97"};
  EXPECT_EQ(left_by(command, "a.hsj"), left_by(command, "b.hsj"));
}

TEST_F(Jobs, AWrongSceneLeavesNone) {
  write("s.uq", "body b (nothing);");
  expect_refusal(halfspace({"compile", "s.uq", "-o", "a.hsj"}), 1, {"s.uq:1:9: error: "}, {"s.uq"});
  expect_refusal(halfspace({"compile", "s.uq", "-o", "-"}), 1, {"s.uq:1:9: error: "}, {"s.uq"});
}

TEST_F(Jobs, CannotBeWrittenEverywhere) {
  const Arguments command{"compile", tube, "--size", "64x48", "-o"};
  expect_refusal(halfspace(command + Arguments{"none/a.hsj"}), 3, {"none/a.hsj", "create the folder first"}, {});
  expect_refusal(halfspace(command + Arguments{"/dev/full"}), 3, {"/dev/full", "No space left"}, {});
}

TEST_F(Jobs, InfoSaysWhatTheHeaderSays) {
  left_by({"compile", tube, "--size", "64x48", "--levels", "17", "--screen", "bayer"}, "a.hsj");
  const Outcome job = halfspace({"info", "a.hsj"});
  EXPECT_EQ(job.status, 0) << job.err;
  EXPECT_EQ(job.err, "");
  for (const char* words : {"64 x 48 dots, bilevel, 17 levels, background 16", "bayer", "versatec", "silhouette bound",
                            "needs at once", "single lines", "bands of 32 lines", "exact arithmetic"}) {
    EXPECT_NE(job.out.find(words), std::string::npos) << words << "\nin\n" << job.out;
  }
  EXPECT_EQ(job.out.find("bands of 64 lines"), std::string::npos) << "the page has 48";
  std::filesystem::rename(folder_ / "a.hsj", folder_ / "job");
  EXPECT_EQ(halfspace({"info", "job"}).out, job.out) << "known by its first bytes";
}

TEST_F(Jobs, InfoAgreesWithItsScenes) {
  left_by({"compile", tube, "--size", "64x48"}, "a.hsj");
  const std::string of_scene = halfspace({"info", tube, "--size", "64x48"}).out;
  const std::string of_job = halfspace({"info", "a.hsj"}).out;
  for (const char* start : {"needs at once", "job ", "window"}) {
    const std::size_t at = of_scene.find(start);
    ASSERT_NE(at, std::string::npos) << start;
    const std::string line = of_scene.substr(at, of_scene.find('\n', at) + 1 - at);
    EXPECT_NE(of_job.find(line), std::string::npos) << line << "in\n" << of_job;
  }
}

TEST_F(Jobs, StatisticsOfARunAreThoseOfTheDrawing) {
  left_by({"compile", tube, "--size", "64x48"}, "a.hsj");
  const Outcome table = halfspace({"run", "a.hsj", "-o", "a.prn", "--stats", "--stats-json", "s.json"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("shaded dots"), std::string::npos);
  EXPECT_EQ(table.out.find("bodies"), std::string::npos) << "a job does not know its bodies";
  EXPECT_EQ(std::system(("python3 -m json.tool " + folder_ / "s.json" + " >/dev/null").c_str()), 0);
  const std::string size = "\"job_bytes\": " + std::to_string(folder_.read("a.hsj").size());
  const Bytes bytes = folder_.read("s.json");
  const std::string json(bytes.begin(), bytes.end());
  for (const std::string& word : {size, std::string("\"bound_dots\""), std::string("\"draw_ns_per_dot\"")}) {
    EXPECT_NE(json.find(word), std::string::npos) << word;
  }
  const Outcome to_output = halfspace({"run", "a.hsj", "-o", "-", "--stats"});
  EXPECT_NE(to_output.err.find("shaded dots"), std::string::npos);
  EXPECT_EQ(to_output.out.size(), folder_.read("a.prn").size());
}

TEST_F(Jobs, RunsTellATerminalHowFarTheyAre) {
  const std::string scene = HALFSPACE_SOURCE_DIR "/scenes/stack_of_bundles.uq";
  const Outcome compiled = run({.arguments = {"compile", scene, "-d", "gray", "--size", "900x900", "-o", "a.hsj"},
                                .folder = folder_ / ".",
                                .on_terminal = true});
  EXPECT_NE(compiled.err.find("resolving"), std::string::npos) << compiled.err;
  EXPECT_TRUE(compiled.err.ends_with("\r\x1b[K")) << "the line must be wiped";
  const Arguments command{"run", "a.hsj", "-d", "gray", "-o", "a.prn"};
  const Outcome ran = run({.arguments = command, .folder = folder_ / ".", .on_terminal = true});
  EXPECT_NE(ran.err.find(" of 900,"), std::string::npos) << ran.err;
  EXPECT_TRUE(ran.err.ends_with("\r\x1b[K")) << "the line must be wiped";
  EXPECT_EQ(run({.arguments = command + Arguments{"--quiet"}, .folder = folder_ / ".", .on_terminal = true}).err, "");
}

}  // namespace
}  // namespace halfspace::testing
