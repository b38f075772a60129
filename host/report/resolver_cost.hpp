// resolver_cost.hpp - what the resolver takes: each body by itself, and scenes of growing size.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/subject.hpp"

namespace halfspace {

struct ResolverRow {
  std::string scene;
  std::size_t bodies = 0;
  double scene_ms = 0;                    // all of it
  std::optional<double> two_quadrics_ms;  // a body with at most two quadrics, the median
  double slowest_ms = 0;                  // the slowest body
};

[[nodiscard]] ResolverRow measure_resolver(const SceneText& source, const PageSize& size, int runs);

[[nodiscard]] std::string resolver_summary(const std::vector<ResolverRow>& rows);

}  // namespace halfspace
