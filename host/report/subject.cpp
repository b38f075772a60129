#include "host/report/subject.hpp"

#include <stdexcept>

#include "firmware/core/memory_source.hpp"
#include "host/flatten/flatten.hpp"
#include "host/report/callgrind_toggle.hpp"
#include "host/resolve/resolve.hpp"
#include "host/scene/parse.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t band_rows = 32;

class Nowhere final : public BandSink {
 public:
  bool put_band(const Band& band) override {
    const CallgrindToggle pause;                             // what a device makes of a band is not the core's cost
    asm volatile("" : : "r"(band.bytes.data()) : "memory");  // the bytes are wanted
    return true;
  }
};

class Collector final : public BandSink {
 public:
  bool put_band(const Band& band) override {
    dots.insert(dots.end(), band.bytes.begin(), band.bytes.end());
    return true;
  }
  std::vector<std::uint8_t> dots;
};

DrawResult draw_into(BandSink& sink, const JobResult& job, const ListedShader& shader,
                     std::vector<std::uint64_t>& memory) {
  memory.resize(memory_wanted(job.header, band_rows) / 8 + 1);
  MemorySource source(job.bytes);
  const DrawOptions options{.shader = shader.shader, .stride = shader.stride, .band_rows = band_rows, .measure = false};
  const CallgrindToggle counted;
  return draw(source, sink, std::as_writable_bytes(std::span(memory)), options, all_modules);
}

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    if (d.severity != Severity::warning) return format(d);
  }
  return "";
}

// `boxes`: for the oracle.
IntegerScene flat_scene(const SceneText& source, const PageSize& size, bool boxes, std::string& refusal) {
  const SourceText text{source.name, source.text};
  const ParseResult parsed = parse_uniquadrix(std::span(&text, 1));
  refusal = first_error(parsed.diagnostics);
  if (!refusal.empty()) return {};
  FlattenResult flat = flatten(parsed.scene, {size.width, size.height, size.levels, 1, 1, "", boxes});
  refusal = first_error(flat.diagnostics);
  return std::move(flat.scene);
}

JobResult page_job(const IntegerScene& scene, const ResolvedScene& resolved, DotFormat format, std::int32_t background,
                   bool measured = true) {
  return write_job(scene, resolved,
                   {.page = {scene.width, scene.height, format, scene.levels, background}, .measure = measured});
}

JobResult bilevel_job(const IntegerScene& scene, bool measured, std::string& refusal) {
  JobResult job = page_job(scene, resolve(scene), DotFormat::bilevel, scene.levels - 1, measured);
  if (refusal.empty()) refusal = first_error(job.diagnostics);
  return job;
}

std::vector<std::uint8_t> gray_dots(const IntegerScene& scene, const ResolvedScene& resolved, std::int32_t background,
                                    const ListedShader& shader) {
  std::vector<std::uint64_t> memory;
  Collector collector;
  const JobResult job = page_job(scene, resolved, DotFormat::gray, background);
  const DrawResult result = draw_into(collector, job, shader, memory);
  if (result.status != DrawStatus::ok) throw std::runtime_error("the core refuses a job of the report");
  return std::move(collector.dots);
}

}  // namespace

Subject make_subject(const SceneText& source, const PageSize& size) {
  Subject subject;
  subject.source = source;
  subject.size = size;
  subject.scene = flat_scene(source, size, true, subject.refusal);
  if (!subject.refusal.empty()) return subject;
  subject.job = bilevel_job(subject.scene, true, subject.refusal);
  IntegerScene empty = subject.scene;
  empty.bodies.clear();
  subject.empty_job = bilevel_job(empty, true, subject.refusal);
  return subject;
}

// As `halfspace render` does: without what only an oracle or a controller's memory asks for.
std::uint64_t draw_from_text(const SceneText& source, const PageSize& size, const ListedShader& shader) {
  std::string refusal;
  std::vector<std::uint64_t> memory;
  const IntegerScene scene = flat_scene(source, size, false, refusal);
  return draw_job(bilevel_job(scene, false, refusal), shader, memory);
}

std::uint64_t draw_job(const JobResult& job, const ListedShader& shader, std::vector<std::uint64_t>& memory) {
  Nowhere sink;
  return draw_into(sink, job, shader, memory).counters.dots;
}

std::uint32_t page_hash(const JobResult& job, const ListedShader& shader) {
  std::vector<std::uint64_t> memory;
  Collector collector;
  (void)draw_into(collector, job, shader, memory);
  std::uint32_t hash = 2166136261U;
  for (const std::uint8_t byte : collector.dots) hash = (hash ^ byte) * 16777619U;
  return hash;
}

// On black and on white: a dot that differs shows no face.
std::vector<std::int16_t> drawn_levels(const IntegerScene& scene, const ListedShader& shader) {
  const ResolvedScene resolved = resolve(scene);
  const std::vector<std::uint8_t> black = gray_dots(scene, resolved, 0, shader);
  const std::vector<std::uint8_t> white = gray_dots(scene, resolved, scene.levels - 1, shader);
  std::vector<std::int16_t> levels;
  for (std::size_t i = 0; i < black.size(); ++i) {
    levels.push_back(black[i] == white[i] ? static_cast<std::int16_t>(black[i]) : std::int16_t{-1});
  }
  return levels;
}

}  // namespace halfspace
