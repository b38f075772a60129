#include "host/report/files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "host/picture/write_bytes.hpp"

namespace halfspace {

ReportScratch::ReportScratch() {
  std::string name = (std::filesystem::temp_directory_path() / "halfspace-report-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error(name + ": cannot be made (" + std::strerror(errno) +
                             "); set TMPDIR to a folder that can be written");
  }
  path_ = name;
}

ReportScratch::~ReportScratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_file(const std::string& path, const std::string& text) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  if (const auto error = write_bytes(path, {bytes, text.size()})) throw std::runtime_error(*error);
}

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": cannot be read; run the report beside the sources it was built from");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace halfspace
