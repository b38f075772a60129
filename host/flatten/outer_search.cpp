#include "host/flatten/outer_search.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <queue>

namespace halfspace {
namespace {

constexpr int few_cells = 150;             // in one step of the search for the part with the body
constexpr int many_cells = 1500;           // in one that fails with few
constexpr int meeting_cells = 20000;       // in the search for meetings
constexpr double least_meeting = 0x1p-16;  // surfaces that come closer may meet
constexpr int most_cells = 300;            // of a plane
constexpr int most_steps = 200;            // each shrinks some side by a quarter: 2^60 in all
constexpr int most_halvings = 600;         // of a search outwards
constexpr double shrunk = 0.76;

// An open box and the forms whose sign is not the same all over it.
struct Open {
  CentredBox cell;
  std::vector<std::uint32_t> doubtful;
  double top = 0;
};
bool operator<(const Open& a, const Open& b) { return a.top < b.top; }

std::vector<std::uint32_t> every(std::size_t count) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

bool may_hold(std::span<const BoundForm> forms, const CentredBox& cell) {
  return std::none_of(forms.begin(), forms.end(), [&](const BoundForm& f) { return f.over(cell).low > 0; });
}

// Corners rounded outwards.
CentredBox cell_between(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  CentredBox cell;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.middle[i] = low[i] + (high[i] - low[i]) / 2;
    cell.half[i] = std::max(high[i] - cell.middle[i], cell.middle[i] - low[i]) * (1 + 0x1p-50);
  }
  return cell;
}

double outer_end(const CentredBox& cell, std::size_t i, double sign) {
  return cell.middle[i] + sign * cell.half[i] * (1 + 0x1p-50);
}

// They overlap.
std::array<CentredBox, 2> halves(const CentredBox& cell, std::size_t i) {
  std::array<CentredBox, 2> parts{cell, cell};
  const double quarter = cell.half[i] / 2;
  parts[0].half[i] = parts[1].half[i] = quarter * (1 + 0x1p-40);
  parts[0].middle[i] -= quarter;
  parts[1].middle[i] += quarter;
  return parts;
}

// Around the cells that are not dropped. Those in the core, of half the size, are not split: if nothing is left of the others, the core
// is the next whole, and directions in which a body nearly has no end are told apart as finely at every size.
class Surroundings {
 public:
  Surroundings(std::span<const BoundForm> forms, const CentredBox& whole, int cells) : forms_(forms), whole_(whole) {
    std::deque<CentredBox> open{whole};
    for (int n = 0; !open.empty(); ++n) {
      const CentredBox cell = open.front();
      open.pop_front();
      if (!may_hold(forms_, cell)) continue;
      if (n >= cells || is_in_core(cell)) {
        add(cell);
      } else {
        for (const CentredBox& half : halves(cell, 0)) {
          for (const CentredBox& quarter : halves(half, 1)) {
            for (const CentredBox& eighth : halves(quarter, 2)) open.push_back(eighth);
          }
        }
      }
    }
  }

  [[nodiscard]] std::optional<CentredBox> hull() const {
    if (is_empty_) return std::nullopt;
    return cell_between(low_, high_);
  }

 private:
  [[nodiscard]] bool is_in_core(const CentredBox& cell) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const double core = whole_.half[i] / 2 * (1 + 0x1p-30);
      if (outer_end(cell, i, -1) < whole_.middle[i] - core || outer_end(cell, i, 1) > whole_.middle[i] + core)
        return false;
    }
    return true;
  }

  void add(const CentredBox& cell) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = outer_end(cell, i, -1);
      const double b = outer_end(cell, i, 1);
      low_[i] = is_empty_ ? a : std::min(low_[i], a);
      high_[i] = is_empty_ ? b : std::max(high_[i], b);
    }
    is_empty_ = false;
  }

  std::span<const BoundForm> forms_;
  const CentredBox& whole_;
  std::array<double, 3> low_{}, high_{};
  bool is_empty_ = true;
};

// Sides that are longer than those of the part. Is one of them much longer?
bool shrink(CentredBox& cell, const CentredBox& part) {
  bool has_shrunk = false;
  for (std::size_t i = 0; i < 3; ++i) {
    has_shrunk = has_shrunk || part.half[i] < shrunk * cell.half[i];
    if (!(part.half[i] < cell.half[i])) continue;
    cell.half[i] = part.half[i];
    cell.middle[i] = part.middle[i];
  }
  return has_shrunk;
}

class Search {
 public:
  Search(std::span<const BoundForm> forms, std::size_t axis, double sign) : forms_(forms), axis_(axis), sign_(sign) {}

  Outermost run(const CentredBox& whole, double slack) {
    offer({whole, every(forms_.size())});
    for (int n = 0; n < most_halvings && is_open(slack); ++n) {
      const Open outer = open_.top();
      open_.pop();
      halve(outer);
    }
    collect();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_open(double slack) const { return !open_.empty() && open_.top().top > result_.known + slack; }

  void halve(const Open& open) {
    const auto& h = open.cell.half;
    const auto longest = static_cast<std::size_t>(std::max_element(h.begin(), h.end()) - h.begin());
    for (const CentredBox& half : halves(open.cell, longest)) offer({half, open.doubtful});
  }

  void offer(Open open) {
    std::vector<std::uint32_t> doubtful;
    bool middle_holds = true;
    for (const std::uint32_t i : open.doubtful) {
      const ValueRange range = forms_[i].over(open.cell);
      if (range.low > 0) return;
      if (range.high <= 0) continue;
      doubtful.push_back(i);
      middle_holds = middle_holds && range.high_in_the_middle <= 0;
    }
    const double middle = sign_ * open.cell.middle[axis_];
    open.top = sign_ * outer_end(open.cell, axis_, sign_);
    if (doubtful.empty()) {
      result_.known = std::max(result_.known, middle + open.cell.half[axis_] * (1 - 0x1p-40));
    } else if (middle_holds) {
      result_.known = std::max(result_.known, middle);
    }
    open.doubtful = std::move(doubtful);
    if (open.top > result_.known) open_.push(std::move(open));
  }

  void collect() {
    for (; !open_.empty() && open_.top().top > result_.known; open_.pop()) {
      const Open& open = open_.top();
      result_.bound = std::max(result_.bound, open.top);
      add_meetings(open.doubtful);
    }
  }

  void add_meetings(const std::vector<std::uint32_t>& forms) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      result_.meetings.insert({forms[i]});
      for (std::size_t j = i + 1; j < forms.size(); ++j) {
        result_.meetings.insert({forms[i], forms[j]});
        for (std::size_t k = j + 1; k < forms.size(); ++k) result_.meetings.insert({forms[i], forms[j], forms[k]});
      }
    }
  }

  std::span<const BoundForm> forms_;
  std::size_t axis_;
  double sign_;
  std::priority_queue<Open> open_;
  Outermost result_;
};

class MeetingSearch {
 public:
  MeetingSearch(std::span<const BoundForm> forms, std::span<const std::optional<std::size_t>> families)
      : forms_(forms), families_(families) {}

  [[nodiscard]] bool finds(const CentredBox& whole) { return finds(whole, every(forms_.size())); }

 private:
  [[nodiscard]] bool finds(const CentredBox& cell, const std::vector<std::uint32_t>& doubtful_around) {
    if (fails(last_to_fail_, cell)) return false;
    std::vector<std::uint32_t> doubtful;
    doubtful.reserve(doubtful_around.size());
    for (const std::uint32_t i : doubtful_around) {
      const ValueRange range = forms_[i].over(cell);
      if (range.low > 0) {
        last_to_fail_ = i;
        return false;
      }
      if (!(range.high < 0)) doubtful.push_back(i);
    }
    if (!has_two_families(doubtful)) return false;
    const auto& h = cell.half;
    const auto longest = static_cast<std::size_t>(std::max_element(h.begin(), h.end()) - h.begin());
    if (++cells_ > meeting_cells || h[longest] < least_meeting) return true;
    const std::array<CentredBox, 2> parts = halves(cell, longest);
    return finds(parts[0], doubtful) || finds(parts[1], doubtful);
  }

  [[nodiscard]] bool fails(std::uint32_t form, const CentredBox& cell) const { return forms_[form].over(cell).low > 0; }

  [[nodiscard]] bool has_two_families(const std::vector<std::uint32_t>& forms) const {
    std::optional<std::size_t> first;
    for (const std::uint32_t i : forms) {
      if (!families_[i]) continue;
      if (first && *first != *families_[i]) return true;
      first = families_[i];
    }
    return false;
  }

  std::span<const BoundForm> forms_;
  std::span<const std::optional<std::size_t>> families_;
  std::uint32_t last_to_fail_ = 0;  // a good guess for the next cell
  int cells_ = 0;
};

}  // namespace

std::optional<CentredBox> part_with_body(std::span<const BoundForm> forms, const CentredBox& whole, bool thoroughly) {
  CentredBox cell = whole;
  int cells = few_cells;
  for (int n = 0; n < most_steps; ++n) {
    const auto part = Surroundings(forms, cell, cells).hull();
    if (!part) return std::nullopt;
    const bool has_shrunk = shrink(cell, *part);
    if (!has_shrunk && (!thoroughly || cells == many_cells)) break;
    cells = has_shrunk ? few_cells : many_cells;
  }
  return cell;
}

bool may_meet(std::span<const BoundForm> forms, std::span<const std::optional<std::size_t>> families) {
  if (MeetingSearch(forms, families).finds({{0, 0, 0}, {1, 1, 1}})) return true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1, 1}) {
      std::vector<BoundForm> far;
      for (const BoundForm& form : forms) far.push_back(form.towards(axis, sign));
      if (MeetingSearch(far, families).finds({{0, 0, 0.5}, {1, 1, 0.5}})) return true;
    }
  }
  return false;
}

Outermost search_outwards(std::span<const BoundForm> forms, const CentredBox& whole, std::size_t axis, double sign,
                          double slack) {
  return Search(forms, axis, sign).run(whole, slack);
}

std::optional<bool> meets_plane(std::span<const BoundForm> forms, const CentredBox& whole, std::size_t axis,
                                double at) {
  CentredBox plane = whole;
  plane.middle[axis] = at;
  plane.half[axis] = 0;
  std::deque<CentredBox> open{plane};
  for (int n = 0; !open.empty(); ++n) {
    if (n == most_cells) return std::nullopt;
    const CentredBox cell = open.front();
    open.pop_front();
    bool may_hold_here = true;
    bool middle_holds = true;
    for (const BoundForm& f : forms) {
      const ValueRange range = f.over(cell);
      may_hold_here = may_hold_here && !(range.low > 0);
      middle_holds = middle_holds && range.high_in_the_middle <= 0;
    }
    if (middle_holds) return true;
    if (!may_hold_here) continue;
    for (const CentredBox& part : halves(cell, (axis + 1) % 3)) {
      for (const CentredBox& quarter : halves(part, (axis + 2) % 3)) open.push_back(quarter);
    }
  }
  return false;
}

}  // namespace halfspace
