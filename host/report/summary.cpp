#include "host/report/summary.hpp"

#include <algorithm>
#include <map>

#include "host/report/board_summary.hpp"
#include "host/report/markdown.hpp"

namespace halfspace {
namespace {

// What the project set out to reach, as ratios of whole scenes.
struct Aim {
  const char* renderer;
  const char* scene;  // how it begins; "" is any
  double run, text;
};
constexpr Aim aims[] = {{"POV-Ray", "", 100, 20}, {"Raster3D", "30", 20, 10}, {"Raster3D", "", 5, 2}};

const Aim& aim_of(const Row& other) {
  return *std::find_if(std::begin(aims), std::end(aims), [&](const Aim& aim) {
    return other.renderer.starts_with(aim.renderer) && other.scene.starts_with(aim.scene);
  });
}

// The measured processors' names and versions in one paragraph.
std::string origin(const Findings& found) {
  const Environment& e = found.environment;
  return fmt::format(
      "Made by `halfspace report` on {}: {}, {}, commit {}; POV-Ray {}, Raster3D {}, valgrind {}, QEMU {}.\n"
      "One thread. Times are processor time, the median of several runs, and compare only within one report; "
      "instructions are "
      "callgrind's, inside\n`halfspace::draw`. Both are a shaded dot's share, net of the same page without bodies. "
      "Errors "
      "are against the exact oracle (`tests/oracle`).\nEvery row is in [results.csv](results.csv).\n",
      e.date, e.processor, e.compiler, e.commit, e.povray, e.raster3d, e.valgrind, e.qemu);
}

std::string gaps(const Findings& found) {
  std::string text;
  for (const std::string& gap : found.gaps) text += fmt::format("\n**Left out.** {}\n", gap);
  return text;
}

// --- whole scenes

bool same_picture(const Row& one, const Row& two) {
  return one.suite == two.suite && one.scene == two.scene && one.size.width == two.size.width;
}

std::vector<const Row*> beside(const Rows& rows, const Row& picture) {
  std::vector<const Row*> found;
  for (const Row& row : rows) {
    if (same_picture(row, picture)) found.push_back(&row);
  }
  return found;
}

// What answers the aims: what a user gets who asks for nothing, and contours alone.
bool answers_aims(const Row& row) { return (row.shader == "auto" || row.shader == "contour") && row.error->wrong == 0; }

std::string ratio(double theirs, double ours, double aim) { return fmt::format("{:.1f} ({:.0f})", theirs / ours, aim); }

std::string answers(const Rows& rows) {
  std::string text = "\n## Whole scenes\n\nHow many times faster, no dot wrong; in brackets what was aimed at.\n\n" +
                     table_head({"scene", "page", "beside", "shader", "`run` of a ready job", "from text to page"});
  for (const Row& other : rows) {
    if (!other.shader.empty()) continue;
    const Aim& aim = aim_of(other);
    for (const Row* own : beside(rows, other)) {
      if (!answers_aims(*own)) continue;
      text += table_line({other.scene, fmt::format("{} x {}", other.size.width, other.size.height), other.renderer,
                          own->shader, ratio(*other.ns, *own->ns, aim.run),
                          ratio(*other.text_ns, *own->text_ns, aim.text)});
    }
  }
  return text;
}

Cells whole_cells(const Row& row) {
  const std::string name = row.shader.empty() ? row.renderer : row.shader;
  const double wrong =
      static_cast<double>(row.error->wrong) / static_cast<double>(std::max<std::uint64_t>(1, row.shaded));
  return {name,
          row.shader.empty() ? "-" : figure(row.ns),
          figure(row.text_ns),
          row.shader.empty() ? "-" : figure(row.instructions_per_dot()),
          row.error->wrong == 0 ? "0" : fmt::format("{} ({:.2g} %)", row.error->wrong, 100 * wrong),
          level_figure(row.error),
          outline_figure(row.error)};
}

std::string whole_scenes(const Findings& found) {
  std::string text;
  const Row* last = nullptr;
  for (const Row& first : found.rows) {
    if (first.suite != "whole" || first.shader.empty() || (last != nullptr && same_picture(first, *last))) continue;
    last = &first;
    text += fmt::format("\n### {}: {} x {}, {} levels, {} shaded dots\n\n", first.scene, first.size.width,
                        first.size.height, first.size.levels, first.shaded);
    text += table_head({"", "ready job, ns", "from text, ns", "instructions", "wrong dots", "level error, mean (max)",
                        "outline: dots, mean (max) distance"});
    for (const Row* row : beside(found.rows, first)) text += table_line(whole_cells(*row));
  }
  return text + fmt::format(
                    "\nThe floor, filling all dots of a page with stipple words and nothing else, is {:.3g} ns a dot "
                    "of the page.\n",
                    found.floor_ns);
}

// --- suites

struct Sum {
  double pictures = 0, shaded = 0, wrong = 0, levels = 0, level_max = 0, instructions = 0, ns = 0;

  void add(const Row& row) {
    const auto dots = static_cast<double>(row.shaded);
    pictures += 1;
    shaded += dots;
    wrong += static_cast<double>(row.error->wrong);
    levels += row.error->level_mean * dots;
    level_max = std::max(level_max, row.error->level_max);
    instructions += row.instructions_per_dot().value_or(0) * dots;
    ns += row.ns.value_or(0) * dots;
  }
};

std::string suite(const Rows& rows, const std::string& name, const std::string& title) {
  std::map<std::pair<int, std::string>, Sum> sums;  // by levels and shader
  std::vector<std::string> shaders;
  for (const Row& row : rows) {
    if (row.suite != name) continue;
    sums[{row.size.levels, row.shader}].add(row);
    if (std::find(shaders.begin(), shaders.end(), row.shader) == shaders.end()) shaders.push_back(row.shader);
  }
  std::string text = "\n## " + title + "\n\n" +
                     table_head({"levels", "shader", "pictures", "shaded dots", "ns", "instructions", "wrong dots",
                                 "level error, mean (max)"});
  for (auto at = sums.begin(); at != sums.end();) {
    const int levels = at->first.first;
    for (const std::string& shader : shaders) {
      const Sum& s = sums[{levels, shader}];
      const double dots = std::max(1.0, s.shaded);
      const PictureError error{.level_mean = s.levels / dots, .level_max = s.level_max};
      text +=
          table_line({std::to_string(levels), shader, figure(s.pictures), figure(s.shaded), figure(s.ns / dots),
                      s.instructions == 0 ? "-" : figure(s.instructions / dots), figure(s.wrong), level_figure(error)});
    }
    at = sums.upper_bound({levels, "\xff"});
  }
  return text;
}

// --- resolution

struct Growth {
  std::vector<double> sides, counts, net;
  std::uint64_t wrong = 0;
};

double last_ratio(const std::vector<double>& values) {
  return values.size() < 2 ? 0 : values.back() / values[values.size() - 2];
}

std::string resolution(const Rows& rows) {
  std::map<std::string, Growth> curves;
  std::vector<std::string> order;
  for (const Row& row : rows) {
    if (row.suite != "resolution" || !row.instructions) continue;
    const std::string name = row.scene + " | " + row.shader;
    if (!curves.contains(name)) order.push_back(name);
    Growth& curve = curves[name];
    curve.sides.push_back(row.size.width);
    curve.counts.push_back(static_cast<double>(*row.instructions));
    curve.net.push_back(static_cast<double>(*row.instructions - row.empty_instructions));
    curve.wrong += row.error->wrong;
  }
  if (order.empty()) return "";
  std::string text =
      "\n## Cost against resolution\n\n![Instructions against resolution](resolution.svg)\n\nInstructions of "
      "`halfspace::draw` "
      "for a square page, and the exponent of the resolution that fits them: 2 is the area, 1 the\noutline. The last "
      "doubling "
      "is to be at most 2.3 by contours.\n\n";
  Cells titles{"scene", "shader"};
  for (const double side : curves[order[0]].sides) titles.push_back(fmt::format("{:.0f} dots a side", side));
  titles.insert(titles.end(), {"exponent", "last doubling", "net of the empty page", "wrong dots"});
  text += table_head(titles);
  for (const std::string& name : order) {
    const Growth& curve = curves[name];
    Cells cells{name};
    for (const double count : curve.counts) cells.push_back(fmt::format("{:.4g} M", count / 1e6));
    cells.insert(cells.end(), {fmt::format("{:.2f}", fitted_exponent(curve.sides, curve.counts)),
                               fmt::format("{:.2f}", last_ratio(curve.counts)),
                               fmt::format("{:.2f}", last_ratio(curve.net)), std::to_string(curve.wrong)});
    text += table_line(cells);
  }
  return text;
}

}  // namespace

std::string summary(const Findings& found) {
  return "# Speed against error\n\n" + origin(found) + gaps(found) + answers(found.rows) +
         "\n![Speed against error](error.svg)\n" + whole_scenes(found) +
         suite(found.rows, "gallery", "The gallery (`scenes/`)") +
         suite(found.rows, "hard", "The hard cases (`tests/hard/scenes/`)") + resolution(found.rows) +
         board_summary(found.board) + resolver_summary(found.resolver);
}

}  // namespace halfspace
