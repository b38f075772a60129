#include "host/resolve/arc_table.hpp"

#include <algorithm>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {

std::uint32_t ArcTable::curve_index(const Curve& curve) {
  const auto same = [&curve](const Curve& q) { return same_curve(curve, q); };
  const auto found = std::find_if(curves_.begin(), curves_.end(), same);
  if (found == curves_.end()) {
    curves_.push_back(curve);
    return static_cast<std::uint32_t>(curves_.size() - 1);
  }
  return static_cast<std::uint32_t>(found - curves_.begin());
}

void ArcTable::use(const ArcName& name, std::int32_t y0, std::int32_t y1) {
  if (name.curve != no_arc) runs_[name].push_back({y0, y1, no_arc});
}

void ArcTable::join_uses(std::uint32_t body, std::vector<Arc>& arcs) {
  for (auto& [name, runs] : runs_) {
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.y0 < b.y0; });
    std::vector<Run> joined;
    for (const Run& run : runs) {
      if (!joined.empty() && run.y0 <= joined.back().y1 + 1) {
        joined.back().y1 = std::max(joined.back().y1, run.y1);
      } else {
        joined.push_back(run);
      }
    }
    for (Run& run : joined) {
      run.arc = static_cast<std::uint32_t>(arcs.size());
      arcs.push_back({body, curve_of(name), name.branch, {}, run.y0, run.y1});
    }
    runs = std::move(joined);
  }
}

std::uint32_t ArcTable::arc(const ArcName& name, std::int32_t y) const {
  if (name.curve == no_arc) return no_arc;
  for (const Run& run : runs_.at(name)) {
    if (run.y0 <= y && y <= run.y1) return run.arc;
  }
  return no_arc;
}

Curve ArcTable::curve_of(const ArcName& name) const {
  Curve curve = curves_[name.curve];
  if (name.negated) curve = -1 * curve;
  curve.q[5] += name.shift;
  return curve;
}

}  // namespace halfspace
