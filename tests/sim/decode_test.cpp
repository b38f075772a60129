// The decoders are strict: each defect of a stream is named with its byte, and no damaged stream is believed or crashes.
#include "sim/decode.hpp"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

void expect_violation(const Decoded& decoded, std::size_t offset, const std::string& what) {
  EXPECT_FALSE(decoded.sheet) << what;
  EXPECT_EQ(decoded.violation.what, what);
  EXPECT_EQ(decoded.violation.offset, offset) << what;
}

constexpr std::string_view spans_head = "halfspace spans 1\npage 6 4 levels 8 background 0\n";

TEST(DecodeSpans, NamesEachDefect) {
  struct Case {
    std::size_t after_head;
    const char* what;
    const char* body;
  };
  const Case cases[] = {
      {0, "end of the page expected", ""},
      {0, "scan line out of order", "4 0-0:1\nend 4\n"},
      {8, "scan line out of order", "1 0-0:1\n1 1-1:1\nend 4\n"},
      {1, "span expected", "1\nend 4\n"},
      {4, "last dot of a span out of order", "1 3-2:1\nend 4\n"},
      {4, "last dot of a span out of order", "1 3-6:1\nend 4\n"},
      {8, "first dot of a span out of order", "1 0-2:1 2-3:2\nend 4\n"},
      {6, "level out of range", "1 0-2:8\nend 4\n"},
      {7, "span of the background level", "1 0-2:0\nend 4\n"},
      {13, "spans that should be one", "1 0-2:1 3-4:1\nend 4\n"},
      {4, "height at the end differs", "end 3\n"},
      {6, "bytes after the page", "end 4\n\n"},
  };
  for (const Case& c : cases) {
    expect_violation(decode_spans(bytes_of(std::string(spans_head) + c.body)), spans_head.size() + c.after_head,
                     c.what);
  }
}

TEST(DecodePgm, NamesEachDefect) {
  expect_violation(decode_pgm(bytes_of("P6\n")), 1, "not a binary PGM");
  expect_violation(decode_pgm(bytes_of("P5\n0 1\n255\n")), 3, "width out of range");
  expect_violation(decode_pgm(bytes_of("P5\n2 1\n255\na")), 11, "picture cut short");
  expect_violation(decode_pgm(bytes_of("P5\n2 1\n9\n\1\12")), 11, "level above maxval");
  expect_violation(decode_pgm(bytes_of("P5\n2 1\n9\n\1\11\1")), 11, "bytes after the page");
}

TEST(DecodeBraille, NamesEachDefect) {
  expect_violation(decode_braille(bytes_of("⠀\n"), 4, 4), 3, "line too short");
  expect_violation(decode_braille(bytes_of("abc\n"), 2, 4), 3, "no braille cell");
  expect_violation(decode_braille(bytes_of("⠈\n"), 1, 4), 3, "dot raised outside the page");
  expect_violation(decode_braille(bytes_of("⠂\n"), 2, 1), 3, "dot raised outside the page");
  expect_violation(decode_braille(bytes_of("⠀⠀\n"), 2, 4), 3, "end of line expected");
}

Bytes pwg_page(std::uint8_t width, std::uint8_t height, const Bytes& body) {
  Bytes stream{'R', 'a', 'S', '2'};
  stream.resize(1800);
  stream[4 + 375] = width;
  stream[4 + 379] = height;
  stream[4 + 387] = stream[4 + 391] = 1;
  stream[4 + 395] = static_cast<std::uint8_t>((width + 7) / 8);
  stream[4 + 403] = 3;
  for (const std::uint8_t byte : body) stream.push_back(byte);
  return stream;
}

TEST(DecodePwg, ReadsPiecesAndNamesEachDefect) {
  const Decoded good = decode_pwg(pwg_page(24, 2, {1, 254, 7, 8, 9}));
  ASSERT_TRUE(good.sheet);
  EXPECT_EQ(good.sheet->dots, (Bytes{7, 8, 9, 7, 8, 9}));
  expect_violation(decode_pwg(bytes_of("RaS3")), 3, "not PWG Raster");
  expect_violation(decode_pwg(pwg_page(24, 2, {2, 2, 0})), 1801, "lines beyond the end of the page");
  expect_violation(decode_pwg(pwg_page(24, 2, {1, 3, 0})), 1802, "piece beyond the end of the line");
  expect_violation(decode_pwg(pwg_page(24, 2, {1, 254, 0})), 1802, "line cut short");
  expect_violation(decode_pwg(pwg_page(24, 2, {0, 2, 0})), 1803, "page cut short");
  expect_violation(decode_pwg(pwg_page(24, 2, {1, 2, 0, 0})), 1803, "bytes after the page");
}

TEST(Decoders, SurviveDamagedStreams) {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    Bytes stream = round % 2 == 0 ? pwg_page(24, 2, {1, 254, 7, 8, 9})
                                  : bytes_of(std::string(spans_head) + "1 0-2:1 4-5:3\nend 4\n");
    for (int damage = 0; damage < 3; ++damage) {
      stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
      if (random() % 4 == 0) stream.resize(random() % stream.size() + 1);
    }
    for (const Decoded& decoded : {decode_pwg(stream), decode_spans(stream)}) {
      EXPECT_NE(decoded.sheet.has_value(), !decoded.violation.what.empty());
    }
  }
}

}  // namespace
}  // namespace halfspace
