// examples_test.cpp - every example of docs/language.md and every scene of scenes/ is read without an error.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/scene/parse_helpers.hpp"

namespace halfspace::test {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string read_document() { return read_text(HALFSPACE_SOURCE_DIR "/docs/language.md"); }

// The blocks between "```uq" and "```".
std::vector<std::string> examples(const std::string& document) {
  constexpr std::string_view opening = "\n```uq\n";
  constexpr std::string_view closing = "\n```\n";
  std::vector<std::string> found;
  for (std::size_t at = document.find(opening); at != std::string::npos; at = document.find(opening, at)) {
    at += opening.size();
    found.push_back(document.substr(at, document.find(closing, at) + 1 - at));
  }
  return found;
}

TEST(LanguageDocument, ItsExamplesAreGoodScenes) {
  const std::vector<std::string> found = examples(read_document());
  ASSERT_GE(found.size(), 8U);
  for (const std::string& example : found) EXPECT_EQ(errors(example), std::vector<std::string>{}) << example;
}

TEST(LanguageDocument, NamesEveryWordOfTheLanguage) {
  const std::string document = read_document();
  for (const std::string word :
       {"plane", "quadric", "body", "definition", "enddef", "instance", "array", "light", "view", "vrp",
        "vpn",   "vup",     "dop",  "cop",        "whh",    "whw",      "fbp",   "=tx",   "=ty",  "=tz",
        "=ta",   "=sx",     "=sy",  "=sz",        "=sa",    "=rx",      "=ry",   "=rz",   "=vxy", "=vxz",
        "=vyx",  "=vyz",    "=vzx", "=vzy",       "=t",     "=0",       "=v",    "=p",    "=a",   "=r"}) {
    EXPECT_NE(document.find("`" + word), std::string::npos) << word;
  }
}

TEST(Scenes, AreGood) {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HALFSPACE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".uq") continue;
    ++found;
    EXPECT_EQ(errors(read_text(entry.path())), std::vector<std::string>{}) << entry.path();
  }
  EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace halfspace::test
