#include "host/report/environment.hpp"

#include <array>
#include <ctime>
#include <fstream>
#include <regex>

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

// The first group that `pattern` finds in what the program says.
std::string version(const std::vector<std::string>& words, const char* pattern) {
  if (!has_program(words[0])) return "missing";
  const std::string said = run_child(words).output;
  std::smatch found;
  return std::regex_search(said, found, std::regex(pattern)) ? found[1].str() : "unknown";
}

std::string commit() {
  const std::string tree = HALFSPACE_SOURCE_DIR;
  const std::string id = version({"git", "-C", tree, "rev-parse", "--short", "HEAD"}, "^([0-9a-f]+)\n");
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
          .povray = version({"povray", "--version"}, "POV-Ray ([0-9.]+[0-9])"),
          .raster3d = version({"render", "-version"}, "Raster3D +V?([0-9.-]+)"),
          .valgrind = version({"valgrind", "--version"}, "valgrind-([0-9.]+)"),
          .qemu = version({"qemu-system-arm", "--version"}, "version ([0-9.]+)")};
}

}  // namespace halfspace
