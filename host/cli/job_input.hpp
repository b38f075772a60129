// job_input.hpp - a job as it is read, from memory or from a file, and words for what is wrong with it.
// A file is read as the core asks for it, so that none is too long to be held.
// Errors  Told on standard error, with the file's name where there is one.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "firmware/core/engine.hpp"
#include "host/cli/exit_status.hpp"

namespace halfspace {

// How far a silhouette may lie from the true one.
[[nodiscard]] inline double bound_in_dots(const JobHeader& header) { return header.bound * 0x1p-20; }

// A file that is called a job (.hsj), or begins as one and is not called a scene (.uq).
[[nodiscard]] bool looks_like_job(const std::string& path);

// "-" is standard input.
class JobFile final : public ByteSource {
 public:
  explicit JobFile(const std::string& path);

  // False: it cannot be read, or does not begin as a job of this version does; why has been told.
  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  std::size_t read(std::span<std::uint8_t> into) override;

 private:
  bool open(const std::string& path);
  void tell(const std::string& what) const;
  [[nodiscard]] std::string wrong_magic() const;

  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdin) std::fclose(file);
    }
  };
  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  std::array<std::uint8_t, job_magic.size()> first_{};  // looked at before the core reads them
  std::size_t first_count_ = 0, first_used_ = 0;
  bool open_ = false;
};

class JobInput {
 public:
  // Reads the header. `name` is the file's; empty: the job lies in memory.
  JobInput(ByteSource& bytes, std::string name);

  [[nodiscard]] bool has_header() const { return has_header_; }  // false: told
  [[nodiscard]] const JobHeader& header() const { return header_; }
  [[nodiscard]] std::size_t bytes() const { return watched_.bytes; }  // read so far
  JobReader& reader() { return reader_; }

  // Once the core is done: what it found, told unless all is well. Bytes that follow the job's end are an error too.
  [[nodiscard]] ExitStatus verdict(const DrawResult& result);

  // One error, with the file's name in front.
  ExitStatus fail(ExitStatus status, const std::string& what) const;

 private:
  struct Watched final : ByteSource {
    explicit Watched(ByteSource& source) : next(source) {}
    std::size_t read(std::span<std::uint8_t> into) override;
    ByteSource& next;
    std::size_t bytes = 0;
    bool ended = false;
  };

  std::string name_;
  Watched watched_;
  JobReader reader_{watched_};
  JobHeader header_;
  bool has_header_ = false;
};

}  // namespace halfspace
