// diagnostic.hpp - where in the input something is wrong, what it is, and what would be right.
#pragma once

#include <string>
#include <vector>

namespace halfspace {

struct SourcePosition {
  std::string file;  // as given on the command line; empty: no file
  int line = 0;      // from 1; 0: unknown
  int column = 0;    // from 1, in bytes; 0: unknown
};

enum class Severity { warning, error, limit };  // limit: the scene exceeds a stated limit (exit status 4)

struct Diagnostic {
  Severity severity = Severity::error;
  SourcePosition position;
  std::string message;  // "what, and what would be right"
};

using Diagnostics = std::vector<Diagnostic>;

// "file:line:column: error: message"; what is unknown is left out. A limit is an error to the reader.
[[nodiscard]] std::string format(const Diagnostic& diagnostic);

// True when something is worse than a warning: the scene must not be drawn.
[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

}  // namespace halfspace
