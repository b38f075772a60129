#include "host/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "host/report/child.hpp"
#include "host/report/files.hpp"

namespace halfspace {
namespace {

constexpr const char* style =
    "set terminal svg size 900,700 font 'sans-serif,12' background '#ffffff' noenhanced\n"
    "set grid lc rgb '#dddddd'\nset key off\n";

// A gnuplot data block.
std::string block(const std::string& name, const std::string& lines) {
  return fmt::format("${} << END\n{}END\n", name, lines);
}

using Cost = std::function<std::optional<double>(const Row&)>;

// One block a point, "cost wrong mean", and what a panel needs to show column `column` of them, a colour a program.
std::string error_blocks(const Rows& rows, const std::string& scene, const Cost& cost, std::string (&panels)[2]) {
  std::string blocks;
  int count = 0;
  for (const Row& row : rows) {
    const auto x = cost(row);
    if (row.suite != "whole" || row.scene != scene || !row.error || !x || *x <= 0) continue;
    const double wrong = 100.0 * static_cast<double>(row.error->wrong) / static_cast<double>(row.shaded);
    const std::string data = fmt::format("{}{}", scene, count++);
    blocks += block(data, fmt::format("{} {} {}\n", *x, wrong, row.error->level_mean));
    for (int i = 0; i < 2; ++i) {
      panels[i] += fmt::format("{} ${} using 1:{} with points pt {} ps 1.2 lw 2 title '{}'", count == 1 ? "plot" : ",",
                               data, i + 2, count, row.shader.empty() ? row.renderer : row.shader);
    }
  }
  return blocks;
}

// Two panels for each of two scenes. Room is left for the key on the right.
std::string error_plot(const Rows& rows, const std::string& cost_name, const Cost& cost) {
  std::string blocks, plots;
  for (const std::string scene : {"clover_knot", "gear"}) {
    std::string panels[2];
    const std::string points = error_blocks(rows, scene, cost, panels);
    if (points.empty()) return "";
    blocks += points;
    plots += fmt::format(
        "set title '{0}: dots of a wrong level, %'\n{1}\nset title '{0}: mean error of the level, of 65'\n{2}\n", scene,
        panels[0], panels[1]);
  }
  return blocks + "set logscale x\nset xlabel '" + cost_name +
         " a shaded dot'\nset yrange [0:*]\nset key top right\nset offsets graph 0.05, graph 0.15, graph 0.05, 0\n"
         "set multiplot layout 2,2\n" +
         plots + "unset multiplot\n";
}

// A panel a scene, a curve a shader in the order of the rows.
std::string resolution_plot(const Rows& rows) {
  std::map<std::string, std::map<std::string, std::string>> curves;
  std::vector<std::string> shaders;
  for (const Row& row : rows) {
    if (row.suite != "resolution" || !row.instructions) continue;
    if (std::find(shaders.begin(), shaders.end(), row.shader) == shaders.end()) shaders.push_back(row.shader);
    curves[row.scene][row.shader] += fmt::format("{} {}\n", row.size.width, *row.instructions);
  }
  if (curves.empty()) return "";
  std::string blocks, panels;
  for (const auto& [scene, of_scene] : curves) {
    std::string plot;
    for (std::size_t i = 0; i < shaders.size(); ++i) {
      const std::string data = fmt::format("{}{}", scene, i);
      blocks += block(data, of_scene.at(shaders[i]));
      plot += fmt::format("{} ${} using 1:2 with linespoints pt 7 ps 0.5 title '{}'", i == 0 ? "plot" : ",", data,
                          shaders[i]);
    }
    panels += fmt::format("set title '{}'\n{}\n", scene, plot);
  }
  return blocks +
         "set logscale xy\nset format y '10^%L'\nset xlabel 'dots a side'\nset ylabel 'instructions of the core'\n"
         "set key top left\nset multiplot layout 1,2\n" +
         panels + "unset multiplot\n";
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
