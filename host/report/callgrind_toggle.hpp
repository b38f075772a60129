// callgrind_toggle.hpp - marks what callgrind counts. Without valgrind the marks cost a few instructions and do nothing.
#pragma once

#include <valgrind/callgrind.h>

namespace halfspace {

// What runs while one lives is counted; while one lives inside another, not.
class CallgrindToggle {
 public:
  CallgrindToggle() { CALLGRIND_TOGGLE_COLLECT; }
  ~CallgrindToggle() { CALLGRIND_TOGGLE_COLLECT; }
  CallgrindToggle(const CallgrindToggle&) = delete;
  CallgrindToggle& operator=(const CallgrindToggle&) = delete;
};

}  // namespace halfspace
