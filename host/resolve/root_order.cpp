#include "host/resolve/root_order.hpp"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

void insert(Obstacle next, std::vector<Obstacle>& found) {
  const auto precedes = [](const Obstacle& a, const Obstacle& b) { return compare(a.x, b.x) < 0; };
  const auto at = std::upper_bound(found.begin(), found.end(), next, precedes);
  found.insert(at, std::move(next));
}

void insert_limb(const Curve& d, std::int64_t y, std::vector<Obstacle>& found) {
  Polynomial f = restricted(d, y);
  const int order = degree(f);
  std::vector<LineRoot> roots = real_roots(std::move(f));
  const bool simple = static_cast<int>(roots.size()) == order;
  for (LineRoot& x : roots) insert({std::move(x), simple, -1}, found);
}

}  // namespace

std::vector<Obstacle> obstacles_on_line(const FormOnSheet& form, std::int64_t y, const ValueOnLine& value) {
  const std::vector<LineRoot>& roots = form.part->roots(y);
  std::vector<Obstacle> found;
  found.reserve(roots.size() + 2);
  int rank = 0;
  for (const LineRoot& x : roots) {
    if (value.vanishes(form.sheet, x)) found.push_back({x, false, rank++});
  }
  if (!form.has_limb()) return found;
  for (const Curve& other : *form.others) {
    for (LineRoot& x : real_roots(restricted(other, y))) {
      if (value.vanishes(form.sheet, x)) insert({std::move(x), false, -1}, found);
    }
  }
  insert_limb(form.sheets->d, y, found);
  return found;
}

}  // namespace halfspace
