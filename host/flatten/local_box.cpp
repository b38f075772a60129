#include "host/flatten/local_box.hpp"

namespace halfspace {
namespace {

// Shifting a frame by 2^36 of its sizes leaves 2^-76 of noise in a transform, and at most 2^-74 in coefficients.
constexpr int far_bits = 36;
constexpr int dropped_part_bits = 36;

Real target_for(Real across) {
  if (across <= 1024) return power_of_two(-14);
  return smaller(times_power_of_two(across * across, -34), power_of_two(-4));
}

}  // namespace

Region region_of(const Box& box, Real page) {
  const Real across = larger(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  return {box, target_for(smaller(across, page))};
}

Region around(const Region& a, const Region& b) { return {around(a.box, b.box), smaller(a.target, b.target)}; }

LocalBox local_box(const Region& region) {
  const Box& box = region.box;
  LocalBox local;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real middle = times_power_of_two(box.low[i] + box.high[i], -1);
    const Real centre = nearest_whole(middle);
    local.centre[i] = centre;
    local.half[i] = 1;  // or to the end that is further off
    if (centre <= middle) local.half[i] = larger(local.half[i], box.high[i] - centre);
    if (centre >= middle) local.half[i] = larger(local.half[i], centre - box.low[i]);
  }
  local.radius = largest(local.half);
  local.target = region.target;
  return local;
}

std::optional<Matrix4> inverse_from(const LocalBox& box, const Matrix4& inverse) {
  if (largest(box.centre) > times_power_of_two(box.radius, far_bits)) return std::nullopt;
  return shifted(box.centre, inverse);
}

Real reach(const Vector4& form, const LocalBox& box) {
  Real total = magnitude(form[3]);
  for (std::size_t i = 0; i < 3; ++i) total += magnitude(form[i]) * box.half[i];
  return total;
}

Vector4 residual_of(const Vector4& form, Real scale) {
  Vector4 residual;
  for (std::size_t i = 0; i < 4; ++i) residual[i] = nearest_whole(form[i] * scale) - form[i] * scale;
  return residual;
}

RoundedLinear rounded(const Vector4& form, Real scale) {
  RoundedLinear result{{}, residual_of(form, scale)};
  for (std::size_t i = 0; i < 4; ++i) result.integers[i] = round_to_integer(form[i] * scale);
  return result;
}

Real dropped_part(const LocalBox& box) { return box.radius * power_of_two(-dropped_part_bits); }

}  // namespace halfspace
