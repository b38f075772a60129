// child.hpp - other programs: whether they are there, what they say, and the processor time they take.
#pragma once

#include <string>
#include <vector>

namespace halfspace {

struct ChildResult {
  int status = -1;     // exit status; -1: not started, or ended by a signal
  double seconds = 0;  // processor time, of its children too
  std::string output;  // standard output and standard error, as they came

  [[nodiscard]] bool ok() const { return status == 0; }
};

[[nodiscard]] bool has_program(const std::string& name);

// `input` and `output` are files; standard output that goes to one is not collected.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& words, const std::string& input = "",
                                    const std::string& output = "");

}  // namespace halfspace
