#include "host/flatten/ranked_squares.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// a f + b g of linear forms.
RealHalfSpace plane_from(Real a, const Vector4& f, Real b, const Vector4& g) {
  RealHalfSpace plane{HalfSpaceKind::plane, {}};
  for (std::size_t i = 0; i < 4; ++i) plane.c[i] = a * f[i] + b * g[i];
  return plane;
}

}  // namespace

std::optional<RankedSquares> ranked_squares_of(const RealHalfSpace& quadric, const Kinship& kin) {
  const Spectrum spectrum = spectrum_of(quadric);
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto size = [&](std::size_t i) { return magnitude(spectrum.values[i]); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  RankedSquares result;
  result.constant = quadric.c[9];
  Vector3 rest{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& axis = spectrum.vectors[order[k]];
    const Real along = dot(axis, {quadric.c[6], quadric.c[7], quadric.c[8]});
    if (k >= kin.squares) {
      rest = sum(rest, scaled(axis, along));
      continue;
    }
    if (size(order[k]) <= power_of_two(-zero_bits) * size(order[0])) return std::nullopt;
    const Real offset = along / spectrum.values[order[k]];
    result.squares.push_back({spectrum.values[order[k]], {axis[0], axis[1], axis[2], offset}});
    result.constant -= along * offset;
  }
  if (kin.rank == kin.squares + 2) {
    if (largest(rest) == 0) return std::nullopt;
    result.rest = rest;
  }
  return result;
}

std::optional<std::array<RealHalfSpace, 2>> plane_pair_of(const RealHalfSpace& quadric, const Kinship& kin) {
  if (kin.squares == 0 || kin.rank > 2) return std::nullopt;
  const auto ranked = ranked_squares_of(quadric, kin);
  if (!ranked) return std::nullopt;
  const auto& [weight, form] = ranked->squares.front();
  const bool is_crossing = kin.squares == 2;
  const Real other_weight = is_crossing ? ranked->squares[1].weight : (kin.rank == 2 ? ranked->constant : Real(0));
  const Vector4 other_form = is_crossing ? ranked->squares[1].form : Vector4{0, 0, 0, 1};
  if ((weight < 0 && other_weight < 0) || (weight > 0 && other_weight > 0)) return std::nullopt;
  if (kin.rank == 2 && other_weight == 0) return std::nullopt;
  const Real ratio = square_root(-other_weight / weight);
  return std::array{plane_from(1, form, ratio, other_form), plane_from(weight, form, -weight * ratio, other_form)};
}

}  // namespace halfspace
