// hostile_test.cpp - texts made to break a parser: each must end soon, with a bounded list of errors.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "tests/scene/parse_helpers.hpp"

namespace halfspace::test {
namespace {

using Random = std::mt19937_64;

std::uint64_t pick(Random& random, std::uint64_t below) { return random() % below; }

// Generous for a slow, instrumented build; a quadratic parser would need hours.
void expect_soon(std::string_view what, const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  const ParseResult result = parse(text);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 10.0) << what;
  EXPECT_LE(result.diagnostics.size(), 202U) << what;
}

TEST(Hostile, OneMegabyteOfAnyOneByteEndsSoon) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text(byte == '{' || byte == '(' ? 1'000'000 : 50'000, static_cast<char>(byte));
    expect_soon("byte " + std::to_string(byte), text);
    expect_soon("in a body, byte " + std::to_string(byte), "body b (" + text);
  }
}

TEST(Hostile, AMillionNestedCommentsNeedNoStack) {
  const std::string open(1'000'000, '{');
  const std::string close(1'000'000, '}');
  EXPECT_EQ(errors(open + close + " oops;").size(), 1U);
  EXPECT_EQ(errors(open + close.substr(1)).size(), 1U);
}

TEST(Hostile, ManyOpenCommentsInARowAreScannedOnce) {
  std::string text;
  for (int i = 0; i < 500'000; ++i) text += "{}{";
  expect_soon("comments", text);
}

TEST(Hostile, MillionsOfErrorsOfEachKindEndSoon) {
  for (const std::string_view piece :
       {"instance i (u);", "body b (u);", "plane p <1 0 0 0>;", "light .1;", "definition d;", "enddef;", "x", "plane\n",
        "view v vrp\n", "array a (d) 1;", "plane p <0 0 nan 0>;"}) {
    std::string text;
    while (text.size() < 2'000'000) text += piece;
    expect_soon(piece, text);
  }
}

TEST(Hostile, AVeryLongIdIsShownInPart) {
  const std::vector<std::string> found = errors("body b (" + std::string(1'000'000, 'x') + ");");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(found[0].size(), 200U);
}

TEST(Hostile, AFileOverTheLimitIsRefusedUnread) {
  const std::vector<SourceText> files = {{"big.uq", std::string((64U << 20U) + 1, ' ')}, {"t.uq", "body b (a);"}};
  const ParseResult result = parse_uniquadrix(files);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::limit);
  EXPECT_EQ(format(result.diagnostics[0]),
            "big.uq: error: the file has 67108865 bytes; split it into files of at most 64 MB");
}

TEST(Hostile, ThreeMegabytesOfRandomBytesEndSoon) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::string text(3'000'000, '\0');
  for (char& c : text) c = static_cast<char>(random());
  expect_soon("random bytes", text);
  for (char& c : text) c = c == '{' ? ' ' : c;  // else the first open comment hides the rest
  expect_soon("random bytes without comments", text);
}

// Tokens in random order reach every branch of the reader, which random bytes never do.
std::string random_tokens(Random& random) {
  constexpr std::string_view tokens[] = {"plane",
                                         "quadric",
                                         "body",
                                         "definition",
                                         "enddef",
                                         "instance",
                                         "array",
                                         "light",
                                         "view",
                                         "vrp",
                                         "vpn",
                                         "dop",
                                         "cop",
                                         "whh",
                                         "fbp",
                                         "a",
                                         "b",
                                         "c",
                                         "<",
                                         ">",
                                         "(",
                                         ")",
                                         "!",
                                         ";",
                                         ";",
                                         "0",
                                         "1",
                                         "-2.5",
                                         "1e999",
                                         "nan",
                                         "=t",
                                         "=0",
                                         "=tx",
                                         "=ta",
                                         "=sa",
                                         "=p",
                                         "{",
                                         "}",
                                         "\n",
                                         "=",
                                         ",",
                                         "\x80",
                                         "plane a <1 0 0 0>;",
                                         "body b (a);",
                                         "definition c;",
                                         "enddef;",
                                         "instance b (c);",
                                         "array a (b =tx 1) 3 =ry 60;",
                                         "light .5;",
                                         "view a dop 0 0 1;"};
  std::string text;
  const std::uint64_t count = pick(random, 60);
  for (std::uint64_t i = 0; i < count; ++i) {
    text += tokens[pick(random, std::size(tokens))];
    if (pick(random, 8) != 0) text += ' ';
  }
  return text;
}

// What scene.hpp promises of a scene without errors.
void expect_promises(const Scene& scene) {
  for (const LightStatement& light : scene.lights) EXPECT_FALSE(light.id.empty());
  for (const ViewStatement& view : scene.views) EXPECT_FALSE(view.parameters.empty());
  for (const Group& definition : scene.definitions) EXPECT_FALSE(definition.id.empty());
  for (const Placement& placement : scene.top.placements) {
    const auto* body = std::get_if<BodyStatement>(&placement);
    EXPECT_TRUE(body == nullptr || !body->half_spaces.empty());
    const auto* array = std::get_if<ArrayStatement>(&placement);
    EXPECT_TRUE(array == nullptr || array->count >= 1);
  }
}

TEST(Hostile, RandomTokensNeverBreakAPromise) {
  const std::uint64_t seed = std::random_device{}();
  Random random(seed);
  int good = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = random_tokens(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", text " + std::to_string(i) + ": " + text);
    const ParseResult result = parse(text);
    for (const Diagnostic& diagnostic : result.diagnostics) {
      EXPECT_FALSE(diagnostic.message.empty());
      EXPECT_GE(diagnostic.position.line, 1);
    }
    if (has_errors(result.diagnostics)) continue;
    ++good;
    expect_promises(result.scene);
  }
  EXPECT_GT(good, 0) << "seed " << seed;
}

// One byte changed in a good scene: the commonest wrong scene.
TEST(Hostile, AnyChangedByteIsReadOrReported) {
  const std::string good =
      "definition d; quadric q <1 0 1 0 0 0 0 0 0 -4> =t; plane p (0 1 0 -2); body b <q !p>; enddef;\n"
      "{ c { d } } array a (d =tx 2) 6 =ry 60; light s .7 .4 -.4 -1; view v cop 0 0 -9 =r fbp -1 1;";
  ASSERT_EQ(errors(good), std::vector<std::string>{});
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char c : std::string("\0;<>(){}!=,. \n0x-\xFF", 18)) {
      std::string text = good;
      text[at] = c;
      const ParseResult result = parse(text);
      EXPECT_LE(result.diagnostics.size(), 20U) << text;
    }
  }
}

}  // namespace
}  // namespace halfspace::test
