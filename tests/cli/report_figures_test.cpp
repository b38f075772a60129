// report_figures_test.cpp - `halfspace report --quick`: rows with figures, and exact shaders without a wrong dot.
//   Not in a build with the address sanitizer, where a report takes minutes and valgrind does not run at all.
#ifndef HALFSPACE_SANITIZED

#include <cstdlib>
#include <map>
#include <sstream>

#include "host/report/shader_list.hpp"
#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Line = std::map<std::string, std::string>;  // column, cell

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<Line> read_csv(const std::vector<std::uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> titles = split(line);
  std::vector<Line> lines;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line);
    EXPECT_EQ(cells.size(), titles.size()) << line;
    Line& last = lines.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), titles.size()); ++i) last[titles[i]] = cells[i];
  }
  return lines;
}

double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  EXPECT_TRUE(!text.empty() && *end == '\0') << text;
  return value;
}

class ReportFigures : public CommandLine {
 protected:
  [[nodiscard]] std::string text(const std::string& name) const {
    const auto bytes = folder_.read(name);
    return {bytes.begin(), bytes.end()};
  }
};

TEST_F(ReportFigures, QuickHasFiguresAndNoWrongDotWhereNoneIsPromised) {
  const Outcome outcome = halfspace({"report", "--quick", "-o", "new/report"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, int> rows, suites;
  for (const Line& line : read_csv(folder_.read("new/report/results.csv"))) {
    const std::string name = line.at("renderer") + " " + line.at("shader");
    ++rows[name];
    ++suites[line.at("suite")];
    EXPECT_GT(number(line.at("shaded_dots")), 0);
    EXPECT_GE(number(line.at("wrong_dots")), 0);
    if (line.at("renderer") != "Halfspace") continue;
    (void)number(line.at("ns_per_dot"));
    EXPECT_GT(number(line.at("instructions_per_dot")), 0);
    for (const ListedShader& shader : listed_shaders) {
      if (!shader.exact || line.at("shader") != shader.name) continue;
      EXPECT_EQ(line.at("wrong_dots"), "0") << name;
    }
  }
  for (const ListedShader& shader : listed_shaders) EXPECT_EQ(rows["Halfspace " + std::string(shader.name)], 12);
  EXPECT_EQ(rows["POV-Ray "], 2);
  EXPECT_EQ(rows["Raster3D "], 2);
  EXPECT_EQ(rows["Raster3D PNG "], 2);
  EXPECT_EQ(suites.size(), 4U);
  EXPECT_NE(text("new/report/README.md").find("| clover_knot | 64 x 51 | POV-Ray | contour |"), std::string::npos);
  EXPECT_NE(text("new/report/error.svg").find("</svg>"), std::string::npos);
  EXPECT_EQ(text("new/report/README.md").find("Left out"), std::string::npos) << outcome.err;
  EXPECT_NE(text("new/report/instructions.svg").find("</svg>"), std::string::npos);
  EXPECT_NE(text("new/report/resolution.svg").find("</svg>"), std::string::npos);
}

TEST_F(ReportFigures, MissingProgramsAreTold) {
  std::filesystem::create_directory(folder_ / "empty");
  const Outcome outcome =
      run({.arguments = {"report", "--quick", "-o", "out"}, .folder = folder_ / ".", .path = folder_ / "empty"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* told :
       {"apt-get install valgrind", "apt-get install povray", "apt-get install raster3d", "apt-get install gnuplot"}) {
    EXPECT_NE(outcome.err.find(told), std::string::npos) << told;
    EXPECT_NE(text("out/README.md").find(told), std::string::npos) << told;
  }
  for (const Line& line : read_csv(folder_.read("out/results.csv"))) {
    EXPECT_EQ(line.at("renderer"), "Halfspace");
    EXPECT_EQ(line.at("instructions_per_dot"), "");
  }
}

}  // namespace
}  // namespace halfspace::testing

#endif
