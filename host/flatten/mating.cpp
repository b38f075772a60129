#include "host/flatten/mating.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);
constexpr int agreement_bits = 10;
constexpr int sameness_bits = 40;

// Cells of the grid per unit: 2^6 of normals, 1 of dots; and how far around a plane is looked.
const Vector4 cells_per_unit{64, 64, 64, 1};
const Vector4 look_around{power_of_two(-10), power_of_two(-10), power_of_two(-10), power_of_two(-3)};

std::int64_t cell(Real v) {
  const Real bound = power_of_two(62);
  return static_cast<std::int64_t>(nearest_whole(smaller(larger(v, -bound), bound)));
}

RealHalfSpace with_unit_normal(const RealHalfSpace& plane) {
  RealHalfSpace result = plane;
  const Real most = largest({plane.c[0], plane.c[1], plane.c[2]});
  for (Real& v : result.c) v = v / most;
  const Real size = length({result.c[0], result.c[1], result.c[2]});
  for (Real& v : result.c) v = v / size;
  return result;
}

RealHalfSpace reversed(RealHalfSpace plane) {
  for (Real& v : plane.c) v = -v;
  return plane;
}

bool agree(const RealHalfSpace& a, const RealHalfSpace& b, const Box& box) {
  Real at_centre = a.c[3] - b.c[3];
  Real spread = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    at_centre += (a.c[i] - b.c[i]) * (box.low[i] + box.high[i]) / 2;
    spread += magnitude(a.c[i] - b.c[i]) * (box.high[i] - box.low[i]) / 2;
  }
  return magnitude(at_centre) + spread <= power_of_two(-agreement_bits);
}

// The same coefficients but for their last bits.
bool are_same(const RealHalfSpace& a, const RealHalfSpace& b) {
  Real most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = larger(most, magnitude(a.c[i] - b.c[i]));
  return most <= power_of_two(-sameness_bits) * larger(1, magnitude(a.c[3]));
}

}  // namespace

std::size_t PlaneMating::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 0;
  for (const std::int64_t part : key) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29;
  }
  return hash;
}

Vector4 PlaneMating::position_of(const RealHalfSpace& plane) const {
  const Vector3 normal{plane.c[0], plane.c[1], plane.c[2]};
  return {plane.c[0], plane.c[1], plane.c[2], plane.c[3] + dot(normal, middle_)};
}

// Looks in the cells of the corners around the plane's position: most often all one cell.
std::size_t PlaneMating::find(const RealHalfSpace& plane, const Box& box,
                              const std::vector<std::uint32_t>& bodies) const {
  const Vector4 position = position_of(plane);
  std::array<Key, 2> ends;
  for (std::size_t i = 0; i < 4; ++i) {
    ends[0][i] = cell((position[i] - look_around[i]) * cells_per_unit[i]);
    ends[1][i] = cell((position[i] + look_around[i]) * cells_per_unit[i]);
  }
  std::size_t best = none;
  for (unsigned corner = 0; corner < 16; ++corner) {
    Key key{};
    bool is_repeat = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_upper = (corner >> i & 1) != 0;
      key[i] = ends[is_upper ? 1 : 0][i];
      is_repeat = is_repeat || (is_upper && ends[0][i] == ends[1][i]);
    }
    const auto found = is_repeat ? cells_.end() : cells_.find(key);
    if (found == cells_.end()) continue;
    for (const std::size_t candidate : found->second) {
      const Leader& leader = leaders_[candidate];
      if (candidate >= best) continue;
      const bool one_body = std::any_of(bodies.begin(), bodies.end(),
                                        [&leader](std::uint32_t body) { return leader.bodies.count(body) != 0; });
      const bool joins = one_body ? are_same(plane, leader.plane)
                                  : agree(plane, leader.plane, box) && agree(plane, leader.plane, leader.first);
      if (joins) {
        best = candidate;
      }
    }
  }
  return best;
}

PlaneMating::Match PlaneMating::add(const RealHalfSpace& plane, const Region& region,
                                    const std::vector<std::uint32_t>& bodies) {
  const RealHalfSpace own = with_unit_normal(plane);
  const std::size_t same = find(own, region.box, bodies);
  const std::size_t opposite = find(reversed(own), region.box, bodies);
  if (same == none && opposite == none) {
    Key key{};
    const Vector4 position = position_of(own);
    for (std::size_t i = 0; i < 4; ++i) key[i] = cell(position[i] * cells_per_unit[i]);
    cells_[key].push_back(leaders_.size());
    leaders_.push_back({own, region.box, region, {bodies.begin(), bodies.end()}});
    return {leaders_.size() - 1, false};
  }
  const Match match{std::min(same, opposite), opposite < same};
  Leader& leader = leaders_[match.leader];
  leader.all = around(leader.all, region);
  leader.bodies.insert(bodies.begin(), bodies.end());
  return match;
}

}  // namespace halfspace
