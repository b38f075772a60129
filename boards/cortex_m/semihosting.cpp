#include "boards/cortex_m/semihosting.hpp"

namespace halfspace::cortex_m {
namespace {

enum Operation : std::uint32_t {
  sys_open = 0x01,
  sys_close = 0x02,
  sys_write = 0x05,
  sys_read = 0x06,
  sys_get_cmdline = 0x15,
  sys_exit_extended = 0x20
};

constexpr std::uint32_t open_to_read = 1;            // fopen's "rb"
constexpr std::uint32_t open_to_write = 5;           // "wb"
constexpr std::uint32_t application_exit = 0x20026;  // ADP_Stopped_ApplicationExit

// Operation in r0, its block of words in r1, the answer in r0.
std::int32_t call(Operation operation, const std::uint32_t* block) {
  register std::uint32_t r0 asm("r0") = operation;
  register const std::uint32_t* r1 asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
  return static_cast<std::int32_t>(r0);
}

std::uint32_t address(const void* p) { return reinterpret_cast<std::uint32_t>(p); }

std::int32_t open(const char* name, std::uint32_t mode) {
  const std::uint32_t block[] = {address(name), mode, std::string_view(name).size()};
  return call(sys_open, block);
}

}  // namespace

Accepted HostFile::write(std::span<const std::uint8_t> bytes) {
  if (handle_ == not_open) {
    handle_ = open(name_, open_to_write);
    if (handle_ == not_open) return {DeviceStatus::io, 0};
  }
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_), address(bytes.data()), bytes.size()};
  const auto left = static_cast<std::size_t>(call(sys_write, block));
  // Nothing taken is a full or broken file, not a busy one.
  if (left >= bytes.size() && !bytes.empty()) return {DeviceStatus::io, 0};
  return {DeviceStatus::ok, bytes.size() - left};
}

void HostFile::close() {
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_)};
  if (handle_ != not_open) (void)call(sys_close, block);
  handle_ = not_open;
}

HostInput::HostInput(const char* name) : handle_(open(name, open_to_read)) {}

std::size_t HostInput::read(std::span<std::uint8_t> into) {
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_), address(into.data()), into.size()};
  const auto left = static_cast<std::size_t>(call(sys_read, block));  // of a file that is not open: -1
  return left <= into.size() ? into.size() - left : 0;
}

std::string_view command_line(std::span<char> into) {
  std::uint32_t block[] = {address(into.data()), into.size()};
  return call(sys_get_cmdline, block) == 0 ? std::string_view(into.data(), block[1]) : std::string_view();
}

void exit_program(int status) {
  const std::uint32_t block[] = {application_exit, static_cast<std::uint32_t>(status)};
  for (;;) (void)call(sys_exit_extended, block);
}

}  // namespace halfspace::cortex_m
