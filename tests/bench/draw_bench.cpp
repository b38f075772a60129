// draw_bench - processor time of a gray page, one thread, bands to nowhere; `dots` counts those that show a face.
//   draw_page      the core alone, the job in memory; `empty` is the page without its bodies, to be taken off
//   draw_strides   the same by the shader of strides; `off_by_one`, `off_by_more` and `worst` say how far from the exact levels
//   from_text      everything: reading, flattening, resolving, the job and the page
//   resolve_bodies the resolver alone; `median_ms` is the median over bodies of at most two quadrics
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "firmware/core/engine.hpp"
#include "firmware/core/memory_source.hpp"
#include "host/flatten/flatten.hpp"
#include "host/job/job_writer.hpp"
#include "host/resolve/resolve.hpp"
#include "host/scene/parse.hpp"

namespace halfspace {
namespace {

constexpr Page page{2112, 1700, DotFormat::gray, 256, 0};
constexpr std::int32_t band_rows = 32;

void stop_on_errors(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) std::cerr << format(d) << '\n';
  if (has_errors(diagnostics)) std::exit(EXIT_FAILURE);
}

std::array<SourceText, 1> text_of(const std::string& name) {
  const std::string path = std::string(HALFSPACE_SOURCE_DIR) + "/scenes/" + name + ".uq";
  std::ifstream file(path);
  return {{{path, {std::istreambuf_iterator<char>(file), {}}}}};
}

IntegerScene flat_scene(const std::array<SourceText, 1>& texts) {
  const ParseResult parsed = parse_uniquadrix(texts);
  stop_on_errors(parsed.diagnostics);
  FlattenOptions options;
  options.width = page.width;
  options.height = page.height;
  options.levels = page.levels;
  FlattenResult flat = flatten(parsed.scene, options);
  stop_on_errors(flat.diagnostics);
  return std::move(flat.scene);
}

JobResult job_of(const IntegerScene& scene) {
  JobResult job = write_job(scene, resolve(scene), {.page = page});
  stop_on_errors(job.diagnostics);
  return job;
}

class Nowhere final : public BandSink {
 public:
  bool put_band(const Band& band) override {
    benchmark::DoNotOptimize(band.bytes.data());
    return true;
  }
};

class Dots final : public BandSink {
 public:
  bool put_band(const Band& band) override {
    levels.insert(levels.end(), band.bytes.begin(), band.bytes.end());
    return true;
  }
  std::vector<std::uint8_t> levels;
};

DrawResult draw_into(BandSink& sink, const JobResult& job, Shader shader, std::int32_t stride,
                     std::vector<std::uint64_t>& memory) {
  memory.resize(memory_wanted(job.header, band_rows) / 8 + 1);
  MemorySource source(job.bytes);
  return draw(source, sink, std::as_writable_bytes(std::span(memory)),
              {.shader = shader, .stride = stride, .band_rows = band_rows, .measure = false}, all_modules);
}

DrawResult draw_job(const JobResult& job, Shader shader, std::vector<std::uint64_t>& memory,
                    std::int32_t stride = default_stride) {
  Nowhere sink;
  return draw_into(sink, job, shader, stride, memory);
}

void draw_page(benchmark::State& state, const std::string& name, bool with_bodies, Shader shader) {
  IntegerScene scene = flat_scene(text_of(name));
  if (!with_bodies) scene.bodies.clear();
  const JobResult job = job_of(scene);
  std::vector<std::uint64_t> memory;
  const DrawResult counted = draw_job(job, shader, memory);
  if (counted.status != DrawStatus::ok) state.SkipWithError("the core refuses the job");
  for (auto _ : state) benchmark::DoNotOptimize(draw_job(job, shader, memory).status);
  state.counters["dots"] = static_cast<double>(counted.counters.dots);
}

// Dots off by so many levels: one, more, and the most there are.
void count_errors(benchmark::State& state, const JobResult& job, std::int32_t stride) {
  std::vector<std::uint64_t> memory;
  Dots exact, drawn;
  (void)draw_into(exact, job, Shader::isqrt, stride, memory);
  (void)draw_into(drawn, job, Shader::stride, stride, memory);
  std::int64_t one = 0, more = 0;
  int worst = 0;
  for (std::size_t i = 0; i < exact.levels.size(); ++i) {
    const int error = std::abs(drawn.levels[i] - exact.levels[i]);
    worst = std::max(worst, error);
    one += error == 1 ? 1 : 0;
    more += error > 1 ? 1 : 0;
  }
  state.counters["off_by_one"] = static_cast<double>(one);
  state.counters["off_by_more"] = static_cast<double>(more);
  state.counters["worst"] = worst;
}

void draw_strides(benchmark::State& state, const std::string& name) {
  const JobResult job = job_of(flat_scene(text_of(name)));
  const auto stride = static_cast<std::int32_t>(state.range(0));
  std::vector<std::uint64_t> memory;
  for (auto _ : state) benchmark::DoNotOptimize(draw_job(job, Shader::stride, memory, stride).status);
  count_errors(state, job, stride);
}

void from_text(benchmark::State& state, const std::string& name, Shader shader) {
  const auto texts = text_of(name);
  std::vector<std::uint64_t> memory;
  DrawResult drawn;
  for (auto _ : state) drawn = draw_job(job_of(flat_scene(texts)), shader, memory);
  if (drawn.status != DrawStatus::ok) state.SkipWithError("the core refuses the job");
  state.counters["dots"] = static_cast<double>(drawn.counters.dots);
}

double processor_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

bool has_at_most_two_quadrics(const IntegerBody& body) {
  return std::count_if(body.half_spaces.begin(), body.half_spaces.end(),
                       [](const IntegerHalfSpace& h) { return h.kind == HalfSpaceKind::quadric; }) <= 2;
}

void resolve_bodies(benchmark::State& state, const std::string& name) {
  const IntegerScene scene = flat_scene(text_of(name));
  IntegerScene alone = scene;
  std::vector<double> times;
  for (auto _ : state) {
    for (const IntegerBody& body : scene.bodies) {
      alone.bodies = {body};
      const double start = processor_milliseconds();
      benchmark::DoNotOptimize(resolve(alone).cells.data());
      if (has_at_most_two_quadrics(body)) times.push_back(processor_milliseconds() - start);
    }
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  state.counters["median_ms"] = *middle;
}

BENCHMARK_CAPTURE(draw_page, clover_knot, "clover_knot", true, Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, clover_knot_jordan, "clover_knot", true, Shader::jordan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, gear, "gear", true, Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, gear_jordan, "gear", true, Shader::jordan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, empty, "gear", false, Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_strides, clover_knot, "clover_knot")->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_strides, gear, "gear")->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(from_text, clover_knot, "clover_knot", Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(from_text, gear, "gear", Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(resolve_bodies, clover_knot, "clover_knot")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(resolve_bodies, gear, "gear")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace halfspace

BENCHMARK_MAIN();
