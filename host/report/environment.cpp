#include "host/report/environment.hpp"

#include <array>
#include <ctime>
#include <fstream>

#include "host/report/child.hpp"

namespace halfspace {
namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

// What follows `mark` in what the program says, as far as `letters` go.
std::string version(const std::vector<std::string>& words, const std::string& mark,
                    const char* letters = "0123456789.-") {
  if (!has_program(words[0])) return "missing";
  const std::string said = run_child(words).output;
  const std::size_t at = said.find(mark);
  if (at == std::string::npos) return "unknown";
  const std::size_t from = at + mark.size();
  std::string found = said.substr(from, said.find_first_not_of(letters, from) - from);
  while (found.ends_with('.')) found.pop_back();  // "3.7.0.10.unofficial"
  return found.empty() ? "unknown" : found;
}

std::string commit() {
  const std::string tree = HALFSPACE_SOURCE_DIR;
  const std::string id = version({"git", "-C", tree, "rev-parse", "--short", "HEAD"}, "", "0123456789abcdef");
  const bool changed = !run_child({"git", "-C", tree, "diff", "--quiet", "HEAD", "--", ".", ":!docs/report"}).ok();
  return id + (changed ? " with changes" : "");
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", gmtime_r(&now, &parts));
  return text.data();
}

}  // namespace

Environment read_environment() {
  return {.processor = processor(),
          .compiler = "g++ " __VERSION__,
          .commit = commit(),
          .date = date(),
          .povray = version({"povray", "--version"}, "POV-Ray "),
          .raster3d = version({"render", "-version"}, "Raster3D "),
          .valgrind = version({"valgrind", "--version"}, "valgrind-"),
          .qemu = version({"qemu-system-arm", "--version"}, "version ")};
}

}  // namespace halfspace
