// violation.hpp - what a simulator found wrong, and where in the bytes sent to it.
#pragma once

#include <cstddef>
#include <string>

namespace halfspace {

struct Violation {
  std::size_t offset = 0;  // bytes taken before it
  std::string what;
  friend bool operator==(const Violation&, const Violation&) = default;
};

}  // namespace halfspace
