#include "tests/hard/text_cases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/scene/parse.hpp"

namespace halfspace::testing {
namespace {

// A text, not a path: names are asked for before all of the program is initialised.
constexpr char folder[] = HALFSPACE_SOURCE_DIR "/tests/hard/scenes";

std::vector<std::string> find_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

const std::vector<std::string>& text_cases() {
  static const std::vector<std::string> names = find_names();
  return names;
}

std::string text_of(const std::string& name) {
  std::ifstream in(std::filesystem::path(folder) / (name + ".uq"));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

Flattened flatten_text(const std::string& name, const std::string& text, std::int32_t width, std::int32_t height) {
  Flattened result;
  const SourceText source{name + ".uq", text};
  ParseResult parsed = parse_uniquadrix(std::span(&source, 1));
  const auto failed = [&result](const Diagnostics& diagnostics) {
    const auto worst = std::find_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity != Severity::warning; });
    if (worst != diagnostics.end()) result.refusal = format(*worst);
    return worst != diagnostics.end();
  };
  if (failed(parsed.diagnostics)) return result;
  result.scene = std::move(parsed.scene);
  FlattenResult flat = flatten(result.scene, {width, height, 65, 1, 1, ""});
  if (!failed(flat.diagnostics)) result.integers = std::move(flat.scene);
  return result;
}

}  // namespace halfspace::testing
