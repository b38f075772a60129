#include "host/report/plots.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>

#include "host/report/child.hpp"
#include "host/report/files.hpp"

namespace halfspace {
namespace {

constexpr const char* style =
    "set terminal svg size 900,400 font 'sans-serif,12' background '#ffffff'\n"
    "set grid lc rgb '#dddddd'\nset key off\n";

// A gnuplot data block.
std::string block(const std::string& name, const std::string& lines) {
  return "$" + name + " << END\n" + lines + "END\n";
}

std::string label(const Row& row) { return row.shader.empty() ? row.renderer : row.shader; }

double share_wrong(const Row& row) {
  return 100.0 * static_cast<double>(row.error->wrong) / static_cast<double>(row.shaded);
}

using Cost = std::function<std::optional<double>(const Row&)>;

// "x wrong mean label" of the rows of one whole scene.
std::string error_points(const Rows& rows, const std::string& scene, const Cost& cost) {
  std::string lines;
  for (const Row& row : rows) {
    const auto x = cost(row);
    if (row.suite != "whole" || row.scene != scene || !row.error || !x) continue;
    lines += fmt::format("{} {} {} \"{}\"\n", *x, share_wrong(row), row.error->level_mean, label(row));
  }
  return lines;
}

std::string panel(const std::string& title, int column) {
  const auto part = [column](const char* data, const char* mark) {
    return fmt::format(
        "${0} using 1:{1} with points pt {2} ps 0.8 title '{0}', ${0} using 1:{1}:4 with labels left "
        "offset 0.6,0.5 font ',9' notitle",
        data, column, mark);
  };
  return fmt::format("set title '{}'\nplot {}, {}\n", title, part("knot", "7"), part("gear", "5"));
}

std::string error_plot(const Rows& rows, const std::string& cost_name, const Cost& cost) {
  const std::string knot = error_points(rows, "clover_knot", cost), gear = error_points(rows, "gear", cost);
  if (knot.empty() || gear.empty()) return "";
  return block("knot", knot) + block("gear", gear) + "set logscale x\nset xlabel '" + cost_name +
         " a shaded dot'\nset yrange [0:*]\nset offsets graph 0.02, graph 0.25, graph 0.1, 0\nset multiplot layout "
         "1,2\n"
         "set key top right\n" +
         panel("dots of a wrong level, %", 2) + "set key off\n" + panel("error of the level, mean, levels of 65", 3) +
         "unset multiplot\n";
}

std::string resolution_plot(const Rows& rows) {
  std::map<std::string, std::string> curves;
  for (const Row& row : rows) {
    if (row.suite != "resolution" || !row.instructions) continue;
    curves[row.scene + ", " + row.shader] += fmt::format("{} {}\n", row.size.width, *row.instructions);
  }
  if (curves.empty()) return "";
  std::string blocks, plot;
  for (const auto& [name, lines] : curves) {
    const std::string data = fmt::format("curve{}", std::count(plot.begin(), plot.end(), '\n'));
    blocks += block(data, lines);
    plot += fmt::format("{}${} using 1:2 with linespoints pt 7 ps 0.5 title '{}'", plot.empty() ? "plot " : ", \\\n",
                        data, name);
  }
  return blocks +
         "set logscale xy\nset xlabel 'dots a side'\nset ylabel 'instructions of the core'\nset key outside right\n" +
         plot + "\n";
}

std::string draw(const std::string& script, const std::string& path) {
  if (script.empty()) return "";
  const ReportScratch scratch;
  const std::string file = scratch / "plot.gp";
  write_file(file, style + script);
  const ChildResult child = run_child({"gnuplot", file}, "", scratch / "plot.svg");
  if (!child.ok()) return "gnuplot failed, and " + path + " is left out";
  write_file(path, read_file(scratch / "plot.svg"));
  return "";
}

}  // namespace

std::string write_plots(const Rows& rows, const std::string& folder) {
  if (!has_program("gnuplot")) return "gnuplot is missing, and the plots are left out: apt-get install gnuplot-nox";
  std::string why = draw(error_plot(rows, "ns", [](const Row& row) { return row.ns; }), folder + "/error.svg");
  if (!why.empty()) return why;
  const auto instructions = [](const Row& row) {
    return row.shader.empty() ? std::nullopt : row.instructions_per_dot();
  };
  why = draw(error_plot(rows, "instructions", instructions), folder + "/instructions.svg");
  return why.empty() ? draw(resolution_plot(rows), folder + "/resolution.svg") : why;
}

}  // namespace halfspace
