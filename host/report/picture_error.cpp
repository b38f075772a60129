#include "host/report/picture_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace halfspace {
namespace {

class Kinds {
 public:
  Kinds(std::span<const std::int16_t> levels, std::int32_t width)
      : levels_(levels), width_(width), height_(static_cast<std::int32_t>(levels.size()) / width) {}

  // To the nearest dot that shows a face, or none, in growing squares: what lies on the square of side 2 r + 1 is at least
  // r away.
  [[nodiscard]] double distance(std::int32_t x, std::int32_t y, bool face) const {
    double best = farthest_outline;
    for (std::int32_t r = 1; r < best; ++r) {
      for (std::int32_t along = -r; along <= r; ++along) {
        const bool near = is(x + along, y - r, face) || is(x + along, y + r, face) || is(x - r, y + along, face) ||
                          is(x + r, y + along, face);
        if (near) best = std::min(best, std::hypot(r, along));
      }
    }
    return best;
  }

 private:
  [[nodiscard]] bool is(std::int32_t x, std::int32_t y, bool face) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    return (levels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] >=
            0) == face;
  }

  std::span<const std::int16_t> levels_;
  std::int32_t width_, height_;
};

}  // namespace

PictureError picture_error(std::span<const std::int16_t> drawn, std::span<const std::int16_t> truth,
                           std::int32_t width) {
  PictureError error;
  const Kinds kinds(truth, width);
  double levels = 0, outlines = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] >= 0) ++error.shaded;
    if (drawn[i] == truth[i]) continue;
    ++error.wrong;
    if ((drawn[i] >= 0) != (truth[i] >= 0)) {
      const auto dot = static_cast<std::int32_t>(i);
      const double far = kinds.distance(dot % width, dot / width, drawn[i] >= 0);
      ++error.wrong_outline;
      outlines += far;
      error.outline_max = std::max(error.outline_max, far);
    } else {
      const double off = std::abs(drawn[i] - truth[i]);
      levels += off;
      error.level_max = std::max(error.level_max, off);
    }
  }
  error.level_mean = levels / std::max<double>(1, static_cast<double>(error.shaded));
  error.outline_mean = outlines / std::max<double>(1, static_cast<double>(error.wrong_outline));
  return error;
}

}  // namespace halfspace
