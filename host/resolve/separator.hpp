// separator.hpp - straight lines between two curves, in 2^-16 dots: guessed in floating point, checked exactly where they start.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "host/resolve/line_root.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

inline constexpr long separator_unit = 1 << 16;

// On a column of dots; columns far beyond any page count as the last of them.
[[nodiscard]] std::optional<Separator> dot_separator(const mpz_class& column);

// What lies left and right on up to three scan lines, the first of them the window's first.
class Channel {
 public:
  // Keeps pointers to the first line's roots.
  void add(std::int64_t y, const LineRoot& left, const LineRoot& right);

  // A line that runs between the samples, if there is one.
  [[nodiscard]] std::optional<Separator> separator() const;

  // Is it between left and right on the first line? Exact.
  [[nodiscard]] bool holds(const Separator& separator) const;

 private:
  struct Sample {
    double y = 0, low = 0, high = 0;
  };
  struct Ends {
    const LineRoot* left = nullptr;
    const LineRoot* right = nullptr;
  };
  std::array<Sample, 3> samples_{};
  std::size_t count_ = 0;
  Ends first_;
};

}  // namespace halfspace
