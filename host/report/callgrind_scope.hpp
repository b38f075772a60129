// callgrind_scope.hpp - marks what callgrind counts. Without valgrind the marks cost a few instructions and do nothing.
#pragma once

#include <valgrind/callgrind.h>

namespace halfspace {

// What runs while one lives is counted.
class CallgrindScope {
 public:
  CallgrindScope() {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_TOGGLE_COLLECT;
  }
  ~CallgrindScope() {
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_STOP_INSTRUMENTATION;
  }
  CallgrindScope(const CallgrindScope&) = delete;
  CallgrindScope& operator=(const CallgrindScope&) = delete;
};

// What runs while one lives, inside a scope, is left out.
class CallgrindPause {
 public:
  CallgrindPause() { CALLGRIND_TOGGLE_COLLECT; }
  ~CallgrindPause() { CALLGRIND_TOGGLE_COLLECT; }
  CallgrindPause(const CallgrindPause&) = delete;
  CallgrindPause& operator=(const CallgrindPause&) = delete;
};

}  // namespace halfspace
