// bad_file_test.cpp - files that cannot be read or written: named with the reason, and nothing half-written stays.
#include <sys/stat.h>

#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Arguments = std::vector<std::string>;

class Files : public CommandLine {
 protected:
  [[nodiscard]] Outcome draw_to(const std::string& path, const Arguments& more = {}) const {
    Arguments all{"render", tube, "-d", "gray", "--size", "64x64", "-o", path};
    all.insert(all.end(), more.begin(), more.end());
    return run({.arguments = all, .folder = folder_ / ".", .obeys_permissions = true});
  }
};

TEST_F(Files, MissingScene) {
  expect_refusal(halfspace({"render", "none.uq", "-o", "out.png"}), 3, {"none.uq: error: ", "No such file"}, {});
}

TEST_F(Files, OneOfSeveralScenesMissing) {
  expect_refusal(halfspace({"render", tube, "none.uq", "-o", "out.png"}), 3, {"none.uq: error: "}, {});
}

TEST_F(Files, FolderAsScene) {
  std::filesystem::create_directory(folder_ / "a.uq");
  expect_refusal(halfspace({"render", "a.uq", "-o", "out.png"}), 3, {"a.uq: error: is a folder", "name a scene file"},
                 {"a.uq"});
}

TEST_F(Files, SceneWithoutPermission) {
  write("s.uq", ball);
  ASSERT_EQ(::chmod((folder_ / "s.uq").c_str(), 0), 0);
  const Outcome outcome =
      run({.arguments = {"render", "s.uq", "-o", "out.png"}, .folder = folder_ / ".", .obeys_permissions = true});
  expect_refusal(outcome, 3, {"s.uq: error: ", "Permission denied", "check"}, {"s.uq"});
}

TEST_F(Files, SceneThatFailsWhileRead) {
  expect_refusal(halfspace({"render", "/proc/self/mem", "--language", "uq", "-o", "out.png"}), 3,
                 {"/proc/self/mem: error: "}, {});
}

TEST_F(Files, UnwritableFolder) {
  std::filesystem::create_directory(folder_ / "closed");
  ASSERT_EQ(::chmod((folder_ / "closed").c_str(), 0555), 0);
  expect_refusal(draw_to("closed/out.png"), 3, {"closed/out.png", "Permission denied", "check the permissions"},
                 {"closed"});
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "closed"));
}

TEST_F(Files, MissingFolder) {
  expect_refusal(draw_to("none/out.png"), 3, {"none/out.png", "create the folder first"}, {});
}

TEST_F(Files, FolderAsPicture) {
  std::filesystem::create_directory(folder_ / "out.png");
  expect_refusal(draw_to("out.png"), 3, {"out.png", "name a file in it"}, {"out.png"});
}

TEST_F(Files, ProtectedPictureKeepsItsBytes) {
  write("out.png", "precious");
  ASSERT_EQ(::chmod((folder_ / "out.png").c_str(), 0444), 0);
  expect_refusal(draw_to("out.png"), 3, {"out.png", "check the permissions"}, {"out.png"});
  EXPECT_EQ(folder_.read("out.png").size(), 8U);
}

TEST_F(Files, WrongSceneKeepsAnOlderPicture) {
  write("out.png", "precious");
  write("s.uq", "body b (nothing);");
  expect_refusal(halfspace({"render", "s.uq", "-o", "out.png"}), 1, {"s.uq:1:9: error: "}, {"out.png", "s.uq"});
  EXPECT_EQ(folder_.read("out.png").size(), 8U);
}

TEST_F(Files, FullDisk) {
  expect_refusal(draw_to("/dev/full"), 3, {"/dev/full", "No space left", "free some space"}, {});
  const Outcome outcome = run({.arguments = {"render", tube, "-d", "gray", "--size", "64x64", "-o", "-"},
                               .folder = folder_ / ".",
                               .output_path = "/dev/full"});
  expect_refusal(outcome, 3, {"standard output", "No space left"}, {});
}

TEST_F(Files, StatisticsThatCannotBeWritten) {
  EXPECT_EQ(draw_to("out.png", {"--stats-json", "none/s.json"}).status, 3);
  EXPECT_EQ(draw_to("-", {"--stats-json", "/dev/full"}).status, 3);
}

TEST_F(Files, StatisticsOnAFullStandardOutput) {
  const Outcome outcome = run({.arguments = {"render", tube, "--size", "64x64", "-o", "out.png", "--stats"},
                               .folder = folder_ / ".",
                               .output_path = "/dev/full"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << outcome.err;
}

TEST_F(Files, InformationOnAFullStandardOutput) {
  const Outcome outcome =
      run({.arguments = {"info", tube, "--size", "64x64"}, .folder = folder_ / ".", .output_path = "/dev/full"});
  expect_refusal(outcome, 3, {"standard output"}, {});
}

TEST_F(Files, ClosedPipeIsNoCrash) {
  for (const char* command : {"render", "info"}) {
    Arguments arguments{command, tube, "-d", "gray", "--size", "512x512"};
    if (command == std::string("render")) arguments.insert(arguments.end(), {"-o", "-"});
    const Outcome outcome = run({.arguments = arguments, .folder = folder_ / ".", .closed_output = true});
    expect_refusal(outcome, 3, {"standard output"}, {});
  }
}

}  // namespace
}  // namespace halfspace::testing
