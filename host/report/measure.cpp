#include "host/report/measure.hpp"

#include <algorithm>
#include <numeric>

#include "host/report/instructions.hpp"
#include "host/report/processor_time.hpp"
#include "tests/oracle/exact_oracle.hpp"

namespace halfspace {
namespace {

double per_dot(double seconds, std::uint64_t dots) {
  return 1e9 * seconds / static_cast<double>(std::max<std::uint64_t>(1, dots));
}

}  // namespace

Truth true_levels(const IntegerScene& scene, std::uint64_t most_dots, bool trust_boxes) {
  const auto width = static_cast<std::uint64_t>(scene.width), height = static_cast<std::uint64_t>(scene.height);
  const auto apart = static_cast<std::int32_t>((width * height + most_dots - 1) / most_dots);
  const oracle::Options options{.filter = true, .trust_boxes = trust_boxes};
  Truth truth;
  if (apart == 1) {  // at once, for the oracle prepares every body for a call
    truth.lines.resize(static_cast<std::size_t>(scene.height));
    std::iota(truth.lines.begin(), truth.lines.end(), 0);
    truth.levels = oracle::draw(scene, 0, scene.height, options);
    return truth;
  }
  for (std::int32_t y = apart / 2; y < scene.height; y += apart) {
    const auto line = oracle::draw(scene, y, y + 1, options);
    truth.lines.push_back(y);
    truth.levels.insert(truth.levels.end(), line.begin(), line.end());
  }
  return truth;
}

std::vector<std::int16_t> pick_lines(const std::vector<std::int16_t>& levels, const Truth& truth, std::int32_t width) {
  std::vector<std::int16_t> picked;
  for (const std::int32_t y : truth.lines) {
    const auto line = levels.begin() + static_cast<std::ptrdiff_t>(y) * width;
    picked.insert(picked.end(), line, line + width);
  }
  return picked;
}

Rows measure(const Subject& subject, const Truth& truth, const MeasureOptions& options) {
  Rows rows;
  std::vector<std::uint64_t> memory;
  const double empty = median_seconds(options.runs, [&] { draw_job(subject.empty_job, main_shader, memory); });
  for (const ListedShader& shader : listed_shaders) {
    Row row{.suite = subject.source.suite,
            .scene = subject.source.name,
            .renderer = "Halfspace",
            .shader = shader.name,
            .size = subject.size};
    row.shaded = draw_job(subject.job, shader, memory);
    const double time = median_seconds(options.runs, [&] { draw_job(subject.job, shader, memory); });
    row.ns = per_dot(time - empty, row.shaded);
    if (options.from_text) {
      const double all = median_seconds(options.runs, [&] { draw_from_text(subject.source, subject.size, shader); });
      row.text_ns = per_dot(all - empty, row.shaded);
    }
    const std::int32_t width = subject.size.width;
    row.error = picture_error(pick_lines(drawn_levels(subject.scene, shader), truth, width), truth.levels, width);
    rows.push_back(row);
  }
  return rows;
}

std::string add_instructions(std::span<const Subject> subjects, std::span<Row> rows) {
  std::vector<CountedJob> jobs;
  for (const Subject& subject : subjects) {
    jobs.push_back({&subject.empty_job, &main_shader});
    for (const ListedShader& shader : listed_shaders) jobs.push_back({&subject.job, &shader});
  }
  std::string why;
  const std::vector<std::uint64_t> counts = count_instructions(jobs, why);
  const std::size_t stride = listed_shaders.size() + 1;  // an empty page, then a row a shader
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (i % stride == 0) continue;
    Row& row = rows[i / stride * listed_shaders.size() + i % stride - 1];
    row.instructions = counts[i];
    row.empty_instructions = counts[i / stride * stride];
  }
  return why;
}

}  // namespace halfspace
