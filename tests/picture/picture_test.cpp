// Picture files: read back by OpenImageIO, and their depth and density by a look at the bytes themselves.
#include "host/picture/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/picture/scratch_folder.hpp"

namespace halfspace {
namespace {

Picture bilevel(std::int32_t width, std::int32_t height) {
  PaperSheet sheet{.width = width, .height = height};
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::size_t i = 0; i < sheet.row_bytes(); ++i)
      sheet.dots.push_back(static_cast<std::uint8_t>(37 * (y + 3) + 11 * static_cast<int>(i)));
    if (width % 8 != 0) sheet.dots.back() &= static_cast<std::uint8_t>(0xFF << (8 - width % 8));
  }
  return to_picture(sheet, 200);
}

std::vector<std::uint8_t> as_gray(const Picture& picture) {
  std::vector<std::uint8_t> gray;
  for (std::int32_t y = 0; y < picture.height; ++y) {
    for (std::int32_t x = 0; x < picture.width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * picture.row_bytes();
      const auto column = static_cast<std::size_t>(x);
      const bool ink = picture.bits == 1 && (picture.dots[at + column / 8] >> (7 - x % 8) & 1) != 0;
      gray.push_back(picture.bits == 8 ? picture.dots[at + column] : ink ? std::uint8_t{0} : std::uint8_t{255});
    }
  }
  return gray;
}

TEST(Picture, ReadsBackDotForDotInEveryFormat) {
  const ScratchFolder folder;
  for (const char* const name : {"a.png", "a.tif", "a.tiff", "a.pbm", "a.pgm", "a.exr", "a.PNG"}) {
    for (const std::int32_t width : {1, 7, 8, 9, 31, 2112}) {
      const Picture picture = bilevel(width, 5);
      ASSERT_EQ(write_picture(picture, folder / name), std::nullopt);
      const auto back = read_picture(folder / name);
      ASSERT_TRUE(back) << name;
      EXPECT_EQ(back->width, width);
      EXPECT_EQ(back->height, 5);
      EXPECT_EQ(back->dots, as_gray(picture)) << name << " " << width;
    }
  }
}

TEST(Picture, HoldsOneBitADotAndTheDensityWhereTheFormatCan) {
  const ScratchFolder folder;
  const Picture picture = bilevel(19, 3);
  for (const char* const name : {"a.png", "a.tif", "a.pbm", "a.exr"})
    ASSERT_EQ(write_picture(picture, folder / name), std::nullopt);
  const auto png = folder.read("a.png");
  EXPECT_EQ(png[24], 1);  // IHDR: bit depth
  EXPECT_EQ(png[25], 0);  // gray
  const std::string pbm = "P4\n19 3\n";
  auto expected = std::vector<std::uint8_t>(pbm.begin(), pbm.end());
  expected.insert(expected.end(), picture.dots.begin(), picture.dots.end());
  EXPECT_EQ(folder.read("a.pbm"), expected);
  EXPECT_EQ(stored_bits(folder / "a.tif"), 1);
  for (const char* const name : {"a.png", "a.tif", "a.exr"}) EXPECT_EQ(read_picture(folder / name)->dpi, 200) << name;
}

TEST(Picture, ScalesLevelsToTheNearestOf255) {
  for (std::int32_t levels = 2; levels <= 256; ++levels) {
    PaperSheet sheet{.width = levels, .height = 1, .format = DotFormat::gray, .levels = levels};
    for (std::int32_t level = 0; level < levels; ++level) sheet.dots.push_back(static_cast<std::uint8_t>(level));
    const Picture picture = to_picture(sheet, 100);
    for (std::int32_t level = 0; level < levels; ++level) {
      EXPECT_EQ(picture.dots[static_cast<std::size_t>(level)], std::floor(255.0 * level / (levels - 1) + 0.5));
    }
  }
}

TEST(Picture, KeepsGrayInEveryFormatThatHasIt) {
  const ScratchFolder folder;
  PaperSheet sheet{.width = 16, .height = 16, .format = DotFormat::gray, .levels = 256};
  for (int level = 0; level < 256; ++level) sheet.dots.push_back(static_cast<std::uint8_t>(level));
  const Picture picture = to_picture(sheet, 72);
  for (const char* const name : {"g.png", "g.tif", "g.pgm", "g.exr"}) {
    ASSERT_EQ(write_picture(picture, folder / name), std::nullopt);
    EXPECT_EQ(read_picture(folder / name)->dots, sheet.dots) << name;
  }
}

TEST(Picture, RefusesWhatItCannotWriteAndLeavesNothing) {
  const ScratchFolder folder;
  Picture gray{.width = 1, .height = 1, .bits = 8, .dots = {7}};
  EXPECT_NE(write_picture(gray, folder / "a.pbm")->find(".pgm"), std::string::npos);
  EXPECT_NE(write_picture(gray, folder / "a.jpg")->find(".png .tif .pbm .pgm"), std::string::npos);
  EXPECT_NE(write_picture(gray, folder / "a")->find("not a picture's name"), std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace halfspace
