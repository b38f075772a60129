// parabolas.hpp - how deep a line goes into a set of half-spaces: the least, along it, of the largest of their values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace halfspace::oracle {

struct Parabola {
  double a = 0, b = 0, c = 0;  // a w^2 + b w + c
};

// At a vertex or where two cross; one of them opens upwards, or they have no least.
inline double least_of_largest(const std::vector<Parabola>& all) {
  double least = std::numeric_limits<double>::infinity();
  const auto try_at = [&](double w) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Parabola& p : all) largest = std::max(largest, (p.a * w + p.b) * w + p.c);
    least = std::min(least, largest);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].a > 0) try_at(-all[i].b / (2 * all[i].a));
    for (std::size_t j = 0; j < i; ++j) {
      const Parabola d{all[i].a - all[j].a, all[i].b - all[j].b, all[i].c - all[j].c};
      const double discriminant = d.b * d.b - 4 * d.a * d.c;
      if (discriminant < 0) continue;
      const double far = -d.b - std::copysign(std::sqrt(discriminant), d.b);
      if (far != 0) try_at(2 * d.c / far);
      if (d.a != 0) try_at(far / (2 * d.a));
    }
  }
  return least;
}

}  // namespace halfspace::oracle
