#include "host/resolve/arc_table.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {

void ArcTable::start_body(std::int64_t origin_y) {
  origin_y_ = origin_y;
  curves_.clear();
  guided_.clear();
  uses_.clear();
  runs_.clear();
}

std::uint32_t ArcTable::curve_index(const Curve& curve) {
  const auto same = [&curve](const Curve* q) { return same_curve(curve, *q); };
  const auto found = std::find_if(curves_.begin(), curves_.end(), same);
  if (found == curves_.end()) {
    curves_.push_back(&curve);
    return static_cast<std::uint32_t>(curves_.size() - 1);
  }
  return static_cast<std::uint32_t>(found - curves_.begin());
}

std::uint32_t ArcTable::add_guide(const FormOnSheet& form) {
  guided_.push_back(form);
  return static_cast<std::uint32_t>(guided_.size() - 1);
}

void ArcTable::use(const ArcName& name, std::int32_t y0, std::int32_t y1) {
  if (name.curve != no_arc) uses_.push_back({name, y0, y1, no_arc});
}

void ArcTable::join_uses(std::uint32_t body, const DotExtent& extent, std::vector<Arc>& arcs) {
  std::sort(uses_.begin(), uses_.end(),
            [](const Run& a, const Run& b) { return std::tie(a.name, a.y0) < std::tie(b.name, b.y0); });
  std::map<std::uint32_t, ArcGuide> guides;
  for (std::size_t i = 0; i < uses_.size();) {
    Run joined = uses_[i];
    for (++i; i < uses_.size() && uses_[i].name == joined.name && uses_[i].y0 <= joined.y1 + 1; ++i) {
      joined.y1 = std::max(joined.y1, uses_[i].y1);
    }
    const std::size_t first = arcs.size();
    append_arcs(joined, guides, extent, arcs);
    for (std::size_t k = first; k < arcs.size(); ++k) {
      arcs[k].body = body;
      runs_.push_back({joined.name, arcs[k].y0, arcs[k].y1, static_cast<std::uint32_t>(k)});
    }
  }
}

void ArcTable::append_arcs(const Run& run, std::map<std::uint32_t, ArcGuide>& guides, const DotExtent& extent,
                           std::vector<Arc>& arcs) const {
  const ArcName& name = run.name;
  if (!name.guided) {
    Arc& arc = arcs.emplace_back();
    Curve& curve = arc.form.emplace<Curve>(*curves_[name.curve]);
    if (name.negated) negate(curve);
    if (name.shift != 0) curve.q[5] += name.shift;
    arc.branch = name.branch;
    arc.y0 = run.y0;
    arc.y1 = run.y1;
    return;
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
}

ArcTable::Piece ArcTable::piece(const ArcName& name, std::int32_t y) const {
  if (name.curve == no_arc) return {};
  const auto run = std::partition_point(runs_.begin(), runs_.end(),
                                        [&](const Run& r) { return std::tie(r.name, r.y1) < std::tie(name, y); });
  return {run->arc, run->y1};
}

}  // namespace halfspace
