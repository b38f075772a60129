#include "host/cli/job_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace halfspace {
namespace {

constexpr const char* remedy = "compile the scene again";

const char* describe(DrawStatus status) {
  switch (status) {
    case DrawStatus::not_a_job:
      return "the job's header is damaged";
    case DrawStatus::bad_record:
      return "the job is damaged";
    case DrawStatus::missing_module:
      return "the job names an arc kind or a width that this program leaves out";
    case DrawStatus::does_not_fit:
      return "the job does not fit the core's memory";
    default:
      return "the page was stopped";
  }
}

// The magic, whatever its version.
bool begins_as_job(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= job_magic.size() && std::equal(job_magic.begin(), job_magic.end() - 1, bytes.begin());
}

}  // namespace

bool looks_like_job(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  std::error_code ignored;
  if (ending == ".hsj" || ending == ".uq" || !std::filesystem::is_regular_file(path, ignored)) return ending == ".hsj";
  std::array<std::uint8_t, job_magic.size()> first{};
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(first.data()), first.size());
  return begins_as_job(first);
}

JobFile::JobFile(const std::string& path) : name_(path == "-" ? "<standard input>" : path) { open_ = open(path); }

bool JobFile::open(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    tell("is a folder; name a job file");
    return false;
  }
  errno = 0;
  file_.reset(path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (file_ != nullptr) first_count_ = std::fread(first_.data(), 1, first_.size(), file_.get());
  if (file_ == nullptr || std::ferror(file_.get()) != 0) {
    tell(fmt::format("cannot be read ({}); check its name and permissions", std::strerror(errno)));
    return false;
  }
  if (first_count_ == first_.size() && first_ == job_magic) return true;
  tell(wrong_magic());
  return false;
}

void JobFile::tell(const std::string& what) const { fmt::print(stderr, "{}: error: {}\n", name_, what); }

std::string JobFile::wrong_magic() const {
  if (first_count_ == 0) return fmt::format("is empty; {}", remedy);
  if (!begins_as_job(std::span(first_).first(first_count_)))
    return "is not a job; name a file that halfspace compile has written";
  const std::uint8_t version = first_.back();
  const std::string text =
      version > ' ' && version <= '~' ? std::string(1, static_cast<char>(version)) : fmt::format("0x{:02x}", version);
  return fmt::format("is a job of version {}, and this program draws version {}; {}", text,
                     static_cast<char>(job_magic.back()), remedy);
}

std::size_t JobFile::read(std::span<std::uint8_t> into) {
  if (first_used_ < first_count_) {
    const std::size_t count = std::min(into.size(), first_count_ - first_used_);
    std::copy_n(first_.begin() + static_cast<std::ptrdiff_t>(first_used_), count, into.begin());
    first_used_ += count;
    return count;
  }
  errno = 0;
  const std::size_t count = std::fread(into.data(), 1, into.size(), file_.get());
  if (count == 0 && std::ferror(file_.get()) != 0) tell(fmt::format("cannot be read ({})", std::strerror(errno)));
  return count;
}

std::size_t JobInput::Watched::read(std::span<std::uint8_t> into) {
  const std::size_t count = next.read(into);
  bytes += count;
  ended = count == 0;
  return count;
}

JobInput::JobInput(ByteSource& bytes, std::string name) : name_(std::move(name)), watched_(bytes) {
  has_header_ = read_header(reader_, header_);
  if (!has_header_) {
    fail(ExitStatus::device_or_file_failed,
         fmt::format("{}; {}", watched_.ended ? "the job ends within its header" : describe(DrawStatus::not_a_job),
                     remedy));
  }
}

ExitStatus JobInput::verdict(const DrawResult& result) {
  if (result.status == DrawStatus::ok) {
    (void)reader_.byte();
    if (reader_.failed()) return ExitStatus::drawn;
    return fail(ExitStatus::device_or_file_failed, fmt::format("bytes follow the job's end; {}", remedy));
  }
  if (result.status == DrawStatus::too_many_spans) {
    return fail(ExitStatus::limit_exceeded,
                fmt::format("scan line {} has more than {} spans; draw the scene smaller or in parts", result.line,
                            result.have));
  }
  const bool short_job = result.status == DrawStatus::bad_record && watched_.ended;
  return fail(ExitStatus::device_or_file_failed,
              fmt::format("{} (scan line {}); {}", short_job ? "the job ends early" : describe(result.status),
                          result.line, remedy));
}

ExitStatus JobInput::fail(ExitStatus status, const std::string& what) const {
  return halfspace::fail(status, what, name_);
}

}  // namespace halfspace
