// write_bytes.hpp - puts a whole file under its name, or nothing: a half-written one is never seen.
// A regular file is written under a temporary name in the same folder, then renamed. What is not a regular
// file (a device, a pipe, "-" for standard output) is written directly. Errors  Returned: what failed, on
// which path, and a remedy. The temporary file is gone then.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace halfspace {

[[nodiscard]] std::optional<std::string> write_bytes(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace halfspace
