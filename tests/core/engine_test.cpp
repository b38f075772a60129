// The engine: a job in, bands out; refusals, and jobs that are cut short or lie.
#include "firmware/core/engine.hpp"

#include <gtest/gtest.h>

#include "firmware/core/memory_source.hpp"
#include "host/job/job_bytes.hpp"
#include "tests/core/numbers.hpp"
#include "tests/core/sample_job.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

constexpr std::size_t plenty = std::size_t{1} << 20;

Drawn draw_bytes(std::span<const std::uint8_t> bytes, std::size_t memory = plenty, const DrawOptions& options = {},
                 std::size_t most_bands = SIZE_MAX, const Modules& modules = all_modules) {
  MemorySource source(bytes);
  return draw_job(source, memory, options, most_bands, modules);
}

TEST(Numbers, WhatTheWriterWritesTheReaderReads) {
  Dice dice(50);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::int64_t number = random_bits(dice, 63).get_si();
    const auto small = static_cast<std::uint32_t>(dice() >> between(dice, 32, 63));
    const mpz_class wide = random_bits(dice, 127);
    JobBytes out;
    for (const std::int64_t n : {number, INT64_MIN, INT64_MAX}) out.number(n);
    out.unsigned_number(small);
    out.wide(wide);
    out.wide(-(mpz_class(1) << 127));
    out.wide((mpz_class(1) << 127) - 1);
    const auto bytes = out.take();
    MemorySource source(bytes);
    JobReader in(source);
    for (const std::int64_t n : {number, INT64_MIN, INT64_MAX}) ASSERT_EQ(in.number(), n);
    ASSERT_EQ(in.unsigned_number(), small);
    ASSERT_EQ(to_mpz(in.wide<128>()), wide);
    ASSERT_EQ(to_mpz(in.wide<128>()), -(mpz_class(1) << 127));
    ASSERT_EQ(to_mpz(in.wide<128>()), (mpz_class(1) << 127) - 1);
    ASSERT_FALSE(in.failed());
    (void)in.byte();
    ASSERT_TRUE(in.failed()) << "nothing is left";
  }
}

TEST(Numbers, TooLongOrOutOfRangeIsMalformed) {
  const auto fails = [](std::vector<std::uint8_t> bytes, auto read) {
    MemorySource source(bytes);
    JobReader in(source);
    read(in);
    return in.failed();
  };
  const std::vector<std::uint8_t> endless(12, 0xff);
  EXPECT_TRUE(fails(endless, [](JobReader& in) { (void)in.number(); }));
  EXPECT_TRUE(fails(endless, [](JobReader& in) { (void)in.unsigned_number(); }));
  EXPECT_TRUE(fails({0xff, 0xff, 0xff, 0xff, 0x1f}, [](JobReader& in) { (void)in.unsigned_number(); }));
  EXPECT_FALSE(fails({0xff, 0xff, 0xff, 0xff, 0x0f}, [](JobReader& in) { (void)in.unsigned_number(); }));
  EXPECT_TRUE(fails({9, 1, 2, 3, 4, 5, 6, 7, 8, 9}, [](JobReader& in) { (void)in.wide<64>(); }));
  EXPECT_TRUE(fails({6}, [](JobReader& in) { (void)in.number_in(-2, 2); }));
  EXPECT_FALSE(fails({4}, [](JobReader& in) { (void)in.number_in(-2, 2); }));
}

TEST(Engine, DrawsTheSampleTheSameEveryTime) {
  for (const DotFormat format : {DotFormat::bilevel, DotFormat::gray}) {
    const JobResult job = sample_job(format);
    ASSERT_TRUE(job.diagnostics.empty()) << job.diagnostics.front().message;
    const Drawn first = draw_bytes(job.bytes);
    ASSERT_EQ(first.result.status, DrawStatus::ok);
    EXPECT_EQ(first.result.peak_spans, job.header.needs.spans);
    EXPECT_GT(first.result.counters.dots, 1500U);
    EXPECT_EQ(first.bytes.size(), job.header.page.row_bytes() * sample_height);
    EXPECT_EQ(draw_bytes(job.bytes).bytes, first.bytes);
    EXPECT_EQ(sample_job(format).bytes, job.bytes) << "the same scene gives the same job";
    EXPECT_EQ(draw_bytes(job.bytes, plenty, {.shader = Shader::jordan}).bytes, first.bytes);
  }
}

TEST(Engine, GuidedArcsDrawWhatConicsDraw) {
  const JobResult job = guided_job(DotFormat::gray);
  ASSERT_TRUE(job.diagnostics.empty()) << job.diagnostics.front().message;
  EXPECT_EQ(job.header.needs.arc_bytes, radical_arc_128.bytes);
  const Drawn drawn = draw_bytes(job.bytes);
  ASSERT_EQ(drawn.result.status, DrawStatus::ok);
  EXPECT_EQ(drawn.bytes, draw_bytes(sample_job(DotFormat::gray).bytes).bytes);
}

TEST(Engine, BandsOfEveryHeightGiveTheSamePage) {
  const JobResult job = sample_job(DotFormat::bilevel);
  const Drawn whole = draw_bytes(job.bytes);
  for (const std::int32_t rows : {1, 2, 7, 16, 59, 60, 1000}) {
    const Drawn drawn = draw_bytes(job.bytes, plenty, {.band_rows = rows});
    ASSERT_EQ(drawn.result.status, DrawStatus::ok);
    EXPECT_EQ(drawn.result.band_rows, std::min(rows, sample_height));
    EXPECT_EQ(drawn.bytes, whole.bytes) << rows;
    std::int32_t y = 0;
    for (const Band& band : drawn.bands) {
      EXPECT_EQ(band.y, y);
      y += band.rows;
    }
    EXPECT_EQ(y, sample_height);
  }
}

TEST(Engine, HalvesTheBandUntilTheJobFitsAndRefusesNamingNeedAndHave) {
  const JobResult job = sample_job(DotFormat::gray);
  const std::size_t one_row = memory_needed(job.header, 1);
  const std::size_t three_rows = memory_needed(job.header, 3);
  ASSERT_LT(one_row, three_rows);
  const Drawn tight = draw_bytes(job.bytes, three_rows, {.band_rows = 16});
  EXPECT_EQ(tight.result.status, DrawStatus::ok);
  EXPECT_EQ(tight.result.band_rows, 2) << "16, 8, 4, 2";
  EXPECT_EQ(tight.bytes, draw_bytes(job.bytes).bytes);
  EXPECT_EQ(draw_bytes(job.bytes, one_row).result.band_rows, 1);
  const Drawn refused = draw_bytes(job.bytes, one_row - 8);
  EXPECT_EQ(refused.result.status, DrawStatus::does_not_fit);
  EXPECT_EQ(refused.result.need, static_cast<std::int64_t>(one_row));
  EXPECT_EQ(refused.result.have, static_cast<std::int64_t>(one_row - 8));
  EXPECT_TRUE(refused.bytes.empty());
}

TEST(Engine, NamesMissingModulesAndStoppedSinks) {
  const JobResult job = sample_job(DotFormat::gray);
  Modules modules = all_modules;
  modules.arcs[static_cast<std::size_t>(ArcKind::conic64)] = nullptr;
  EXPECT_EQ(draw_bytes(job.bytes, plenty, {}, SIZE_MAX, modules).result.status, DrawStatus::missing_module);
  modules = all_modules;
  modules.exact = {};
  EXPECT_EQ(draw_bytes(job.bytes, plenty, {}, SIZE_MAX, modules).result.status, DrawStatus::missing_module);
  const Drawn stopped = draw_bytes(job.bytes, plenty, {.band_rows = 8}, 2);
  EXPECT_EQ(stopped.result.status, DrawStatus::stopped);
  EXPECT_EQ(stopped.result.line, 23);
  EXPECT_EQ(stopped.bands.size(), 2U);
}

TEST(Engine, MeasuringShadesNothingAndSeesTheSameSpans) {
  const JobResult job = sample_job(DotFormat::gray);
  const Drawn measured = draw_bytes(job.bytes, plenty, {.measure = true});
  EXPECT_EQ(measured.result.status, DrawStatus::ok);
  EXPECT_TRUE(measured.bands.empty());
  EXPECT_EQ(measured.result.counters.dots, 0U);
  EXPECT_EQ(measured.result.peak_spans, job.header.needs.spans);
}

TEST(Engine, RefusesALineWithMoreSpansThanTheHeaderSays) {
  JobResult job = sample_job(DotFormat::gray);
  ASSERT_GT(job.header.needs.spans, 1);
  MemorySource source(job.bytes);
  JobReader in(source);
  JobHeader header;
  ASSERT_TRUE(read_header(in, header));
  --header.needs.spans;
  std::vector<std::uint64_t> memory(plenty / 8);
  Collector sink;
  const DrawResult result = draw(in, header, sink, std::as_writable_bytes(std::span(memory)), {}, all_modules);
  EXPECT_EQ(result.status, DrawStatus::too_many_spans);
  EXPECT_EQ(result.have, header.needs.spans);
  EXPECT_EQ(result.need, result.have + 1);
}

class OneByteAtATime final : public ByteSource {
 public:
  explicit OneByteAtATime(std::span<const std::uint8_t> bytes) : source_(bytes) {}
  std::size_t read(std::span<std::uint8_t> into) override { return source_.read(into.first(1)); }

 private:
  MemorySource source_;
};

TEST(Engine, ASlowSourceGivesTheSamePage) {
  const JobResult job = sample_job(DotFormat::bilevel);
  OneByteAtATime source(job.bytes);
  const Drawn drawn = draw_job(source, plenty);
  EXPECT_EQ(drawn.result.status, DrawStatus::ok);
  EXPECT_EQ(drawn.bytes, draw_bytes(job.bytes).bytes);
}

TEST(HostileJob, AJobCutAnywhereIsAnError) {
  const JobResult job = guided_job(DotFormat::gray);
  for (std::size_t length = 0; length < job.bytes.size(); ++length) {
    const Drawn drawn = draw_bytes(std::span(job.bytes).first(length));
    ASSERT_TRUE(drawn.result.status == DrawStatus::not_a_job || drawn.result.status == DrawStatus::bad_record)
        << length;
  }
}

TEST(HostileJob, AHeaderOutOfRangeIsNotAJob) {
  const JobResult job = sample_job(DotFormat::gray);
  for (const std::size_t at : {0, 3}) {
    auto bytes = job.bytes;
    ++bytes[at];
    EXPECT_EQ(draw_bytes(bytes).result.status, DrawStatus::not_a_job);
  }
  const auto with_width = [&job](std::int64_t width) {
    JobBytes out;
    for (std::size_t i = 0; i < 4; ++i) out.byte(job.bytes[i]);
    out.number(width);
    for (std::size_t i = 6; i < job.bytes.size(); ++i) out.byte(job.bytes[i]);  // the width takes two bytes
    return out.take();
  };
  EXPECT_EQ(draw_bytes(with_width(sample_width)).result.status, DrawStatus::ok);
  for (const std::int64_t width : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{32768}, INT64_MAX}) {
    EXPECT_EQ(draw_bytes(with_width(width)).result.status, DrawStatus::not_a_job) << width;
  }
}

std::vector<std::uint8_t> mutate(std::vector<std::uint8_t> bytes, Dice& dice) {
  for (auto count = between(dice, 1, 4); count > 0; --count) {
    const auto at = static_cast<std::ptrdiff_t>(dice() % bytes.size());
    switch (between(dice, 0, 4)) {
      case 0:
        bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1U << dice() % 8);
        break;
      case 1:
        bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(dice());
        break;
      case 2:
        bytes.erase(bytes.begin() + at);
        break;
      case 3:
        bytes.insert(bytes.begin() + at, static_cast<std::uint8_t>(dice()));
        break;
      default: {  // a piece of the job again: records repeat, slots are taken twice
        const std::vector<std::uint8_t> piece(bytes.begin() + at,
                                              bytes.begin() + std::min<std::ptrdiff_t>(at + 60, std::ssize(bytes)));
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(dice() % bytes.size()), piece.begin(), piece.end());
      }
    }
    if (bytes.empty()) bytes.push_back(0);
  }
  return bytes;
}

// Never a crash, a hang or an access out of bounds (the sanitizers watch); a page may come out wrong.
TEST(HostileJob, ThousandsOfMutationsDoNoHarm) {
  const std::array jobs{sample_job(DotFormat::gray).bytes, sample_job(DotFormat::bilevel).bytes,
                        guided_job(DotFormat::gray).bytes};
  std::array<int, 7> count{};
  for (std::uint64_t seed = 0; seed < testing::trials(20000U); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto bytes = mutate(jobs[seed % jobs.size()], dice);
    const auto shader = static_cast<Shader>(seed / 2 % 5);
    const Drawn drawn = draw_bytes(bytes, plenty, {.shader = shader}, 8);
    ++count[static_cast<std::size_t>(drawn.result.status)];
    ASSERT_LT(drawn.result.line, 9 * 16) << "the ninth band is refused";
  }
  EXPECT_GT(count[static_cast<std::size_t>(DrawStatus::ok)], testing::trials(1000)) << "some mutations are harmless";
  EXPECT_GT(count[static_cast<std::size_t>(DrawStatus::bad_record)], testing::trials(5000));
}

}  // namespace
}  // namespace halfspace
