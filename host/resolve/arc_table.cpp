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

std::uint32_t ArcTable::add_guide(const FormOnSheet& form) {
  guided_.push_back(form);
  return static_cast<std::uint32_t>(guided_.size() - 1);
}

void ArcTable::use(const ArcName& name, std::int32_t y0, std::int32_t y1) {
  if (name.curve != no_arc) runs_[name].push_back({y0, y1, no_arc});
}

void ArcTable::join_uses(std::uint32_t body, const Extent& extent, std::vector<Arc>& arcs) {
  std::map<std::uint32_t, ArcGuide> guides;
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
    runs.clear();
    for (const Run& run : joined) {
      for (Arc& arc : arcs_of(name, run, guides, extent)) {
        runs.push_back({arc.y0, arc.y1, static_cast<std::uint32_t>(arcs.size())});
        arc.body = body;
        arcs.push_back(std::move(arc));
      }
    }
  }
}

std::vector<Arc> ArcTable::arcs_of(const ArcName& name, const Run& run, std::map<std::uint32_t, ArcGuide>& guides,
                                   const Extent& extent) const {
  std::vector<Arc> arcs;
  if (!name.guided) {
    arcs.push_back({0, curve_of(name), name.branch, {}, run.y0, run.y1});
    return arcs;
  }
  ArcGuide& guide = guides.try_emplace(name.curve, guided_[name.curve], extent).first->second;
  const auto page_line = [this](std::int64_t y) { return static_cast<std::int32_t>(y + origin_y_); };
  for (GuidedRun& part : guide.runs(name.rank, run.y0 - origin_y_, run.y1 - origin_y_)) {
    for (Window& window : part.guide.windows) {
      window.y0 = page_line(window.y0);
      window.y1 = page_line(window.y1);
    }
    arcs.push_back({0, guide.form(), Branch::single, std::move(part.guide), page_line(part.y0), page_line(part.y1)});
  }
  return arcs;
}

ArcTable::Piece ArcTable::piece(const ArcName& name, std::int32_t y) const {
  if (name.curve == no_arc) return {};
  const std::vector<Run>& runs = runs_.at(name);
  const auto run = std::find_if(runs.begin(), runs.end(), [y](const Run& r) { return r.y0 <= y && y <= r.y1; });
  return {run->arc, run->y1};
}

Curve ArcTable::curve_of(const ArcName& name) const {
  Curve curve = curves_[name.curve];
  if (name.negated) curve = -1 * curve;
  curve.q[5] += name.shift;
  return curve;
}

}  // namespace halfspace
