// findings.hpp - all that a report found out.
#pragma once

#include <string>
#include <vector>

#include "host/report/board.hpp"
#include "host/report/environment.hpp"
#include "host/report/resolver_cost.hpp"
#include "host/report/row.hpp"

namespace halfspace {

struct Findings {
  Environment environment;
  Rows rows;  // ours in the order of measuring, then those of other programs
  std::vector<BoardRow> board;
  std::vector<ResolverRow> resolver;
  double floor_ns = 0;            // a dot of the page: page_floor.hpp
  std::vector<std::string> gaps;  // what is missing, why, and what to do
};

// The exponent e of the power of x that fits y best: y = c x^e, by least squares of logarithms.
[[nodiscard]] double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace halfspace
