#include "tests/picture/scratch_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace halfspace {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

unsigned little_endian(const std::vector<std::uint8_t>& bytes, std::size_t at, int count) {
  unsigned value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | bytes.at(at + static_cast<std::size_t>(i));
  return value;
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "halfspace-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) std::abort();
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::vector<std::string> ScratchFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::uint8_t> ScratchFolder::read(const std::string& name) const { return bytes_of(*this / name); }

int stored_bits(const std::string& tiff) {
  constexpr unsigned bits_per_sample = 258;
  const auto bytes = bytes_of(tiff);
  const std::size_t directory = little_endian(bytes, 4, 4);
  const unsigned entries = little_endian(bytes, directory, 2);
  for (unsigned i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (little_endian(bytes, entry, 2) == bits_per_sample) return static_cast<int>(little_endian(bytes, entry + 8, 2));
  }
  return 0;
}

}  // namespace halfspace
