#include "tests/cli/child.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace halfspace::testing {
namespace {

// A nameless file, which goes with its last descriptor.
class Spool {
 public:
  Spool() : file_(std::tmpfile()) {
    if (file_ == nullptr) std::abort();
  }
  ~Spool() { std::fclose(file_); }
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  [[nodiscard]] int descriptor() const { return fileno(file_); }

  void fill(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) std::abort();
    std::rewind(file_);
  }

  [[nodiscard]] std::string text() {
    std::string all;
    std::array<char, 65536> part;
    std::rewind(file_);
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file_)) all.append(part.data(), count);
    return all;
  }

 private:
  std::FILE* file_;
};

struct Terminal {
  int master = -1, slave = -1;
};

Terminal open_terminal() {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) std::abort();
  const int slave = ::open(::ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave < 0) std::abort();
  return {master, slave};
}

int unread_pipe() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) std::abort();
  ::close(ends[0]);
  return ends[1];
}

// Between fork and exec. A sanitizer's own exit status must not look like one of the program's.
[[noreturn]] void become(const Child& child, int in, int out, int err) {
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::setenv("ASAN_OPTIONS", "exitcode=99", 1);
  ::setenv("UBSAN_OPTIONS", "exitcode=99:print_stacktrace=1", 1);
  if (!child.path.empty()) ::setenv("PATH", child.path.c_str(), 1);
  if (::chdir(child.folder.c_str()) != 0) ::_exit(98);
  if (child.obeys_permissions && ::geteuid() == 0) {
    if (::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) != 0 || ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH) != 0) {
      ::_exit(98);
    }
  }
  std::string program = HALFSPACE_PROGRAM;
  std::vector<std::string> arguments = child.arguments;
  std::vector<char*> pointers{program.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::alarm(patience_seconds);
  ::execv(program.c_str(), pointers.data());
  ::_exit(98);
}

std::string read_terminal(int master) {
  std::string all;
  std::array<char, 4096> part;
  for (ssize_t count = 1; count > 0;) {  // the last reader of a closed terminal meets EIO
    count = ::read(master, part.data(), part.size());
    if (count > 0) all.append(part.data(), static_cast<std::size_t>(count));
  }
  return all;
}

int standard_output(const Child& child, const Spool& out) {
  if (child.closed_output) return unread_pipe();
  if (child.output_path.empty()) return ::dup(out.descriptor());
  return ::open(child.output_path.c_str(), O_WRONLY | O_CLOEXEC);
}

}  // namespace

Outcome run(const Child& child) {
  Spool in, out, err;
  in.fill(child.input);
  const Terminal terminal = child.on_terminal ? open_terminal() : Terminal{};
  const int out_end = standard_output(child, out);
  const auto start = std::chrono::steady_clock::now();
  const pid_t process = ::fork();
  if (process < 0) std::abort();
  if (process == 0) become(child, in.descriptor(), out_end, child.on_terminal ? terminal.slave : err.descriptor());
  ::close(out_end);

  Outcome outcome;
  if (child.on_terminal) {
    ::close(terminal.slave);
    outcome.err = read_terminal(terminal.master);
    ::close(terminal.master);
  }
  int status = 0;
  rusage usage{};
  if (::wait4(process, &status, 0, &usage) != process) std::abort();
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.peak_kilobytes = usage.ru_maxrss;
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = out.text();
  if (!child.on_terminal) outcome.err = err.text();
  return outcome;
}

}  // namespace halfspace::testing
