#include "host/resolve/quartic_table.hpp"

namespace halfspace {

const PlaneFactors& QuarticTable::factors_of(QuarticForm p) {
  make_canonical(p);
  const auto known = factors_.find(p.q);
  return known != factors_.end() ? known->second : factors_.emplace(p.q, factors(p)).first->second;
}

const std::vector<Mark>& QuarticTable::turns(const QuarticForm& p) {
  const auto [at, is_new] = turns_.try_emplace(p.q);
  if (is_new) {
    for (const Polynomial& lines : turning_lines(p)) {
      const std::vector<Mark> found = root_marks(lines, y0_, y1_);
      at->second.insert(at->second.end(), found.begin(), found.end());
    }
  }
  return at->second;
}

const std::vector<Mark>& QuarticTable::meetings(const QuarticForm& p, const QuarticForm& q) {
  const auto [at, is_new] = meetings_.try_emplace({p.q, q.q});
  if (is_new) at->second = root_marks(meeting_lines(p, q), y0_, y1_);
  return at->second;
}

const std::vector<LineRoot>& QuarticTable::roots(const QuarticForm& p, std::int64_t y) {
  const auto [at, is_new] = roots_[p.q].try_emplace(y);
  if (is_new) at->second = real_roots(restricted(p, static_cast<long>(y)));
  return at->second;
}

}  // namespace halfspace
