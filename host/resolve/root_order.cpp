#include "host/resolve/root_order.hpp"

#include <algorithm>

namespace halfspace {
namespace {

void append_limb(const Curve& d, const mpz_class& y, std::vector<Obstacle>& found) {
  const Polynomial f = restricted(d, y);
  const std::vector<LineRoot> roots = real_roots(f);
  const bool simple = static_cast<int>(roots.size()) == degree(f);
  for (const LineRoot& x : roots) found.push_back({x, simple, -1});
}

}  // namespace

std::vector<Obstacle> obstacles_on_line(const FormOnSheet& form, std::int64_t line, const ValueOnLine& value,
                                        QuarticTable& table) {
  const mpz_class y = static_cast<long>(line);
  std::vector<Obstacle> found;
  int rank = 0;
  for (const LineRoot& x : table.roots(form.part, line)) {
    if (value.vanishes(form.sheet, x)) found.push_back({x, false, rank++});
  }
  if (form.has_limb()) {
    for (const Curve& other : form.others) {
      for (const LineRoot& x : real_roots(restricted(other, y))) {
        if (value.vanishes(form.sheet, x)) found.push_back({x, false, -1});
      }
    }
    append_limb(form.sheets->d, y, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Obstacle& a, const Obstacle& b) { return compare(a.x, b.x) < 0; });
  return found;
}

}  // namespace halfspace
