#include "host/resolve/row_intervals.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// A point of the open cell left of root i.
RowPoint sample(const std::vector<RowRoot>& roots, std::size_t i) {
  if (roots.empty()) return RowPoint(0.0);
  if (i == 0) return point_below(roots.front().x);
  if (i == roots.size()) return point_above(roots.back().x);
  return point_between(roots[i - 1].x, roots[i].x);
}

bool passes_through(const RowRoot& root, std::uint32_t curve) {
  return std::any_of(root.curves.begin(), root.curves.end(),
                     [curve](const CurveBranch& b) { return b.curve == curve; });
}

// Cell 0, root 0, cell 1, ... cell n: does each show?
std::vector<bool> shown_pieces(const std::vector<RowRoot>& roots, std::int64_t y, const SheetPresence& presence,
                               std::uint32_t pole) {
  std::vector<bool> shown(2 * roots.size() + 1);
  for (std::size_t i = 0; i <= roots.size(); ++i) {
    shown[2 * i] = presence.shows_at(sample(roots, i), y);
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (passes_through(roots[i], pole)) continue;
    shown[2 * i + 1] = shown[2 * i] || shown[2 * i + 2] || presence.shows_at(roots[i].x, y);
  }
  return shown;
}

}  // namespace

std::vector<RowInterval> row_intervals(const std::vector<RowRoot>& roots, std::int64_t y, const SheetPresence& presence,
                                       std::uint32_t pole) {
  const std::vector<bool> shown = shown_pieces(roots, y, presence, pole);
  std::vector<RowInterval> intervals;
  const int pieces = static_cast<int>(shown.size());
  for (int first = 0; first < pieces; ++first) {
    if (!shown[first]) continue;
    int last = first;
    while (last + 1 < pieces && shown[last + 1]) ++last;
    RowInterval interval;
    interval.left_open = first % 2 == 0 && first > 0;
    interval.right_open = last % 2 == 0 && last < pieces - 1;
    interval.left = first == 0 ? unbounded : (first - 1) / 2;
    interval.right = last == pieces - 1 ? unbounded : last / 2;
    intervals.push_back(interval);
    first = last;
  }
  return intervals;
}

}  // namespace halfspace
