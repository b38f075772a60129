#include "host/cli/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <variant>

#include "host/cli/job_input.hpp"
#include "host/job/limits.hpp"

namespace halfspace {
namespace {

// One figure: its key in JSON, its words in the table.
struct Figure {
  const char* key;
  const char* words;
  std::variant<std::int64_t, double> value;
};

struct Table {
  const char* key;
  const char* title;
  std::vector<Figure> figures;
};

std::int64_t count(std::size_t n) { return static_cast<std::int64_t>(n); }

Table resolver_table(const Pipeline& p) {
  std::int64_t planes = 0, quadrics = 0, lines = 0, conics = 0, meetings = 0;
  for (const IntegerBody& body : p.scene.bodies) {
    for (const IntegerHalfSpace& h : body.half_spaces) ++(h.kind == HalfSpaceKind::plane ? planes : quadrics);
  }
  for (const Arc& arc : p.resolved.arcs) {
    const auto* curve = std::get_if<Curve>(&arc.form);
    ++(curve == nullptr ? meetings : is_line(*curve) ? lines : conics);
  }
  return {"resolver",
          "Resolver (table 7.1)",
          {{"bodies", "bodies", count(p.scene.bodies.size())},
           {"planes", "planar half-spaces, clipping planes included", planes},
           {"quadrics", "quadric half-spaces", quadrics},
           {"faces", "faces (sheets that can show)", count(p.resolved.faces.size())},
           {"linear_arcs", "linear arcs (show-edges)", lines},
           {"conic_arcs", "conic arcs (show-edges)", conics},
           {"meeting_arcs", "arcs where two quadrics meet", meetings},
           {"cells", "cells of faces between two arcs", count(p.resolved.cells.size())},
           {"line_spans", "single-line cells at exact vertices", count(p.resolved.spans.size())},
           {"job_bytes", "bytes of the job", count(p.job.bytes.size())},
           {"bound_dots", "bound of the silhouette's error, dots", p.scene.bound}}};
}

Table renderer_table(const DrawnPage& d) {
  const Counters& c = d.result.counters;
  return {"renderer",
          "Renderer and shader (table 7.2)",
          {{"scan_lines", "scan lines", std::int64_t{c.lines}},
           {"depth_samples", "depth calculations", std::int64_t{c.depth_samples}},
           {"exact_depths", "  of them settled exactly", std::int64_t{c.exact_depths}},
           {"face_inserts", "face inserts", std::int64_t{c.face_inserts}},
           {"edge_swaps", "swaps in the active list", std::int64_t{c.edge_swaps}},
           {"spans", "spans of one face", std::int64_t{c.spans}},
           {"intensities", "intensities of quadric faces", std::int64_t{c.intensities}},
           {"exact_levels", "  of them settled exactly", std::int64_t{c.exact_levels}},
           {"contour_dots", "dots of quadric faces levelled by contours", std::int64_t{c.contour_dots}},
           {"curved_faces", "quadric faces", std::int64_t{c.curved_faces}},
           {"crowded_faces", "  of them without room for contours", std::int64_t{c.crowded_faces}},
           {"level_spans", "device spans of one level", std::int64_t{c.level_spans}},
           {"dots", "shaded dots", std::int64_t{c.dots}},
           {"peak_spans", "spans of the fullest scan line", std::int64_t{d.result.peak_spans}},
           {"core_bytes", "RAM of the core, bytes (stack apart)", count(d.core_bytes)}}};
}

Table job_table(const DrawnPage& d) {
  return {"job",
          "Job",
          {{"job_bytes", "bytes of the job", count(d.job_bytes)},
           {"bound_dots", "bound of the silhouette's error, dots", bound_in_dots(d.header)}}};
}

double draw_ns_per_dot(const DrawnPage& d) {
  return 1e9 * d.seconds / std::max<double>(1, static_cast<double>(d.result.counters.dots));
}

Table time_table(const Pipeline& p, const DrawnPage& d) {
  const StageTimes& t = p.times;
  const double total = t.read + t.flatten + t.resolve + t.job + d.seconds;
  return {"seconds",
          "Processor seconds (table 7.3)",
          {{"reader", "reader", t.read},
           {"flattener_resolver", "flattener and resolver", t.flatten + t.resolve},
           {"job", "job writer, with the renderer's sweep in advance", t.job},
           {"draw", "renderer, shader, stipple and driver", d.seconds},
           {"total", "total", total},
           {"draw_ns_per_dot", "draw, nanoseconds per shaded dot", draw_ns_per_dot(d)}}};
}

Table time_table(const DrawnPage& d) {
  return {"seconds",
          "Processor seconds (table 7.3)",
          {{"draw", "job reader, renderer, shader, stipple and driver", d.seconds},
           {"draw_ns_per_dot", "draw, nanoseconds per shaded dot", draw_ns_per_dot(d)}}};
}

std::vector<Table> tables(const Pipeline* p, const DrawnPage& d) {
  if (p == nullptr) return {job_table(d), renderer_table(d), time_table(d)};
  return {resolver_table(*p), renderer_table(d), time_table(*p, d)};
}

std::string number(const Figure& figure) {
  if (const auto* whole = std::get_if<std::int64_t>(&figure.value)) return fmt::format("{}", *whole);
  return fmt::format("{:.6g}", std::get<double>(figure.value));
}

std::string as_text(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) {
    text += fmt::format("{}\n", table.title);
    for (const Figure& figure : table.figures) text += fmt::format("  {:<50} {:>14}\n", figure.words, number(figure));
  }
  return text;
}

std::string as_json(const std::vector<Table>& tables) {
  std::string text = "{";
  const char* between_tables = "\n";
  for (const Table& table : tables) {
    text += fmt::format("{}  \"{}\": {{", between_tables, table.key);
    const char* between = "\n";
    for (const Figure& figure : table.figures) {
      text += fmt::format("{}    \"{}\": {}", between, figure.key, number(figure));
      between = ",\n";
    }
    text += "\n  }";
    between_tables = ",\n";
  }
  return text + "\n}\n";
}

}  // namespace

ExitStatus write_statistics(const StatisticsRequest& request, const std::string& picture, const Pipeline* pipeline,
                            const DrawnPage& drawn) {
  if (!wanted(request)) return ExitStatus::drawn;
  const std::vector<Table> all = tables(pipeline, drawn);
  ExitStatus status = ExitStatus::drawn;
  if (request.table && picture == "-") fmt::print(stderr, "{}", as_text(all));
  if (request.table && picture != "-") status = write_text("-", as_text(all));
  if (status != ExitStatus::drawn || request.file.empty()) return status;
  return write_text(request.file, as_json(all));
}

}  // namespace halfspace
