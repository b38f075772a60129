// A file is whole or absent, whatever goes wrong.
#include "host/picture/write_bytes.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "tests/picture/scratch_folder.hpp"

namespace halfspace {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(WriteBytes, WritesReplacesAndLeavesNoOtherFile) {
  const ScratchFolder folder;
  EXPECT_EQ(write_bytes(folder / "a.prn", Bytes{1, 2, 3}), std::nullopt);
  EXPECT_EQ(write_bytes(folder / "a.prn", Bytes{4}), std::nullopt);
  EXPECT_EQ(write_bytes(folder / "empty", Bytes{}), std::nullopt);
  EXPECT_EQ(folder.read("a.prn"), (Bytes{4}));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.prn", "empty"}));
}

TEST(WriteBytes, NamesTheErrorAndItsRemedy) {
  const ScratchFolder folder;
  struct Case {
    std::string path;
    const char* says;
  };
  std::filesystem::create_directory(folder / "folder");
  const Case cases[] = {
      {"/dev/full", "free some space"},
      {folder / "none/a.prn", "create the folder first"},
      {folder / "folder", "name a file in it"},
      {"", "No such file"},
  };
  for (const Case& c : cases) {
    const auto error = write_bytes(c.path, Bytes(100000));
    ASSERT_TRUE(error) << c.path;
    EXPECT_NE(error->find(c.says), std::string::npos) << *error;
    EXPECT_NE(error->find(c.path), std::string::npos) << *error;
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"folder"}));
}

TEST(WriteBytes, WritesDirectlyToWhatIsNotAFile) {
  EXPECT_EQ(write_bytes("/dev/null", Bytes(1000)), std::nullopt);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WriteBytes, FollowsALinkAndKeepsIt) {
  const ScratchFolder folder;
  ASSERT_EQ(write_bytes(folder / "file", Bytes{1}), std::nullopt);
  std::filesystem::create_symlink("file", folder / "link.prn");
  ASSERT_EQ(write_bytes(folder / "link.prn", Bytes{2}), std::nullopt);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.prn"));
  EXPECT_EQ(folder.read("file"), (Bytes{2}));
}

// A limit on the size of files stands for a disk that fills up half-way.
TEST(WriteBytes, KeepsTheOldFileWhenTheDiskFillsUp) {
  const ScratchFolder folder;
  ASSERT_EQ(write_bytes(folder / "a.prn", Bytes{1, 2, 3}), std::nullopt);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto error = write_bytes(folder / "a.prn", Bytes(100000));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(error);
  EXPECT_EQ(folder.read("a.prn"), (Bytes{1, 2, 3}));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.prn"}));
}

}  // namespace
}  // namespace halfspace
