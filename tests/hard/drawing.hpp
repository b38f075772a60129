// drawing.hpp - an integer scene through resolver, job and core, resolved once for all shaders and levels; and what the exact oracle
// says of the same scan lines.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "firmware/core/engine.hpp"
#include "host/flatten/integer_scene.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace::testing {

inline constexpr std::array exact_shaders = {Shader::contour, Shader::isqrt,
                                             Shader::jordan};  // those that promise every dot

using Lines = std::vector<std::int32_t>;  // ascending

[[nodiscard]] Lines all_lines(const IntegerScene& scene);

// Row by row; -1 is background.
using Levels = std::vector<std::int16_t>;

// A picture beside the truth: either may be empty, both when every dot is right.
struct Comparison {
  std::string limit;  // that the scene exceeds, in words: nothing was drawn
  std::string wrong;  // the number of wrong dots, and the first; or what failed
};

class Drawing {
 public:
  explicit Drawing(const IntegerScene& scene);

  [[nodiscard]] const ResolvedScene& resolved() const { return resolved_; }

  // Also of the bilevel page with the gray one.
  [[nodiscard]] Comparison compare(std::int32_t levels, Shader shader, const Lines& lines, const Levels& truth);

 private:
  [[nodiscard]] Levels draw(DotFormat format, std::int32_t background, Shader shader, const Lines& lines,
                            Comparison& failure) const;
  [[nodiscard]] Levels halftone(const Levels& levels, const Lines& lines) const;

  IntegerScene scene_;
  ResolvedScene resolved_;
};

[[nodiscard]] Levels true_levels(IntegerScene scene, std::int32_t levels, const Lines& lines);

}  // namespace halfspace::testing
