// markdown.hpp - tables and numbers as a reader wants them.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "host/report/picture_error.hpp"

namespace halfspace {

using Cells = std::vector<std::string>;

[[nodiscard]] inline std::string table_line(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += fmt::format(" {} |", cell);
  line += '\n';
  return line;
}

[[nodiscard]] inline std::string table_head(const Cells& titles) {
  std::string rule = "|";
  for (std::size_t i = 0; i < titles.size(); ++i) rule += " --- |";
  return table_line(titles) + rule + "\n";
}

// Three significant digits; what was not measured is a dash.
[[nodiscard]] inline std::string figure(const std::optional<double>& value) {
  if (!value) return "-";
  return *value >= 100 || *value <= -100 ? fmt::format("{:.0f}", *value) : fmt::format("{:.3g}", *value);
}

// "0.123 (4)": the mean and the largest, in levels; "0" if no dot is wrong.
[[nodiscard]] inline std::string level_figure(const std::optional<PictureError>& error) {
  if (!error) return "-";
  return error->level_max == 0 ? "0" : fmt::format("{:.3g} ({:.0f})", error->level_mean, error->level_max);
}

// "12: 1.02 (1.41)": dots on the wrong side of an outline, and their distance from it in dots, mean and largest.
[[nodiscard]] inline std::string outline_figure(const std::optional<PictureError>& error) {
  if (!error) return "-";
  if (error->wrong_outline == 0) return "0";
  return fmt::format("{}: {:.3g} ({:.3g})", error->wrong_outline, error->outline_mean, error->outline_max);
}

}  // namespace halfspace
