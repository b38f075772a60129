#include "host/report/child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace halfspace {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Between fork and exec.
[[noreturn]] void become(const std::vector<std::string>& words, const std::string& input, const std::string& output,
                         int collected) {
  const int in = ::open(input.empty() ? "/dev/null" : input.c_str(), O_RDONLY);
  ::dup2(in, STDIN_FILENO);
  const int out = output.empty() ? collected : ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(collected, STDERR_FILENO);
  std::vector<char*> pointers(words.size() + 1);  // the last one is null
  for (std::size_t i = 0; i < words.size(); ++i) pointers[i] = const_cast<char*>(words[i].c_str());
  ::execvp(pointers[0], pointers.data());
  ::_exit(127);
}

std::string read_all(int descriptor) {
  std::string all;
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t count = ::read(descriptor, part.data(), part.size());
    if (count <= 0) return all;
    all.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

bool has_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((std::filesystem::path(folder) / name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

ChildResult run_child(const std::vector<std::string>& words, const std::string& input, const std::string& output) {
  ChildResult result;
  std::array<int, 2> pipe{-1, -1};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return result;
  const pid_t process = ::fork();
  if (process == 0) become(words, input, output, pipe[1]);
  ::close(pipe[1]);
  result.output = read_all(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  rusage usage{};
  if (process < 0 || ::wait4(process, &status, 0, &usage) != process) return result;
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  result.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return result;
}

}  // namespace halfspace
