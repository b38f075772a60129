// semihosting.hpp - the host's files and exit code, reached through the debugger or QEMU.
// Source  Arm, "Semihosting for AArch32 and AArch64": operations SYS_OPEN, SYS_WRITE, SYS_CLOSE, SYS_EXIT_EXTENDED.
#pragma once

#include "hal/byte_sink.hpp"

namespace halfspace::microbit {

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

[[noreturn]] void exit_program(int status);

}  // namespace halfspace::microbit
