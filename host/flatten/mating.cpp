#include "host/flatten/mating.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr int sameness_bits = 40;

// In dots. Where a plane's normal asks for a finer target than most have, this is finer as well.
Real agreement(const Region& region) { return smaller(power_of_two(-10), 16 * region.target); }

// Two shapes are neighbours where no coordinate differs by more than this.
constexpr Real normal_reach = 0x1p-10;
constexpr Real distance_reach = 0x1p-3;
const Real coefficient_reach = power_of_two(-sameness_bits);

Real reach_of(HalfSpaceKind kind, std::size_t coordinate) {
  if (kind == HalfSpaceKind::quadric) return coefficient_reach;
  return coordinate == 3 ? distance_reach : normal_reach;
}

// The grid's cells are 16 times as wide, 8 times for the distance of a plane, and the first reaches half its width to either side.
double cells_per_unit(HalfSpaceKind kind, std::size_t coordinate) {
  if (kind == HalfSpaceKind::quadric) return 0x1p36;
  return coordinate == 3 ? 1 : 64;
}

// Cells of a coordinate's size, whichever its sign, and of its neighbours. The size is right to 2^-53 of itself: 2^-10 of a cell up to
// 2^43 cells, and all that is further off has one cell.
struct CellRange {
  std::int64_t at, low, high;
};
CellRange cells_around(HalfSpaceKind kind, std::size_t coordinate, Real v) {
  if (is_zero(v)) return {0, 0, 0};
  const double cells = cells_per_unit(kind, coordinate);
  const double size = std::min(std::abs(static_cast<double>(v)) * cells, 0x1p43) + 0.5;
  const double reach = static_cast<double>(reach_of(kind, coordinate)) * cells + 0x1p-9;
  const auto cell = [](double at) { return static_cast<std::int64_t>(at); };  // none is negative
  return {cell(size), cell(size - reach), cell(size + reach)};
}

RealHalfSpace with_unit_normal(const RealHalfSpace& plane) {
  RealHalfSpace result = plane;
  const Real most = largest({plane.c[0], plane.c[1], plane.c[2]});
  for (Real& v : result.c) v = v / most;
  const Real size = length({result.c[0], result.c[1], result.c[2]});
  for (Real& v : result.c) v = v / size;
  return result;
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
    for (std::size_t j = 0; j < 3; ++j) add_product(c[6 + i], quadric.c[quadric_index[i][j]], origin[j]);
    add_product(c[9], former + c[6 + i], origin[i]);
  }
  const Real square = size * size;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!is_zero(c[i])) c[i] *= i < 6 ? square : size;
  }
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

SurfaceMating::Position SurfaceMating::position_of(const RealHalfSpace& shape) const {
  if (shape.kind == HalfSpaceKind::quadric) return quadric_seen_from(shape, middle_, page_size_).c;
  Position position{};
  std::copy_n(shape.c.begin(), 3, position.begin());
  position[3] = shape.c[3] + dot({shape.c[0], shape.c[1], shape.c[2]}, middle_);
  return position;
}

SurfaceMating::Candidate SurfaceMating::reversed(Candidate candidate) {
  for (Real& v : candidate.surface.on_page.c) v = -v;
  for (Real& v : candidate.position) v = -v;
  return candidate;
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
    if (magnitude(candidate.position[i] - leader.position[i]) > reach_of(shape.kind, i)) return std::nullopt;
  }
  return shape.kind == HalfSpaceKind::plane ? plane_apart(candidate, leader) : quadric_apart(candidate, leader);
}

void SurfaceMating::offer(const Candidate& candidate, std::size_t leader, bool opposite,
                          std::optional<Match>& best) const {
  if (best && leader >= best->leader) return;
  const auto distance = apart(candidate, leaders_[leader]);
  if (distance && *distance <= agreement(candidate.region)) best = Match{leader, opposite, *distance};
}

// The first leader that agrees, as it is written if both ways do. Cells do not tell a surface from its reverse; neighbours lie in those
// of the corners around the position, most often all one cell.
std::optional<SurfaceMating::Match> SurfaceMating::find(const Candidate& candidate) const {
  Key low{};
  Key high{};
  unsigned split = 0;  // which coordinates
  for (std::size_t i = 0; i < 10; ++i) {
    const CellRange cells = cells_around(candidate.surface.on_page.kind, i, candidate.position[i]);
    low[i] = cells.low;
    high[i] = cells.high;
    if (low[i] != high[i]) split |= 1U << i;
  }
  std::optional<Match> best;
  for (unsigned upper = split;; upper = (upper - 1) & split) {
    Key key = low;
    for (std::size_t i = 0; i < 10; ++i) {
      if ((upper >> i & 1U) != 0) key[i] = high[i];
    }
    if (const auto found = cells_.find(key); found != cells_.end()) {
      for (const std::size_t leader : found->second) {
        offer(candidate, leader, false, best);
        offer(reversed(candidate), leader, true, best);
      }
    }
    if (upper == 0) return best;
  }
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
  const HalfSpaceKind kind = surface.on_page.kind;
  MatingSurface own = surface;
  if (kind == HalfSpaceKind::plane) own.on_page = with_unit_normal(own.on_page);
  const Candidate candidate{own, position_of(own.on_page), region, bodies};
  if (const auto match = find(candidate)) {
    enlist(candidate, leaders_[match->leader]);
    return *match;
  }
  Key key{};
  for (std::size_t i = 0; i < 10; ++i) key[i] = cells_around(kind, i, candidate.position[i]).at;
  cells_[key].push_back(leaders_.size());
  leaders_.push_back({own, candidate.position, region, region, {}, {}});
  enlist(candidate, leaders_.back());
  return {leaders_.size() - 1, false, 0};
}

}  // namespace halfspace
