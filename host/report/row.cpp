#include "host/report/row.hpp"

#include <fmt/format.h>

namespace halfspace {
namespace {

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : ""; }

std::string error_cells(const std::optional<PictureError>& error) {
  if (!error) return ",,,,,";
  return fmt::format("{},{:.4g},{:g},{},{:.4g},{:.4g}", error->wrong, error->level_mean, error->level_max,
                     error->wrong_outline, error->outline_mean, error->outline_max);
}

}  // namespace

std::string as_csv(const Rows& rows) {
  std::string text =
      "suite,scene,width,height,levels,renderer,shader,shaded_dots,ns_per_dot,text_ns_per_dot,instructions_per_dot,"
      "draw_instructions,wrong_dots,level_error_mean,level_error_max,wrong_outline_dots,outline_error_mean,"
      "outline_error_max\n";
  for (const Row& row : rows) {
    const std::string instructions = row.instructions ? std::to_string(*row.instructions) : "";
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.suite, row.scene, row.size.width,
                        row.size.height, row.size.levels, row.renderer, row.shader, row.shaded, cell(row.ns),
                        cell(row.text_ns), cell(row.instructions_per_dot()), instructions, error_cells(row.error));
  }
  return text;
}

}  // namespace halfspace
