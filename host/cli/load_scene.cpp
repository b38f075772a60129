#include "host/cli/load_scene.hpp"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "host/scene/parse.hpp"

namespace halfspace {
namespace {

// Not by iostreams, whose buffers throw an error away or throw it.
std::optional<std::string> read_stream(std::FILE* in) {
  std::string text;
  std::array<char, 65536> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), in)) text.append(part.data(), count);
  if (std::ferror(in) != 0) return std::nullopt;
  return text;
}

std::optional<std::string> read_scene_text(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    fmt::print(stderr, "{}: error: is a folder; name a scene file\n", path);
    return std::nullopt;
  }
  errno = 0;
  const bool standard_input = path == "-";
  std::FILE* const in = standard_input ? stdin : std::fopen(path.c_str(), "rb");
  std::optional<std::string> text;
  if (in != nullptr) text = read_stream(in);
  if (!text) {
    fmt::print(stderr, "{}: error: cannot be read ({}); check its name and permissions\n",
               standard_input ? "<standard input>" : path, std::strerror(errno));
  }
  if (in != nullptr && !standard_input) std::fclose(in);
  return text;
}

}  // namespace

ExitStatus fail(ExitStatus status, const std::string& message, const std::string& file) {
  fmt::print(stderr, "{}error: {}\n", file.empty() ? "" : file + ": ", message);
  return status;
}

ExitStatus report(const Diagnostics& diagnostics, bool quiet) {
  ExitStatus status = ExitStatus::drawn;
  for (const Diagnostic& diagnostic : diagnostics) {
    const bool warning = diagnostic.severity == Severity::warning;
    if (!warning || !quiet) fmt::print(stderr, "{}\n", format(diagnostic));
    if (diagnostic.severity == Severity::error) status = ExitStatus::scene_wrong;
    if (diagnostic.severity == Severity::limit && status == ExitStatus::drawn) status = ExitStatus::limit_exceeded;
  }
  return status;
}

LoadedScene load_scene(const std::vector<std::string>& paths, const std::string& language, bool quiet) {
  LoadedScene loaded;
  std::vector<SourceText> texts;
  for (const std::string& path : paths) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (language.empty() && path != "-" && ending != ".uq") {
      loaded.status =
          fail(ExitStatus::command_line_wrong,
               ending == ".hsj" ? fmt::format("{}: a job is drawn by itself, with halfspace run", path)
                                : fmt::format("{}: a scene file ends in .uq; rename it or say --language uq", path));
      return loaded;
    }
    std::optional<std::string> text = read_scene_text(path);
    if (!text) {
      loaded.status = ExitStatus::device_or_file_failed;
      return loaded;
    }
    texts.push_back({path == "-" ? "<standard input>" : path, std::move(*text)});
  }
  ParseResult parsed = parse_uniquadrix(texts);
  loaded.status = report(parsed.diagnostics, quiet);
  loaded.scene = std::move(parsed.scene);
  return loaded;
}

}  // namespace halfspace
