// files.hpp - whole files, and a folder of files that other programs ask for, removed with all that is in it.
#pragma once

#include <filesystem>
#include <string>

namespace halfspace {

class ReportScratch {
 public:
  // Throws where no temporary folder can be made.
  ReportScratch();
  ~ReportScratch();
  ReportScratch(const ReportScratch&) = delete;
  ReportScratch& operator=(const ReportScratch&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

// Throws, naming the file, what the system refused and what to do.
void write_file(const std::string& path, const std::string& text);
[[nodiscard]] std::string read_file(const std::string& path);

}  // namespace halfspace
