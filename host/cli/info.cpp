#include <fmt/format.h>

#include "firmware/core/engine.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/output_page.hpp"

namespace halfspace {
namespace {

std::string line(const char* what, const std::string& value) { return fmt::format("{:<28} {}\n", what, value); }

std::string needs_text(const JobHeader& h, std::size_t job_bytes, std::int32_t band_rows) {
  const JobNeeds& n = h.needs;
  std::string text = line("needs at once", fmt::format("{} faces, {} arcs of up to {} bytes, {} cells, {} spans a line",
                                                       n.faces, n.arcs, n.arc_bytes, n.cells, n.spans));
  text += line("RAM of the core", fmt::format("{} bytes with bands of {} lines, {} with single lines",
                                              memory_needed(h, band_rows), band_rows, memory_needed(h, 1)));
  text += line("job", fmt::format("{} bytes", job_bytes));
  return text;
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

}  // namespace halfspace
