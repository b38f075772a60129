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

// Gathers the pieces cell 0, root 0, cell 1, ... cell n in their order: runs of those that show.
class Runs {
 public:
  explicit Runs(int pieces) : last_piece_(pieces - 1) {}

  void add(bool shown) {
    if (shown && first_ == none) first_ = piece_;
    if (!shown) end_run();
    ++piece_;
  }

  std::vector<RowInterval> take() {
    end_run();
    return std::move(intervals_);
  }

 private:
  static constexpr int none = -1;

  void end_run() {
    if (first_ == none) return;
    const int last = piece_ - 1;
    RowInterval interval;
    interval.left_open = first_ % 2 == 0 && first_ > 0;
    interval.right_open = last % 2 == 0 && last < last_piece_;
    interval.left = first_ == 0 ? unbounded : (first_ - 1) / 2;
    interval.right = last == last_piece_ ? unbounded : last / 2;
    intervals_.push_back(interval);
    first_ = none;
  }

  int last_piece_;
  int piece_ = 0;
  int first_ = none;  // of the run
  std::vector<RowInterval> intervals_;
};

}  // namespace

std::vector<RowInterval> row_intervals(const std::vector<RowRoot>& roots, const PresenceOnLine& presence,
                                       std::uint32_t pole) {
  Runs runs(2 * static_cast<int>(roots.size()) + 1);
  bool left = presence.shows_at(sample(roots, 0));
  runs.add(left);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool right = presence.shows_at(sample(roots, i + 1));
    runs.add(!passes_through(roots[i], pole) && (left || right || presence.shows_at(roots[i].x)));
    runs.add(right);
    left = right;
  }
  return runs.take();
}

}  // namespace halfspace
