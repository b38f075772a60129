#include "host/flatten/mating.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int agreement_bits = 10;
constexpr int sameness_bits = 40;

// Cells of the grid per unit; and how far around a surface is looked, in 16ths of a cell: twice as far for the distance of a plane.
constexpr int fine_bits = 4;
constexpr Real cells_per_normal = 64;
const Real cells_per_coefficient = power_of_two(36);
const Real fine_cells = power_of_two(fine_bits);
const Real half_a_cell = power_of_two(-1);

// In cells, the first of which reaches from -1/2 to 1/2.
std::int64_t fine_cell(Real v) { return floor_within_62_bits((v + half_a_cell) * fine_cells); }
std::int64_t cell_of(std::int64_t fine) { return fine >> fine_bits; }

std::int64_t fine_reach(const RealHalfSpace& shape, std::size_t coordinate) {
  return shape.kind == HalfSpaceKind::plane && coordinate == 3 ? 2 : 1;
}
Real reach_of(const RealHalfSpace& shape, std::size_t coordinate) { return fine_reach(shape, coordinate) / fine_cells; }

RealHalfSpace with_unit_normal(const RealHalfSpace& plane) {
  RealHalfSpace result = plane;
  const Real most = largest({plane.c[0], plane.c[1], plane.c[2]});
  for (Real& v : result.c) v = v / most;
  const Real size = length({result.c[0], result.c[1], result.c[2]});
  for (Real& v : result.c) v = v / size;
  return result;
}

RealHalfSpace reversed(RealHalfSpace shape) {
  for (Real& v : shape.c) v = -v;
  return shape;
}

// The most that planes with unit normals are apart in a box.
Real planes_apart(const RealHalfSpace& a, const RealHalfSpace& b, const Box& box) {
  Real at_centre = a.c[3] - b.c[3];
  Real spread = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    at_centre += (a.c[i] - b.c[i]) * (box.low[i] + box.high[i]) / 2;
    spread += magnitude(a.c[i] - b.c[i]) * (box.high[i] - box.low[i]) / 2;
  }
  return magnitude(at_centre) + spread;
}

// The same coefficients but for their last bits.
bool are_same(const RealHalfSpace& a, const RealHalfSpace& b) {
  Real most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = larger(most, magnitude(a.c[i] - b.c[i]));
  return most <= power_of_two(-sameness_bits) * larger(1, magnitude(a.c[3]));
}

PlacedShape placed(const MatingSurface& surface) { return {surface.source->shape, *surface.inverse}; }

// Around `origin`, in units of `size`.
RealHalfSpace quadric_seen_from(const RealHalfSpace& quadric, const Vector3& origin, Real size) {
  RealHalfSpace result = quadric;
  auto& c = result.c;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real former = c[6 + i];
    for (std::size_t j = 0; j < 3; ++j) c[6 + i] += quadric.c[quadric_index[i][j]] * origin[j];
    c[9] += (former + c[6 + i]) * origin[i];
  }
  for (std::size_t i = 0; i < 9; ++i) c[i] *= i < 6 ? size * size : size;
  return normalised(result);
}

}  // namespace

std::size_t SurfaceMating::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 0;
  for (const std::int64_t part : key) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29;
  }
  return hash;
}

// Planes and quadrics share the cells: what they are compared by tells them apart.
SurfaceMating::Position SurfaceMating::position_of(const RealHalfSpace& shape) const {
  Position position{};
  if (shape.kind == HalfSpaceKind::plane) {
    for (std::size_t i = 0; i < 3; ++i) position[i] = shape.c[i] * cells_per_normal;
    position[3] = shape.c[3] + dot({shape.c[0], shape.c[1], shape.c[2]}, middle_);
    return position;
  }
  const RealHalfSpace seen = quadric_seen_from(shape, middle_, page_size_);
  for (std::size_t i = 0; i < 10; ++i) position[i] = seen.c[i] * cells_per_coefficient;
  return position;
}

std::optional<Real> SurfaceMating::plane_apart(const Candidate& candidate, const Leader& leader) {
  const RealHalfSpace& plane = candidate.surface.on_page;
  const RealHalfSpace& other = leader.surface.on_page;
  const bool one_body = std::any_of(candidate.bodies.begin(), candidate.bodies.end(),
                                    [&leader](std::uint32_t body) { return leader.bodies.count(body) != 0; });
  if (one_body && !are_same(plane, other)) return std::nullopt;
  return larger(planes_apart(plane, other, candidate.region.box), planes_apart(plane, other, leader.first.box));
}

std::optional<Real> SurfaceMating::quadric_apart(const Candidate& candidate, const Leader& leader) {
  const PlacedHalfSpace& source = *candidate.surface.source;
  const auto known = leader.family_member.find(source.place);
  const bool one_group = known != leader.family_member.end();
  if (one_group && known->second != std::pair(source.kin.family, source.kin.constant)) return std::nullopt;
  return quadric_distance(placed(leader.surface), placed(candidate.surface), candidate.region);
}

std::optional<Real> SurfaceMating::apart(const Candidate& candidate, const Leader& leader) {
  const RealHalfSpace& shape = candidate.surface.on_page;
  if (leader.surface.on_page.kind != shape.kind) return std::nullopt;
  for (std::size_t i = 0; i < 10; ++i) {
    if (magnitude(candidate.position[i] - leader.position[i]) > reach_of(shape, i)) return std::nullopt;
  }
  return shape.kind == HalfSpaceKind::plane ? plane_apart(candidate, leader) : quadric_apart(candidate, leader);
}

// Looks in the cells of the corners around the position: most often all one cell.
std::optional<SurfaceMating::Match> SurfaceMating::find(const Candidate& candidate) const {
  std::vector<Key> corners(1);
  for (std::size_t i = 0; i < 10; ++i) {
    const std::int64_t at = fine_cell(candidate.position[i]);
    const std::int64_t around = fine_reach(candidate.surface.on_page, i);
    const std::int64_t low = cell_of(at - around);
    const std::int64_t high = cell_of(at + around);
    const std::size_t count = corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      corners[k][i] = low;
      if (high == low) continue;
      corners.push_back(corners[k]);
      corners.back()[i] = high;
    }
  }
  std::optional<Match> best;
  for (const Key& key : corners) {
    const auto found = cells_.find(key);
    if (found == cells_.end()) continue;
    for (const std::size_t leader : found->second) {
      if (best && leader >= best->leader) continue;
      const auto distance = apart(candidate, leaders_[leader]);
      if (distance && *distance <= power_of_two(-agreement_bits)) best = Match{leader, false, *distance};
    }
  }
  return best;
}

void SurfaceMating::enlist(const Candidate& candidate, Leader& leader) {
  leader.all = around(leader.all, candidate.region);
  if (candidate.surface.on_page.kind == HalfSpaceKind::plane) {
    leader.bodies.insert(candidate.bodies.begin(), candidate.bodies.end());
  } else {
    const PlacedHalfSpace& source = *candidate.surface.source;
    leader.family_member.emplace(source.place, std::pair(source.kin.family, source.kin.constant));
  }
}

SurfaceMating::Match SurfaceMating::add(const MatingSurface& surface, const Region& region,
                                        const std::vector<std::uint32_t>& bodies) {
  const bool is_plane = surface.on_page.kind == HalfSpaceKind::plane;
  MatingSurface own = surface;
  if (is_plane) own.on_page = with_unit_normal(own.on_page);
  MatingSurface back = own;
  back.on_page = reversed(own.on_page);
  const Candidate as_written{own, position_of(own.on_page), region, bodies};
  Position opposed = as_written.position;
  for (Real& v : opposed) v = -v;
  const Candidate reversed_one{back, opposed, region, bodies};

  const auto same = find(as_written);
  const auto opposite = find(reversed_one);
  if (same || opposite) {
    const bool is_opposite = opposite && (!same || opposite->leader < same->leader);
    Match match = is_opposite ? *opposite : *same;
    match.opposite = is_opposite;
    enlist(as_written, leaders_[match.leader]);
    return match;
  }
  Key key{};
  for (std::size_t i = 0; i < 10; ++i) key[i] = cell_of(fine_cell(as_written.position[i]));
  cells_[key].push_back(leaders_.size());
  leaders_.push_back({own, as_written.position, region, region, {}, {}});
  enlist(as_written, leaders_.back());
  return {leaders_.size() - 1, false, 0};
}

}  // namespace halfspace
