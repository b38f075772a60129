// child.hpp - runs the real program as a user's shell would, and says all that came of it.
#pragma once

#include <string>
#include <vector>

namespace halfspace::testing {

struct Child {
  std::vector<std::string> arguments;
  std::string input = {};          // standard input
  std::string folder = ".";        // current folder
  std::string output_path = {};    // standard output goes to this file instead of `out`
  std::string path = {};           // folders of programs; empty: as here
  bool closed_output = false;      // standard output is a pipe that nobody reads
  bool on_terminal = false;        // standard error is a terminal
  bool obeys_permissions = false;  // even when root runs the test
};

struct Outcome {
  int status = -1;  // exit status; -1: ended by a signal
  int signal = 0;
  std::string out, err;
  double seconds = 0;  // by the clock
  long peak_kilobytes = 0;
};

// A child is stopped (SIGALRM) after this long; generous, since sanitizers and other tests slow it down.
constexpr unsigned patience_seconds = 120;

[[nodiscard]] Outcome run(const Child& child);

}  // namespace halfspace::testing
