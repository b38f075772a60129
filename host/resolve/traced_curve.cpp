#include "host/resolve/traced_curve.hpp"

#include <algorithm>
#include <utility>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

bool is_second_order_proportional(const Curve& p, const Curve& q) {
  const auto minor = [&](std::size_t i, std::size_t j) { return p.q[i] * q.q[j] == p.q[j] * q.q[i]; };
  return minor(0, 1) && minor(0, 2) && minor(1, 2);
}

// m p - n q without second order: circles' radical line, and its like.
Curve radical_line(const Curve& p, const Curve& q) {
  const std::size_t i = sgn(p.q[0]) != 0 ? 0 : sgn(p.q[1]) != 0 ? 1 : 2;
  return minus_multiple(q.q[i] * p, p.q[i], q);
}

// The place of a factor among the curves, where it is put if it is new.
TracedCurve& place_of(Curve&& factor, std::optional<Section>&& section, std::vector<TracedCurve>& curves) {
  const auto same = [&factor](const TracedCurve& known) { return same_curve(known.curve, factor); };
  const auto known = std::find_if(curves.begin(), curves.end(), same);
  if (known != curves.end()) return *known;
  TracedCurve& added = curves.emplace_back();
  added.curve = std::move(factor);
  added.enclosed = interval_curve(added.curve);
  added.section = std::move(section);
  return added;
}

template <class Tell>
void for_each_factor(Curve&& p, std::optional<Section>&& section, std::vector<TracedCurve>& curves, const Tell& tell) {
  if (is_constant(p)) return;
  make_canonical(p);
  auto lines = rational_lines(p);
  if (!lines) return tell(place_of(std::move(p), std::move(section), curves));
  const bool is_double = same_curve((*lines)[0], (*lines)[1]);
  if (!is_double) section.reset();
  tell(place_of(std::move((*lines)[0]), std::move(section), curves));
  if (!is_double) tell(place_of(std::move((*lines)[1]), std::nullopt, curves));
}

}  // namespace

void trace_own(Curve p, std::optional<Section>&& section, std::vector<TracedCurve>& curves) {
  for_each_factor(std::move(p), std::move(section), curves, [](TracedCurve& traced) { traced.own = true; });
}

void trace(Curve p, std::optional<Section>&& section, bool later, std::uint32_t constraint,
           std::vector<TracedCurve>& curves) {
  for_each_factor(std::move(p), std::move(section), curves, [later, constraint](TracedCurve& traced) {
    traced.later = traced.later || later;
    traced.constraints.push_back(constraint);
  });
}

std::optional<std::vector<Curve>> lines_through_meeting(const TracedCurve& p, const TracedCurve& q) {
  if (p.section && q.section) {  // where both are 0, factor q line p = +- factor p line q
    if (is_zero(p.section->line)) return std::vector{q.section->line};
    if (is_zero(q.section->line)) return std::vector{p.section->line};
    Curve u = q.section->factor * p.section->line;
    std::vector<Curve> lines;
    lines.reserve(2);
    lines.push_back(minus_multiple(u, p.section->factor, q.section->line));
    lines.push_back(plus_multiple(std::move(u), p.section->factor, q.section->line));
    return lines;
  }
  if (is_second_order_proportional(p.curve, q.curve)) return std::vector{radical_line(p.curve, q.curve)};
  return std::nullopt;
}

}  // namespace halfspace
