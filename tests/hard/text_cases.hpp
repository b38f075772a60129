// text_cases.hpp - the hard cases as scenes: tests/hard/scenes, one small file each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/flatten.hpp"
#include "host/scene/scene.hpp"

namespace halfspace::testing {

// The names of the files, sorted.
[[nodiscard]] const std::vector<std::string>& text_cases();

[[nodiscard]] std::string text_of(const std::string& name);

// A text and what became of it.
struct Flattened {
  Scene scene;
  IntegerScene integers;
  std::string refusal;  // the first error of parser or flattener
};

[[nodiscard]] Flattened flatten_text(const std::string& name, const std::string& text, std::int32_t width,
                                     std::int32_t height);

}  // namespace halfspace::testing
