#include "host/resolve/separator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

constexpr double page = 0x1p18;  // dots: no page and no origin is as large

double middle_of(const Interval& x) { return (x.low + x.high) / 2; }

}  // namespace

std::optional<Separator> dot_separator(const mpz_class& column) {
  const mpz_class limit(page);
  const mpz_class& within = column > limit ? limit : column < -limit ? mpz_class(-limit) : column;
  return Separator{within.get_si() * separator_unit, 0};
}

void Channel::add(std::int64_t y, const LineRoot& left, const LineRoot& right) {
  if (count_ == 0) first_ = {&left, &right};
  samples_[count_++] = {static_cast<double>(y), middle_of(left.near), middle_of(right.near)};
}

std::optional<Separator> Channel::separator() const {
  const Sample& first = samples_.front();
  const Sample& last = samples_[count_ - 1];
  const double height = std::max(last.y - first.y, 1.0);
  const double low = (last.low - first.low) / height;
  const double high = (last.high - first.high) / height;
  std::optional<Separator> best;
  double widest = 0;
  for (const double slope : std::array{low, high, (low + high) / 2}) {
    double left = -4 * page;
    double right = 4 * page;
    for (std::size_t i = 0; i < count_; ++i) {
      const Sample& s = samples_[i];
      left = std::max(left, s.low - slope * (s.y - first.y));
      right = std::min(right, s.high - slope * (s.y - first.y));
    }
    if (!(right - left > widest) || !(std::abs(slope) < page)) continue;
    widest = right - left;
    best = Separator{std::llround((left + right) / 2 * separator_unit), std::llround(slope * separator_unit)};
  }
  return best;
}

bool Channel::holds(const Separator& separator) const {
  const double near = static_cast<double>(separator.at) / separator_unit;  // exact: a separator has few bits
  if (first_.left->near.high < near && near < first_.right->near.low) return true;
  const LineRoot at = rational_root(static_cast<long>(separator.at), separator_unit);
  return compare(*first_.left, at) < 0 && compare(at, *first_.right) < 0;
}

}  // namespace halfspace
