#include "host/scene/parse.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "host/scene/definition_graph.hpp"
#include "host/scene/diagnostic_log.hpp"
#include "host/scene/names.hpp"
#include "host/scene/statement_reader.hpp"

namespace halfspace {
namespace {

constexpr std::size_t largest_file = 64U << 20U;  // bytes; lines and columns then fit an int

void read_files(std::span<const SourceText> files, SceneDraft& draft, DiagnosticLog& log) {
  for (const SourceText& file : files) {
    if (log.full()) return;
    if (file.text.size() > largest_file) {
      draft.complete = false;
      log.limit({file.name, 0, 0},
                "the file has " + std::to_string(file.text.size()) + " bytes; split it into files of at most 64 MB");
    } else {
      read_statements(file.name, file.text, draft, log);
    }
  }
}

// Errors were found in passes; a reader wants them in the order of the text.
Diagnostics in_text_order(std::span<const SourceText> files, const DiagnosticLog& log) {
  std::unordered_map<std::string_view, std::size_t> order;
  for (std::size_t i = 0; i < files.size(); ++i) order.try_emplace(files[i].name, i);
  const auto key = [&](const Diagnostic& d) {
    return std::tuple(order.at(d.position.file), d.position.line, d.position.column);
  };
  Diagnostics sorted = log.kept();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  return sorted;
}

void add_closing_notes(const DiagnosticLog& log, Diagnostics& diagnostics) {
  const SourcePosition nowhere;
  if (log.warnings() > DiagnosticLog::most) {
    const std::string more = std::to_string(log.warnings() - DiagnosticLog::most);
    diagnostics.push_back({Severity::warning, nowhere, more + " further warnings are not shown"});
  }
  if (log.full()) {
    const std::string most = std::to_string(DiagnosticLog::most);
    diagnostics.push_back(
        {Severity::error, nowhere, "nothing more is checked after " + most + " errors; mend these first"});
  }
}

}  // namespace

ParseResult parse_uniquadrix(std::span<const SourceText> files) {
  SceneDraft draft;
  DiagnosticLog log;
  read_files(files, draft, log);
  if (draft.complete && !log.full()) {
    check_half_space_references(draft, log);
    check_definition_uses(draft, log);
  }
  invent_missing_ids(draft, log);

  ParseResult result;
  result.diagnostics = in_text_order(files, log);
  add_closing_notes(log, result.diagnostics);
  result.scene = std::move(draft.scene);
  return result;
}

}  // namespace halfspace
