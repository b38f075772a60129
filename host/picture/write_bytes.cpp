#include "host/picture/write_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace halfspace {
namespace {

const char* remedy(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space, or write elsewhere";
    case ENOENT:
    case ENOTDIR:
      return "create the folder first, or write elsewhere";
    case EACCES:
    case EPERM:
    case EROFS:
      return "check the permissions, or write elsewhere";
    case EISDIR:
      return "name a file in it";
    default:
      return "write elsewhere";
  }
}

std::string failure(const std::string& path, int error) {
  return "cannot write " + path + ": " + std::strerror(error) + ": " + remedy(error);
}

// 0, or the error.
int write_all_to(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return 0;
}

int write_and_close(int file, std::span<const std::uint8_t> bytes) {
  const int error = write_all_to(file, bytes);
  const int close_error = ::close(file) == 0 ? 0 : errno;  // a full disk may show only here
  return error != 0 ? error : close_error;
}

int write_directly(const std::string& path, std::span<const std::uint8_t> bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  return file < 0 ? errno : write_and_close(file, bytes);
}

int write_and_rename(const std::string& path, std::span<const std::uint8_t> bytes) {
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".part";
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int error = write_and_close(file, bytes);
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) ::unlink(temporary.c_str());
  return error;
}

// The file behind a chain of links: renaming onto a link would replace the link.
std::string behind_links(const std::string& path) {
  std::error_code error;
  const auto real = std::filesystem::weakly_canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

std::optional<std::string> write_bytes(const std::string& path, std::span<const std::uint8_t> bytes) {
  if (path == "-") {
    const int error = write_all_to(STDOUT_FILENO, bytes);
    return error == 0 ? std::nullopt : std::optional(failure("to standard output", error));
  }
  struct stat found {};
  const bool exists = ::stat(path.c_str(), &found) == 0;
  int error = 0;
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    error = errno;
  } else if (exists && !S_ISREG(found.st_mode)) {
    error = write_directly(path, bytes);
  } else {
    error = write_and_rename(behind_links(path), bytes);
  }
  return error == 0 ? std::nullopt : std::optional(failure(path, error));
}

}  // namespace halfspace
