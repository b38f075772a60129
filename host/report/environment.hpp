// environment.hpp - what a report's figures were measured with.
#pragma once

#include <string>

namespace halfspace {

struct Environment {
  std::string processor, compiler, commit, date, povray, raster3d, valgrind, qemu;
};

// What cannot be found out reads "unknown" or "missing".
[[nodiscard]] Environment read_environment();

}  // namespace halfspace
