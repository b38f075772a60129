#include <fmt/format.h>

#include "firmware/core/engine.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/job_input.hpp"
#include "host/cli/output_page.hpp"

namespace halfspace {
namespace {

std::string line(const char* what, const std::string& value) { return fmt::format("{:<28} {}\n", what, value); }

std::string needs_line(const JobNeeds& n) {
  return line("needs at once", fmt::format("{} faces, {} arcs of up to {} bytes, {} cells, {} spans a line", n.faces,
                                           n.arcs, n.arc_bytes, n.cells, n.spans));
}

std::string needs_text(const JobHeader& h, std::size_t job_bytes, std::int32_t band_rows) {
  std::string text = needs_line(h.needs);
  text += line("RAM of the core", fmt::format("{} bytes with bands of {} lines, {} with single lines",
                                              memory_needed(h, band_rows), band_rows, memory_needed(h, 1)));
  text += line("job", fmt::format("{} bytes", job_bytes));
  return text;
}

ExitStatus scene_info(const InfoRequest& request) {
  const PageChoice choice = choose_page(request.page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  const Pipeline p = make_job(request.scene, choice, true);
  if (p.status != ExitStatus::drawn) return p.status;
  const Scissor& s = p.scene.scissor;
  std::size_t planes = 0, quadrics = 0;
  for (const IntegerBody& body : p.scene.bodies) {
    for (const IntegerHalfSpace& h : body.half_spaces) ++(h.kind == HalfSpaceKind::plane ? planes : quadrics);
  }
  std::string text = line("device", fmt::format("{}, {} x {} dots, {} levels, {} dpi", choice.device->traits.name,
                                                choice.page.width, choice.page.height, choice.page.levels, choice.dpi));
  text += line("window", fmt::format("dots {}..{} x {}..{}", s.x0, s.x1, s.y0, s.y1));
  text += line("bodies", fmt::format("{} ({} planes, {} quadrics)", p.scene.bodies.size(), planes, quadrics));
  text += line("faces, arcs, cells", fmt::format("{}, {}, {}", p.resolved.faces.size(), p.resolved.arcs.size(),
                                                 p.resolved.cells.size() + p.resolved.spans.size()));
  text += line("silhouette bound", fmt::format("{:.3g} dot", p.scene.bound));
  text += needs_text(p.job.header, p.job.bytes.size(), choice.device->traits.preferred_band_rows);
  return write_text("-", text);
}

// What the host asked of the page, all of it from the header.
std::string page_text(const JobHeader& h) {
  constexpr const char* screens[] = {"clustered", "bayer", "blue-noise"};
  const bool bilevel = h.page.format == DotFormat::bilevel;
  std::string text = line("page", fmt::format("{} x {} dots, {}, {} levels, background {}", h.page.width, h.page.height,
                                              bilevel ? "bilevel" : "gray", h.page.levels, h.page.background));
  text += line("devices", devices_for(h.page));
  if (bilevel) text += line("screen", screens[static_cast<std::size_t>(h.screen)]);
  text += line("window", fmt::format("dots {}..{} x {}..{}", h.x0, h.x1, h.y0, h.y1));
  return text + line("silhouette bound", fmt::format("{:.3g} dot", bound_in_dots(h)));
}

std::string memory_text(const JobHeader& h) {
  std::string text;
  for (std::int32_t rows = 1; rows <= 64 && rows <= h.page.height; rows *= 2) {
    text += line(rows == 1 ? "RAM of the core" : "",
                 fmt::format("{:>8} bytes with {}", memory_needed(h, rows),
                             rows == 1 ? "single lines" : fmt::format("bands of {} lines", rows)));
  }
  return text;
}

class Nowhere final : public BandSink {
 public:
  bool put_band(const Band&) override { return true; }
};

// Every record is read, so that a damaged job is not vouched for.
ExitStatus sweep(JobInput& job) {
  Nowhere sink;
  std::vector<std::uint64_t> memory(memory_needed(job.header(), 1) / 8 + 1);
  const DrawResult result = draw(job.reader(), job.header(), sink, std::as_writable_bytes(std::span(memory)),
                                 {.shader = Shader::isqrt, .band_rows = 1, .measure = true}, all_modules);
  return job.verdict(result);
}

ExitStatus job_info(const InfoRequest& request) {
  const std::string& path = request.scene.paths.front();
  if (!request.page_option.empty()) {
    return fail(ExitStatus::command_line_wrong,
                fmt::format("{}: a job's page is settled; leave it out", request.page_option), path);
  }
  JobFile file(path);
  if (!file.is_open()) return ExitStatus::device_or_file_failed;
  JobInput job(file, file.name());
  if (!job.has_header()) return ExitStatus::device_or_file_failed;
  if (const ExitStatus status = sweep(job); status != ExitStatus::drawn) return status;
  const JobHeader& h = job.header();
  return write_text("-", page_text(h) + needs_line(h.needs) +
                             line("exact arithmetic", fmt::format("{} bits", h.needs.exact_bits)) + memory_text(h) +
                             line("job", fmt::format("{} bytes", job.bytes())));
}

}  // namespace

ExitStatus run_info(const InfoRequest& request) {
  const bool job =
      request.scene.paths.size() == 1 && request.scene.language.empty() && looks_like_job(request.scene.paths.front());
  return job ? job_info(request) : scene_info(request);
}

}  // namespace halfspace
