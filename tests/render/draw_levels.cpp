#include "tests/render/draw_levels.hpp"

#include "firmware/core/memory_source.hpp"
#include "host/job/job_writer.hpp"
#include "host/resolve/resolve.hpp"

namespace halfspace::testing {
namespace {

class Collector final : public BandSink {
 public:
  bool put_band(const Band& band) override {
    dots.insert(dots.end(), band.bytes.begin(), band.bytes.end());
    return true;
  }
  std::vector<std::uint8_t> dots;
};

std::vector<std::uint8_t> draw_gray(const IntegerScene& scene, const ResolvedScene& resolved, std::int32_t background,
                                    Shader shader, std::int32_t stride, Drawn& drawn) {
  JobOptions options;
  options.page = {scene.width, scene.height, DotFormat::gray, scene.levels, background};
  options.measure = false;
  const JobResult job = write_job(scene, resolved, options);
  if (!job.diagnostics.empty()) {
    drawn.refusal = job.diagnostics.front().message;
    return {};
  }
  std::vector<std::uint64_t> memory(memory_wanted(job.header, 16) / 8 + 1);
  MemorySource source(job.bytes);
  Collector collector;
  drawn.result = draw(source, collector, std::as_writable_bytes(std::span(memory)),
                      {.shader = shader, .stride = stride, .band_rows = 16, .measure = false}, all_modules);
  if (drawn.result.status != DrawStatus::ok) {
    drawn.refusal = "core status " + std::to_string(static_cast<int>(drawn.result.status));
  }
  return std::move(collector.dots);
}

}  // namespace

// Drawn on black and on white: a dot that differs shows no face.
Drawn draw_levels(const IntegerScene& scene, Shader shader, std::int32_t stride) {
  Drawn drawn;
  const ResolvedScene resolved = resolve(scene);
  const auto black = draw_gray(scene, resolved, 0, shader, stride, drawn);
  if (!drawn.refusal.empty()) return drawn;
  const auto white = draw_gray(scene, resolved, scene.levels - 1, shader, stride, drawn);
  if (!drawn.refusal.empty()) return drawn;
  for (std::size_t i = 0; i < black.size(); ++i) {
    drawn.levels.push_back(black[i] == white[i] ? static_cast<std::int16_t>(black[i]) : std::int16_t{-1});
  }
  return drawn;
}

}  // namespace halfspace::testing
