#include "host/flatten/asymptote.hpp"

namespace halfspace {
namespace {

// u . S v for the second-order part S in x and y.
Real in_page(const RealHalfSpace& quadric, const Vector3& u, const Vector3& v) {
  const auto& c = quadric.c;
  return u[0] * v[0] * c[0] + (u[0] * v[1] + u[1] * v[0]) * c[3] + u[1] * v[1] * c[1];
}

}  // namespace

Real zero_beside(const RealHalfSpace& quadric) {
  Real most = 0;
  for (std::size_t i = 0; i < 6; ++i) most = larger(most, magnitude(quadric.c[i]));
  return power_of_two(-zero_bits) * most;
}

bool is_asymptotic(const RealHalfSpace& quadric) {
  const auto& c = quadric.c;
  const Real zero = zero_beside(quadric);
  return magnitude(c[2]) <= zero && larger(magnitude(c[4]), magnitude(c[5])) > zero;
}

std::optional<RankedSquares> squares_along_asymptote(const RealHalfSpace& quadric, const Kinship& kin) {
  const auto& c = quadric.c;
  const Vector3 polar{c[5], c[4], 0};
  const Vector3 linear{c[6], c[7], 0};
  const Real b = length(polar);
  const Vector3 p = scaled(polar, 1 / b);
  const Vector3 t{-p[1], p[0], 0};
  const Real pp = in_page(quadric, p, p);
  const Real pt = in_page(quadric, p, t);
  const Real tt = in_page(quadric, t, t);
  const Real p_offset = c[8] / b;
  const Real g_offset = (dot(p, linear) - p_offset * pp / 2) / b;
  const Real along_t = dot(t, linear) - p_offset * pt;
  Vector3 g = scaled(sum(scaled(p, pp / 2), scaled(t, pt)), 1 / b);
  g[2] = 1;
  RankedSquares result;
  result.constant = c[9] - 2 * b * p_offset * g_offset;
  for (const int sign : {1, -1}) {
    const Vector3 normal = sum(g, scaled(p, sign));
    result.squares.push_back({sign * b / 2, {normal[0], normal[1], normal[2], g_offset + sign * p_offset}});
  }
  if (kin.squares == 3) {
    if (magnitude(tt) <= power_of_two(-zero_bits) * b) return std::nullopt;
    result.squares.push_back({tt, {t[0], t[1], 0, along_t / tt}});
    result.constant -= along_t * along_t / tt;
  } else if (kin.rank == 4) {
    if (along_t == 0) return std::nullopt;
    result.rest = scaled(t, along_t);
  }
  return result;
}

}  // namespace halfspace
