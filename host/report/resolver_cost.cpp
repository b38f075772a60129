#include "host/report/resolver_cost.hpp"

#include <algorithm>

#include "host/report/markdown.hpp"
#include "host/report/processor_time.hpp"
#include "host/resolve/resolve.hpp"

namespace halfspace {
namespace {

constexpr std::size_t most_bodies = 200;  // timed one by one: as many stand for all

bool has_at_most_two_quadrics(const IntegerBody& body) {
  return std::count_if(body.half_spaces.begin(), body.half_spaces.end(),
                       [](const IntegerHalfSpace& h) { return h.kind == HalfSpaceKind::quadric; }) <= 2;
}

double resolve_ms(const IntegerScene& scene, int runs) {
  return 1e3 * median_seconds(runs, [&scene] { (void)resolve(scene); });
}

}  // namespace

ResolverRow measure_resolver(const SceneText& source, const PageSize& size, int runs) {
  const IntegerScene scene = make_subject(source, size).scene;
  ResolverRow row{
      .scene = source.name, .bodies = scene.bodies.size(), .scene_ms = resolve_ms(scene, runs), .two_quadrics_ms = {}};
  IntegerScene alone = scene;
  std::vector<double> small;
  for (std::size_t i = 0; i < std::min(most_bodies, scene.bodies.size()); ++i) {
    alone.bodies = {scene.bodies[i]};
    const double ms = resolve_ms(alone, runs);
    row.slowest_ms = std::max(row.slowest_ms, ms);
    if (has_at_most_two_quadrics(scene.bodies[i])) small.push_back(ms);
  }
  if (!small.empty()) row.two_quadrics_ms = median(std::move(small));
  return row;
}

std::string resolver_summary(const std::vector<ResolverRow>& rows) {
  if (rows.empty()) return "";
  std::string text =
      "\n## The resolver\n\nMilliseconds. A body of at most two quadrics is to take at most 1 (median), one of eight "
      "that all "
      "meet 500, and a scene's time is\nto grow as its bodies.\n\n" +
      table_head(
          {"scene", "bodies", "a body of two quadrics, median", "the slowest body", "whole scene", "a body of it"});
  for (const ResolverRow& row : rows) {
    text += table_line({row.scene, std::to_string(row.bodies), figure(row.two_quadrics_ms), figure(row.slowest_ms),
                        figure(row.scene_ms), figure(row.scene_ms / static_cast<double>(row.bodies))});
  }
  return text;
}

}  // namespace halfspace
