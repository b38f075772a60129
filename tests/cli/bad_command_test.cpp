// bad_command_test.cpp - command lines that must be refused, and help that must be complete.
#include "drivers/device_table.hpp"
#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Arguments = std::vector<std::string>;

struct BadCommand {
  const char* name;
  Arguments arguments;
  int status;
  std::vector<std::string> said;
};
void PrintTo(const BadCommand& command, std::ostream* out) { *out << ::testing::PrintToString(command.arguments); }

Arguments draw(const Arguments& more) {
  Arguments all{"render", tube};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Arguments with_size(const char* size) { return draw({"-d", "gray", "--size", size, "-o", "out.png"}); }
Arguments with_levels(const char* levels) { return draw({"-d", "gray", "--levels", levels, "-o", "out.png"}); }
Arguments with_stride(const char* stride) { return draw({"--shader", "stride", "--stride", stride, "-o", "out.png"}); }

std::vector<BadCommand> bad_commands() {
  return {
      {"Nothing", {}, 2, {"no command", "render, compile, run, info or report"}},
      {"UnknownSubcommand", {"draw", tube}, 2, {"draw"}},
      {"UnknownOption", draw({"-o", "out.png", "--colour"}), 2, {"--colour"}},
      {"NoScene", {"render", "-o", "out.png"}, 2, {"scene"}},
      {"NoOutput", draw({"-d", "gray"}), 2, {"-o is missing"}},
      {"EmptyOutput", draw({"-d", "gray", "-o", ""}), 2, {"-o is missing"}},
      {"CompileWithoutOutput", {"compile", tube}, 2, {"-o is missing", ".hsj"}},
      {"CompileOntoItsScene", {"compile", tube, "-o", tube}, 2, {tube, "name another file"}},
      {"CompileForTooLargeAPage", {"compile", tube, "-d", "ssd1306", "--size", "129x64", "-o", "a.hsj"}, 4, {"128x64"}},
      {"CompileForAnUnknownDevice", {"compile", tube, "-d", "laser", "-o", "a.hsj"}, 2, {"laser", "varian"}},
      {"CompileWithAShader", {"compile", tube, "--shader", "jordan", "-o", "a.hsj"}, 2, {"--shader"}},
      {"RunWithoutJob", {"run", "-o", "out.png"}, 2, {"job"}},
      {"RunWithoutOutput", {"run", "a.hsj"}, 2, {"-o is missing"}},
      {"RunInAnotherSize", {"run", "a.hsj", "--size", "8x8", "-o", "out.png"}, 2, {"--size"}},
      {"RunOnAnUnknownDevice", {"run", "a.hsj", "-d", "laser", "-o", "out.png"}, 2, {"laser", "varian"}},
      {"RenderAJob", {"render", "a.hsj", "-o", "out.png"}, 2, {"a.hsj", "halfspace run"}},
      {"InfoOfAJobInAnotherSize", {"info", "a.hsj", "--size", "8x8"}, 2, {"a.hsj: error: --size", "settled"}},
      {"UnknownDevice", draw({"-d", "laser", "-o", "out.png"}), 2, {"laser", "varian", "versatec", "gray", "pwg"}},
      {"UnknownView", draw({"--view", "nowhere", "--size", "8x8", "-o", "out.png"}), 1, {"nowhere", "front"}},
      {"UnknownEnding", draw({"-o", "out.jpeg"}), 2, {"out.jpeg", ".png"}},
      {"NoEnding", draw({"-o", "out"}), 2, {"out", ".png"}},
      {"GrayInBitmap", draw({"-d", "gray", "-o", "out.pbm"}), 2, {".pbm", "use .pgm"}},
      {"UnknownShader",
       draw({"--shader", "ray", "-o", "out.png"}),
       2,
       {"--shader", "auto", "contour", "isqrt", "jordan", "stride"}},
      {"NoStride", with_stride("0"), 2, {"--stride", "1 to 32767"}},
      {"NegativeStride", with_stride("-8"), 2, {"--stride"}},
      {"StrideBeyondAPage", with_stride("32768"), 2, {"--stride", "1 to 32767"}},
      {"WordForStride", with_stride("far"), 2, {"--stride", "far"}},
      {"EmptyStride", with_stride(""), 2, {"--stride"}},
      {"StrideOfNoShader", draw({"--stride", "8", "-o", "out.png"}), 2, {"--stride", "--shader"}},
      {"StrideOfAnotherShader",
       draw({"--shader", "isqrt", "--stride", "8", "-o", "out.png"}),
       2,
       {"--stride", "isqrt", "--shader stride"}},
      {"StrideOfTheChoice", draw({"--stride", "8", "--shader", "auto", "-o", "out.png"}), 2, {"--stride", "auto"}},
      {"UnknownScreen", draw({"--screen", "dots", "-o", "out.png"}), 2, {"--screen", "bayer"}},
      {"UnknownBackground", draw({"--background", "red", "-o", "out.png"}), 2, {"--background", "black", "white"}},
      {"UnknownLanguage", draw({"--language", "c", "-o", "out.png"}), 2, {"--language", "uq"}},
      {"NoDpi", draw({"--dpi", "0", "-o", "out.png"}), 2, {"--dpi"}},
      {"NoDots", with_size("0x0"), 2, {"--size 0x0", "at least 1"}},
      {"NoWidth", with_size("0x5"), 2, {"--size 0x5", "at least 1"}},
      {"NegativeWidth", with_size("-1x5"), 2, {"-1x5"}},
      {"OneSide", with_size("5"), 2, {"--size 5", "WIDTHxHEIGHT"}},
      {"HalfASize", with_size("5x"), 2, {"--size 5x", "WIDTHxHEIGHT"}},
      {"EmptySize", with_size(""), 2, {"--size"}},
      {"SizeAndMore", with_size("5x5x5"), 2, {"--size 5x5x5", "WIDTHxHEIGHT"}},
      {"ManyDots", with_size("2147483648x2147483648"), 4, {"--size 2147483648x2147483648", "largest page", "32767"}},
      {"EvenMoreDots", with_size("99999999999999999999x1"), 4, {"largest page"}},
      {"DotsBeyondTheDevice", draw({"-d", "ssd1306", "--size", "129x64", "-o", "out.png"}), 4, {"128x64"}},
      {"OneLevel", with_levels("1"), 2, {"--levels", "2 to 256"}},
      {"ManyLevels", with_levels("257"), 2, {"--levels", "2 to 256"}},
      {"NoLevels", with_levels("0"), 2, {"--levels", "2 to 256"}},
      {"WordForLevels", with_levels("abc"), 2, {"--levels", "abc"}},
  };
}

class BadCommandTest : public CommandLine, public ::testing::WithParamInterface<BadCommand> {};

TEST_P(BadCommandTest, IsRefused) {
  expect_refusal(halfspace(GetParam().arguments), GetParam().status, GetParam().said, {});
}

INSTANTIATE_TEST_SUITE_P(Table, BadCommandTest, ::testing::ValuesIn(bad_commands()),
                         [](const auto& table) { return std::string(table.param.name); });

void expect_words(const Outcome& help, const Arguments& words) {
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const std::string& word : words) EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

const Arguments exit_statuses{
    "Exit status: 0 drawn; 1 the scene is wrong; 2 the command line is wrong; 3 a device or "
    "file failed;\n4 a stated limit is exceeded."};
const Arguments shared_options{"--device",     "-d",       "--size", "--dpi",      "--levels",
                               "--background", "--screen", "--view", "--language", "--quiet"};
const Arguments run_options{"--device", "-d", "--dpi", "--quiet"};

TEST_F(CommandLine, HelpNamesEveryOptionDeviceAndStatus) {
  expect_words(halfspace({"--help"}), {"render", "compile", "run", "info", "report", "--version"});
  expect_words(halfspace({"--help"}), exit_statuses);
  for (const char* command : {"render", "compile", "run", "info"}) {
    const Outcome help = halfspace({command, "--help"});
    expect_words(help, exit_statuses);
    expect_words(help, command == std::string("run") ? run_options : shared_options);
    for (const KnownDevice& device : known_devices) expect_words(help, {std::string(device.traits.name)});
  }
  for (const char* command : {"render", "run"}) {
    expect_words(halfspace({command, "--help"}), {"--output", "-o", "--shader", "--stats", "--stats-json"});
  }
  expect_words(halfspace({"compile", "--help"}), {"--output", "-o", ".hsj"});
  expect_words(halfspace({"report", "--help"}), {"--output", "-o", "--quick", "docs/report"});
}

TEST_F(CommandLine, VersionIsOneLine) { EXPECT_EQ(halfspace({"--version"}).out, "halfspace 0.1.0\n"); }

}  // namespace
}  // namespace halfspace::testing
