// row.hpp - one line of a report: a scene on a page, drawn by one program in one way, with its speed and its error.
// Speed   Of shaded dots, net of the same page without bodies. An empty value was not measured.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/picture_error.hpp"
#include "host/report/subject.hpp"

namespace halfspace {

struct Row {
  std::string suite, scene, renderer, shader;
  PageSize size;
  std::uint64_t shaded = 0;  // dots
  std::optional<double> ns = {},
                        text_ns = {};  // a dot: a ready job (of others: the whole program); from the text to the page
  std::optional<std::uint64_t> instructions = {};  // of halfspace::draw
  std::uint64_t empty_instructions = 0;            // of them on the page without bodies
  std::optional<PictureError> error = {};

  [[nodiscard]] std::optional<double> instructions_per_dot() const {
    if (!instructions || shaded == 0) return std::nullopt;
    return (static_cast<double>(*instructions) - static_cast<double>(empty_instructions)) / static_cast<double>(shaded);
  }
};

using Rows = std::vector<Row>;

[[nodiscard]] std::string as_csv(const Rows& rows);

}  // namespace halfspace
