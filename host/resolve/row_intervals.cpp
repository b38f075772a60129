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

// May a constraint that fails left of the root hold at it, or on its right? Only where the root is on one of its curves, or on one where the
// sheet begins. What hides because the sheet is missing does so up to the latter.
bool may_change(int hider, const RowRoot& root, const BoundingCurves& bounds) {
  const auto is_of_hider = [hider](std::uint32_t constraint) { return static_cast<int>(constraint) == hider; };
  return std::any_of(root.curves.begin(), root.curves.end(),
                     [&](const CurveBranch& b) {
                       const TracedCurve& traced = bounds.curves[b.curve];
                       return traced.own ||
                              std::any_of(traced.constraints.begin(), traced.constraints.end(), is_of_hider);
                     }) ||
         std::any_of(root.quartics.begin(), root.quartics.end(),
                     [&](const QuarticBranch& b) { return is_of_hider(b.constraint); });
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

  RowIntervals take() {
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
  RowIntervals intervals_;
};

}  // namespace

RowIntervals row_intervals(const std::vector<RowRoot>& roots, const BoundingCurves& bounds,
                           const PresenceOnLine& presence, std::uint32_t pole) {
  Runs runs(2 * static_cast<int>(roots.size()) + 1);
  int left = presence.hider_at(sample(roots, 0));
  runs.add(left == nothing_hides);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool stays_hidden = left != nothing_hides && !may_change(left, roots[i], bounds);
    const int right = stays_hidden ? left : presence.hider_at(sample(roots, i + 1));
    const bool shows_beside = left == nothing_hides || right == nothing_hides;
    runs.add(!stays_hidden && !passes_through(roots[i], pole) &&
             (shows_beside || presence.hider_at(roots[i].x) == nothing_hides));
    runs.add(right == nothing_hides);
    left = right;
  }
  return runs.take();
}

}  // namespace halfspace
