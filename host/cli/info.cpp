#include <fmt/core.h>

#include "firmware/core/engine.hpp"
#include "host/cli/commands.hpp"

namespace halfspace {
namespace {

void print_line(const char* what, const std::string& value) { fmt::print("{:<28} {}\n", what, value); }

void print_needs(const JobHeader& h, std::size_t job_bytes, std::int32_t band_rows) {
  const JobNeeds& n = h.needs;
  print_line("needs at once", fmt::format("{} faces, {} arcs of up to {} bytes, {} cells, {} spans a line", n.faces,
                                          n.arcs, n.arc_bytes, n.cells, n.spans));
  print_line("RAM of the core", fmt::format("{} bytes with bands of {} lines, {} with single lines",
                                            memory_needed(h, band_rows), band_rows, memory_needed(h, 1)));
  print_line("job", fmt::format("{} bytes", job_bytes));
}

}  // namespace

ExitStatus run_info(const InfoRequest& request) {
  const PageChoice choice = choose_page(request.page);
  if (choice.status != ExitStatus::drawn) return choice.status;
  const Pipeline p = make_job(request.scene, choice, true);
  if (p.status != ExitStatus::drawn) return p.status;
  const Scissor& s = p.scene.scissor;
  std::size_t planes = 0, quadrics = 0;
  for (const IntegerBody& body : p.scene.bodies) {
    for (const IntegerHalfSpace& h : body.half_spaces) ++(h.kind == HalfSpaceKind::plane ? planes : quadrics);
  }
  print_line("device", fmt::format("{}, {} x {} dots, {} levels, {} dpi", choice.device->traits.name, choice.page.width,
                                   choice.page.height, choice.page.levels, choice.dpi));
  print_line("window", fmt::format("dots {}..{} x {}..{}", s.x0, s.x1, s.y0, s.y1));
  print_line("bodies", fmt::format("{} ({} planes, {} quadrics)", p.scene.bodies.size(), planes, quadrics));
  print_line("faces, arcs, cells", fmt::format("{}, {}, {}", p.resolved.faces.size(), p.resolved.arcs.size(),
                                               p.resolved.cells.size() + p.resolved.spans.size()));
  print_line("silhouette bound", fmt::format("{:.3g} dot", p.scene.bound));
  print_needs(p.job.header, p.job.bytes.size(), choice.device->traits.preferred_band_rows);
  return ExitStatus::drawn;
}

}  // namespace halfspace
