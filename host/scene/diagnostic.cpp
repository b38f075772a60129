#include "host/scene/diagnostic.hpp"

#include <algorithm>

namespace halfspace {
namespace {

std::string format_position(const SourcePosition& position) {
  std::string text;
  if (!position.file.empty()) text += position.file + ":";
  if (position.line > 0) text += std::to_string(position.line) + ":";
  if (position.line > 0 && position.column > 0) text += std::to_string(position.column) + ":";
  return text.empty() ? text : text + " ";
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
  const char* severity = diagnostic.severity == Severity::warning ? "warning: " : "error: ";
  return format_position(diagnostic.position) + severity + diagnostic.message;
}

bool has_errors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity != Severity::warning; });
}

}  // namespace halfspace
