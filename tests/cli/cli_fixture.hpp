// cli_fixture.hpp - a folder to run the program in, and small scenes to give it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/child.hpp"
#include "tests/picture/scratch_folder.hpp"

namespace halfspace::testing {

inline const std::string tube = HALFSPACE_SOURCE_DIR "/scenes/tube.uq";
inline const std::string view_and_light = "light l .3; light s .7 .4 .5 -1; view v dop 0 0 -1 whw 4 whh 4;\n";
inline const std::string ball = "quadric q <1 1 1 0 0 0 0 0 0 -9>; body b (q);\n";

class CommandLine : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return name;
  }

  [[nodiscard]] Outcome halfspace(std::vector<std::string> arguments) const {
    return run({.arguments = std::move(arguments), .folder = folder_ / "."});
  }

  // Refused with `status`, each of `said` in its words, no file but `before` left, and soon.
  void expect_refusal(const Outcome& outcome, int status, const std::vector<std::string>& said,
                      const std::vector<std::string>& before) const {
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& words : said)
      EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\nin\n" << outcome.err;
    EXPECT_EQ(folder_.names(), before);
  }

  ScratchFolder folder_;
};

}  // namespace halfspace::testing
