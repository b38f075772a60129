// parse_helpers.hpp - parse a text from a test, and see what is said about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/scene/parse.hpp"

namespace halfspace::test {

inline ParseResult parse(std::string_view text) {
  const std::vector<SourceText> files = {{"t.uq", std::string(text)}};
  return parse_uniquadrix(files);
}

// Every message of the run, formatted, warnings included.
inline std::vector<std::string> messages(const ParseResult& result) {
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : result.diagnostics) lines.push_back(format(diagnostic));
  return lines;
}

inline std::vector<std::string> messages(std::string_view text) { return messages(parse(text)); }

// The messages worse than warnings.
inline std::vector<std::string> errors(std::string_view text) {
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : parse(text).diagnostics) {
    if (diagnostic.severity != Severity::warning) lines.push_back(format(diagnostic));
  }
  return lines;
}

}  // namespace halfspace::test
