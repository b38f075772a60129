#include "tests/hard/drawing.hpp"

#include <algorithm>
#include <numeric>

#include "firmware/core/memory_source.hpp"
#include "firmware/core/stipple.hpp"
#include "host/job/job_writer.hpp"
#include "host/resolve/resolve.hpp"
#include "tests/oracle/exact_oracle.hpp"

namespace halfspace::testing {
namespace {

// Keeps the lines asked for.
class Collector final : public BandSink {
 public:
  Collector(const Page& page, const Lines& lines) : width_(page.row_bytes()), lines_(lines) {}

  bool put_band(const Band& band) override {
    for (; next_ < lines_.size() && lines_[next_] < band.y + band.rows; ++next_) {
      const auto row = band.bytes.subspan(static_cast<std::size_t>(lines_[next_] - band.y) * width_, width_);
      dots_.insert(dots_.end(), row.begin(), row.end());
    }
    return true;
  }
  [[nodiscard]] const Levels& dots() const { return dots_; }

 private:
  std::size_t width_;
  const Lines& lines_;
  std::size_t next_ = 0;
  Levels dots_;
};

std::string place(const Lines& lines, std::int32_t width, std::size_t i) {
  const auto w = static_cast<std::size_t>(width);
  return std::to_string(i % w) + ", " + std::to_string(lines[i / w]);
}

}  // namespace

Lines all_lines(const IntegerScene& scene) {
  Lines lines(static_cast<std::size_t>(scene.height));
  std::iota(lines.begin(), lines.end(), 0);
  return lines;
}

Drawing::Drawing(const IntegerScene& scene) : scene_(scene), resolved_(resolve(scene)) {}

Levels Drawing::draw(DotFormat format, std::int32_t background, Shader shader, const Lines& lines,
                     Comparison& failure) const {
  JobOptions options;
  options.page = {scene_.width, scene_.height, format, scene_.levels, background};
  options.measure = false;
  const JobResult job = write_job(scene_, resolved_, options);
  if (!job.diagnostics.empty()) {
    failure.limit = halfspace::format(job.diagnostics.front());
    return {};
  }
  std::vector<std::uint64_t> memory(memory_wanted(job.header, 16) / 8 + 1);
  MemorySource source(job.bytes);
  Collector collector(options.page, lines);
  const DrawResult result = halfspace::draw(source, collector, std::as_writable_bytes(std::span(memory)),
                                            {.shader = shader, .band_rows = 16, .measure = false}, all_modules);
  if (result.status != DrawStatus::ok) failure.wrong = "core status " + std::to_string(static_cast<int>(result.status));
  return collector.dots();
}

// The bytes of lines of levels, dot by dot.
Levels Drawing::halftone(const Levels& levels, const Lines& lines) const {
  std::vector<PatternRow> patterns(static_cast<std::size_t>(scene_.levels) * cell_side);
  make_patterns(JobOptions{}.screen, scene_.levels, patterns);
  Levels bytes;
  const std::int16_t* at = levels.data();
  for (const std::int32_t y : lines) {
    for (std::int32_t x = 0; x < scene_.width; ++x, ++at) {
      if (x % 8 == 0) bytes.push_back(0);
      const PatternRow row = patterns[static_cast<std::size_t>(y % cell_side * scene_.levels + *at)];
      bytes.back() = static_cast<std::int16_t>(bytes.back() | (row >> (15 - x % cell_side) & 1) << (7 - x % 8));
    }
  }
  return bytes;
}

// Drawn on black and on white: a dot that differs shows no face.
Comparison Drawing::compare(std::int32_t levels, Shader shader, const Lines& lines, const Levels& truth) {
  scene_.levels = levels;
  Comparison result;
  Levels drawn = draw(DotFormat::gray, 0, shader, lines, result);
  const Levels white = draw(DotFormat::gray, levels - 1, shader, lines, result);
  const Levels bilevel = draw(DotFormat::bilevel, 0, shader, lines, result);
  if (!result.limit.empty() || !result.wrong.empty()) return result;
  if (bilevel != halftone(drawn, lines)) return {"", "the bilevel page shows other levels than the gray one"};
  if (drawn.size() != truth.size()) return {"", "the core left out scan lines"};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i] != white[i]) drawn[i] = -1;
  }
  const auto [first, other] = std::mismatch(drawn.begin(), drawn.end(), truth.begin());
  if (first == drawn.end()) return {};
  const std::size_t wrong = std::inner_product(drawn.begin(), drawn.end(), truth.begin(), std::size_t{0}, std::plus<>(),
                                               std::not_equal_to<>());
  return {"", std::to_string(wrong) + " wrong dots of " + std::to_string(levels) + " levels; dot (" +
                  place(lines, scene_.width, static_cast<std::size_t>(first - drawn.begin())) + ") is " +
                  std::to_string(*first) + ", truth " + std::to_string(*other)};
}

Levels true_levels(IntegerScene scene, std::int32_t levels, const Lines& lines) {
  scene.levels = levels;
  Levels truth;
  for (const std::int32_t y : lines) {
    const Levels line = oracle::draw(scene, y, y + 1);
    truth.insert(truth.end(), line.begin(), line.end());
  }
  return truth;
}

}  // namespace halfspace::testing
