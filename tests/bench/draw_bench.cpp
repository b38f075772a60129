// draw_bench - how long the core takes for a gray page: job in memory, bands to nowhere, one thread.
// `dots` counts the dots that show a face; the page without its bodies is measured beside it, to be taken off.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "firmware/core/engine.hpp"
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

JobResult job_of(const std::string& name, bool with_bodies) {
  const std::string path = std::string(HALFSPACE_SOURCE_DIR) + "/scenes/" + name + ".uq";
  std::ifstream file(path);
  const std::array<SourceText, 1> texts{{{path, {std::istreambuf_iterator<char>(file), {}}}}};
  const ParseResult parsed = parse_uniquadrix(texts);
  stop_on_errors(parsed.diagnostics);
  FlattenOptions options;
  options.width = page.width;
  options.height = page.height;
  options.levels = page.levels;
  FlattenResult flat = flatten(parsed.scene, options);
  stop_on_errors(flat.diagnostics);
  if (!with_bodies) flat.scene.bodies.clear();
  const ResolveResult resolved = resolve(flat.scene);
  stop_on_errors(resolved.diagnostics);
  JobResult job = write_job(flat.scene, resolved.scene, {.page = page});
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

void draw_page(benchmark::State& state, const std::string& name, bool with_bodies, Shader shader) {
  const JobResult job = job_of(name, with_bodies);
  std::vector<std::uint64_t> memory(memory_needed(job.header, band_rows) / 8 + 1);
  const auto draw_once = [&] {
    MemorySource source(job.bytes);
    Nowhere sink;
    return draw(source, sink, std::as_writable_bytes(std::span(memory)),
                {.shader = shader, .band_rows = band_rows, .measure = false}, all_modules);
  };
  const DrawResult counted = draw_once();
  if (counted.status != DrawStatus::ok) state.SkipWithError("the core refuses the job");
  for (auto _ : state) benchmark::DoNotOptimize(draw_once().status);
  state.counters["dots"] = static_cast<double>(counted.counters.dots);
}

BENCHMARK_CAPTURE(draw_page, clover_knot, "clover_knot", true, Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, clover_knot_jordan, "clover_knot", true, Shader::jordan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, gear, "gear", true, Shader::isqrt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, gear_jordan, "gear", true, Shader::jordan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_page, empty, "gear", false, Shader::isqrt)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace halfspace

BENCHMARK_MAIN();
