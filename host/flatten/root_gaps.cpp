#include "host/flatten/root_gaps.hpp"

#include <algorithm>

namespace halfspace {
namespace {

std::size_t bits_of(const mpz_class& v) { return mpz_sizeinbase(v.get_mpz_t(), 2); }

// In the open interval (at, at + 1) / 2^shift.
int changes_within(const Polynomial& f, const mpz_class& at, int shift) {
  if (shift >= 0) return sign_changes(f, at, at + 1, static_cast<unsigned>(shift));
  const auto up = static_cast<unsigned>(-shift);
  return sign_changes(f, at << up, (at + 1) << up, 0);
}

// At number / 2^shift.
int sign_of(const Polynomial& f, const mpz_class& number, int shift) {
  const mpz_class x = shift < 0 ? mpz_class(number << static_cast<unsigned>(-shift)) : number;
  const unsigned step = shift < 0 ? 0 : static_cast<unsigned>(shift);
  mpz_class value = 0;
  mpz_class term;
  unsigned up = 0;
  for (std::size_t i = f.size(); i-- > 0; up += step) {
    value *= x;
    mpz_mul_2exp(term.get_mpz_t(), f[i].get_mpz_t(), up);
    value += term;
  }
  return sgn(value);
}

mpz_class floor_at(const mpz_class& position, int shift) {
  mpz_class result;
  mpz_fdiv_q_2exp(result.get_mpz_t(), position.get_mpz_t(), static_cast<unsigned>(position_bits - shift));
  return result;
}

}  // namespace

int RootGaps::Root::sign_at(const mpz_class& number, int shift_of_number) const {
  return sign_of(*f, number, shift_of_number);
}

void RootGaps::Root::halve() {
  const int sign_low = sign_at(at, shift);
  ++shift;
  at <<= 1;
  const mpz_class middle = at + 1;
  const int sign = sign_at(middle, shift);
  is_point = sign == 0;
  if (is_point || sign == sign_low) at = middle;
}

RootGaps::RootGaps(const std::vector<Polynomial>& all, const mpz_class& low, const mpz_class& high)
    : low_(low), high_(high) {
  find(all);
}

void RootGaps::find(const std::vector<Polynomial>& all) {
  // Two intervals of this size cover the range.
  const int shift = position_bits - static_cast<int>(bits_of(mpz_class(high_ - low_)));
  const mpz_class first = floor_at(low_, shift);
  for (const Polynomial& f : all) {
    if (degree(f) < 1) continue;
    isolate(f, first, shift);
    if (sign_of(f, first + 1, shift) == 0) roots_.push_back({&f, first + 1, shift, true});
    isolate(f, first + 1, shift);
  }
  separate();
  gather();
}

void RootGaps::isolate(const Polynomial& f, const mpz_class& at, int shift) {
  const Root whole{&f, at, shift, false};
  if (whole.high() <= low_ || whole.low() >= high_) return;
  const int changes = changes_within(f, at, shift);
  if (changes == 0) return;
  const bool is_told = changes == 1 && sign_of(f, at, shift) != 0 && sign_of(f, at + 1, shift) != 0;
  if (is_told || whole.is_fine()) return roots_.push_back(whole);
  const mpz_class left = at << 1;
  const mpz_class middle = left + 1;
  isolate(f, left, shift + 1);
  if (sign_of(f, middle, shift + 1) == 0) roots_.push_back({&f, middle, shift + 1, true});
  isolate(f, middle, shift + 1);
}

// Halves what overlaps, or an end of the range, until it comes apart or is as fine as positions are.
void RootGaps::separate() {
  for (Root& root : roots_) {
    const auto holds = [&root](const mpz_class& end) { return root.low() <= end && end <= root.high(); };
    while (!root.is_fine() && (holds(low_) || holds(high_))) root.halve();
  }
  const auto before = [](const Root& a, const Root& b) { return a.low() < b.low(); };
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    std::sort(roots_.begin(), roots_.end(), before);
    for (std::size_t i = 0; i + 1 < roots_.size(); ++i) {
      Root& a = roots_[i];
      Root& b = roots_[i + 1];
      while (a.high() >= b.low() && b.high() >= a.low() && !(a.is_fine() && b.is_fine())) {
        Root& wider = b.is_fine() || (!a.is_fine() && a.shift <= b.shift) ? a : b;
        wider.halve();
        is_changed = true;
      }
    }
  }
}

void RootGaps::gather() {
  for (Root& root : roots_) {
    if (root.high() <= low_ || root.low() >= high_) continue;
    const bool joins = !clusters_.empty() && clusters_.back().high >= root.low();
    if (!joins) clusters_.push_back({{}, root.low(), root.high()});
    Cluster& cluster = clusters_.back();
    cluster.high = std::max(cluster.high, root.high());
    cluster.roots.push_back(std::move(root));
  }
  roots_.clear();
}

const mpz_class& RootGaps::low_of(std::size_t gap) const { return gap == 0 ? low_ : clusters_[gap - 1].high; }
const mpz_class& RootGaps::high_of(std::size_t gap) const {
  return gap == clusters_.size() ? high_ : clusters_[gap].low;
}

bool RootGaps::is_empty(std::size_t gap) const { return high_of(gap) - low_of(gap) < 2; }

bool RootGaps::holds(std::size_t gap, const mpz_class& position) const {
  return low_of(gap) < position && position < high_of(gap);
}

Dyadic RootGaps::inside(std::size_t gap) const {
  const mpz_class& low = low_of(gap);
  const mpz_class& high = high_of(gap);
  for (int shift = position_bits - static_cast<int>(bits_of(mpz_class(high - low)));; ++shift) {
    const mpz_class number = floor_at(low, shift) + 1;
    const Root point{nullptr, number, shift, true};
    if (point.low() >= high) continue;
    if (shift < 0) return {number << static_cast<unsigned>(-shift), 0};
    return {number, static_cast<unsigned>(shift)};
  }
}

void RootGaps::refine(Cluster& cluster) {
  bool is_first = true;
  for (Root& root : cluster.roots) {
    while (!root.is_fine()) root.halve();
    cluster.low = is_first ? root.low() : std::min(cluster.low, root.low());
    cluster.high = is_first ? root.high() : std::max(cluster.high, root.high());
    is_first = false;
  }
}

mpz_class RootGaps::low_end(std::size_t gap) {
  if (gap == 0) return low_;
  refine(clusters_[gap - 1]);
  return std::max(low_, clusters_[gap - 1].high);
}

mpz_class RootGaps::high_end(std::size_t gap) {
  if (gap == clusters_.size()) return high_;
  refine(clusters_[gap]);
  return std::min(high_, clusters_[gap].low);
}

}  // namespace halfspace
