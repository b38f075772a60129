#include "host/resolve/quartic_table.hpp"

#include <algorithm>

namespace halfspace {

const std::vector<Mark>& KnownQuartic::turns(const std::optional<Radical>& radical) {
  if (!turns_) {
    const auto nodes = radical ? root_marks(meeting_lines(radical->p, radical->r), y0_, y1_) : std::vector<Mark>{};
    turns_ = turn_marks(form_, y0_, y1_, nodes);
  }
  return *turns_;
}

std::vector<Mark> KnownQuartic::meetings(const Curve& p) const {
  return root_marks(meeting_lines(form_, as_quartic(p)), y0_, y1_);
}

const std::vector<Mark>& KnownQuartic::meetings(const KnownQuartic& p) {
  const auto [at, is_new] = meetings_.try_emplace(&p);
  if (is_new) at->second = root_marks(meeting_lines(form_, p.form_), y0_, y1_);
  return at->second;
}

const std::vector<LineRoot>& KnownQuartic::roots(std::int64_t y) {
  const auto [at, is_new] = roots_.try_emplace(y);
  if (is_new) at->second = real_roots(restricted(form_, y));
  return at->second;
}

const KnownFactors& QuarticTable::factors_of(QuarticForm p) {
  make_canonical(p);
  const auto [at, is_new] = factors_.try_emplace(p.q);
  if (is_new) {
    PlaneFactors found = factors(p);
    at->second.curves = std::move(found.curves);
    for (QuarticForm& quartic : found.quartics) at->second.quartics.push_back(known(std::move(quartic)));
  }
  return at->second;
}

KnownQuartic* QuarticTable::known(QuarticForm p) {
  const auto found = std::find_if(quartics_.begin(), quartics_.end(),
                                  [&p](const KnownQuartic& other) { return other.form().q == p.q; });
  return found != quartics_.end() ? &*found : &quartics_.emplace_back(std::move(p), y0_, y1_);
}

}  // namespace halfspace
