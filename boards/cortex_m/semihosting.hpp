// semihosting.hpp - the host's files and exit code, reached through the debugger or QEMU.
// Source  Arm, "Semihosting for AArch32 and AArch64": operations SYS_OPEN, SYS_READ, SYS_WRITE, SYS_CLOSE,
//         SYS_GET_CMDLINE, SYS_EXIT_EXTENDED.
#pragma once

#include <string_view>

#include "firmware/core/page.hpp"
#include "hal/byte_sink.hpp"

namespace halfspace::cortex_m {

// The name that opens the host's console.
inline constexpr const char* console_name = ":tt";

// A file of the host, written from its beginning. A file that could not be opened fails every write with io.
class HostFile final : public ByteSink {
 public:
  // The file is created when the first bytes come. `name` must outlive the file.
  explicit HostFile(const char* name) : name_(name) {}
  Accepted write(std::span<const std::uint8_t> bytes) override;
  void close();

 private:
  static constexpr int not_open = -1;
  const char* name_;
  int handle_ = not_open;
};

// A file of the host, read from its beginning. A file that could not be opened has no bytes.
class HostInput final : public ByteSource {
 public:
  explicit HostInput(const char* name);
  std::size_t read(std::span<std::uint8_t> into) override;

 private:
  int handle_;
};

// The words that the program was started with, as one line in `into`; empty if it does not fit.
[[nodiscard]] std::string_view command_line(std::span<char> into);

[[noreturn]] void exit_program(int status);

}  // namespace halfspace::cortex_m
