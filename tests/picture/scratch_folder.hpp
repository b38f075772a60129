// scratch_folder.hpp - a folder of a test's own, removed with all that is in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace halfspace {

class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] std::vector<std::string> names() const;  // sorted
  [[nodiscard]] std::vector<std::uint8_t> read(const std::string& name) const;

 private:
  std::string path_;
};

// BitsPerSample of a little-endian TIFF; 0: it has none.
[[nodiscard]] int stored_bits(const std::string& tiff);

}  // namespace halfspace
