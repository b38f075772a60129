#include "host/flatten/mating.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
constexpr double cells_per_unit(HalfSpaceKind kind, std::size_t coordinate) {
  if (kind == HalfSpaceKind::quadric) return 0x1p36;
  return coordinate == 3 ? 1 : 64;
}

constexpr double reach_in_cells(HalfSpaceKind kind, std::size_t coordinate) {
  return kind == HalfSpaceKind::plane && coordinate == 3 ? 0x1p-3 : 0x1p-4;
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

// The same to within 2^-44, or none: a sum in doubles is off by less than 2^-49 of its terms, and so is what all are divided by.
std::optional<std::array<double, 10>> near_quadric_seen_from(const RealHalfSpace& quadric, const Vector3& origin,
                                                             Real size) {
  std::array<double, 10> c{};
  std::array<double, 10> terms{};  // sums of sizes
  for (std::size_t i = 0; i < 10; ++i) {
    c[i] = static_cast<double>(quadric.c[i]);
    terms[i] = std::abs(c[i]);
  }
  std::array<double, 3> at{};
  std::transform(origin.begin(), origin.end(), at.begin(), [](Real v) { return static_cast<double>(v); });
  for (std::size_t i = 0; i < 3; ++i) {
    const double former = c[6 + i];
    const double former_terms = terms[6 + i];
    for (std::size_t j = 0; j < 3; ++j) {
      const double part = c[quadric_index[i][j]] * at[j];
      c[6 + i] += part;
      terms[6 + i] += std::abs(part);
    }
    c[9] += (former + c[6 + i]) * at[i];
    terms[9] += (former_terms + terms[6 + i]) * std::abs(at[i]);
  }
  const auto unit = static_cast<double>(size);
  double most = 0;
  double most_terms = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    const double scale = i < 6 ? unit * unit : i < 9 ? unit : 1;
    c[i] *= scale;
    most = std::max(most, std::abs(c[i]));
    most_terms = std::max(most_terms, terms[i] * scale);
  }
  if (!(most_terms <= 16 * most)) return std::nullopt;
  for (double& v : c) v /= most;
  return c;
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

// Whichever its sign. A size is right to 2^-53 of itself, which is 2^-10 of a cell up to 2^43 cells, or to 2^-8 of a cell: all that is
// further off, or no number, has one cell.
SurfaceMating::CellRange SurfaceMating::cells_around(HalfSpaceKind kind, std::size_t coordinate, double v) {
  if (v == 0) return {0, 0, 0};
  const double cells = cells_per_unit(kind, coordinate);
  constexpr double far = 0x1p43;
  const double size = (std::abs(v) * cells < far ? std::abs(v) * cells : far) + 0.5;
  const double reach = reach_in_cells(kind, coordinate) + 0x1p-6;
  const auto cell = [](double at) { return static_cast<std::int64_t>(at); };  // none is negative
  return {cell(size), cell(size - reach), cell(size + reach)};
}

SurfaceMating::Cells SurfaceMating::cells_of(const RealHalfSpace& shape) const {
  std::optional<std::array<double, 10>> near;
  if (shape.kind == HalfSpaceKind::quadric) near = near_quadric_seen_from(shape, middle_, page_size_);
  if (!near) {
    const Position position = position_of(shape);
    near.emplace();
    std::transform(position.begin(), position.end(), near->begin(), [](Real v) { return static_cast<double>(v); });
  }
  Cells cells{};
  for (std::size_t i = 0; i < 10; ++i) cells[i] = cells_around(shape.kind, i, (*near)[i]);
  return cells;
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

// What of a group's quadrics joined, if one did.
std::optional<SurfaceMating::FamilyMember> SurfaceMating::member_of(const Leader& leader, std::size_t place) {
  const PlacedHalfSpace& first = *leader.surface.source;
  if (first.place == place) return FamilyMember(first.kin.family, first.kin.constant);
  const auto known = leader.family_members.find(place);
  return known == leader.family_members.end() ? std::nullopt : std::optional(known->second);
}

std::optional<Real> SurfaceMating::quadric_apart(const Candidate& candidate, const Leader& leader) {
  const PlacedHalfSpace& source = *candidate.surface.source;
  const auto known = member_of(leader, source.place);
  if (known && *known != FamilyMember(source.kin.family, source.kin.constant)) return std::nullopt;
  return quadric_distance(placed(leader.surface), placed(candidate.surface), candidate.region);
}

std::optional<Real> SurfaceMating::apart(const Candidate& candidate, Leader& leader) const {
  const RealHalfSpace& shape = candidate.surface.on_page;
  if (leader.surface.on_page.kind != shape.kind) return std::nullopt;
  if (!leader.position) leader.position = position_of(leader.surface.on_page);
  for (std::size_t i = 0; i < 10; ++i) {
    if (magnitude(candidate.position[i] - (*leader.position)[i]) > reach_of(shape.kind, i)) return std::nullopt;
  }
  return shape.kind == HalfSpaceKind::plane ? plane_apart(candidate, leader) : quadric_apart(candidate, leader);
}

void SurfaceMating::offer(const Candidate& candidate, std::size_t leader, bool opposite, std::optional<Match>& best) {
  if (best && leader >= best->leader) return;
  const auto distance = apart(candidate, leaders_[leader]);
  if (distance && *distance <= agreement(candidate.region)) best = Match{leader, opposite, *distance};
}

// The first leader that agrees, as it is written if both ways do. Cells do not tell a surface from its reverse; neighbours lie in those
// of the corners around the position, most often all one cell.
std::optional<SurfaceMating::Match> SurfaceMating::find(const MatingSurface& surface, const Cells& cells,
                                                        const Region& region, std::span<const std::uint32_t> bodies) {
  Key low{};
  unsigned split = 0;  // which coordinates
  for (std::size_t i = 0; i < 10; ++i) {
    low[i] = cells[i].low;
    if (cells[i].low != cells[i].high) split |= 1U << i;
  }
  std::optional<Candidate> candidate;
  std::optional<Match> best;
  for (unsigned upper = split;; upper = (upper - 1) & split) {
    Key key = low;
    for (std::size_t i = 0; i < 10; ++i) {
      if ((upper >> i & 1U) != 0) key[i] = cells[i].high;
    }
    if (const auto found = cells_.find(key); found != cells_.end()) {
      if (!candidate) candidate.emplace(Candidate{surface, position_of(surface.on_page), region, bodies});
      for (std::size_t leader = found->second.first; leader != no_leader; leader = leaders_[leader].next) {
        offer(*candidate, leader, false, best);
        offer(reversed(*candidate), leader, true, best);
      }
    }
    if (upper == 0) return best;
  }
}

void SurfaceMating::enlist(const MatingSurface& surface, std::span<const std::uint32_t> bodies, Leader& leader) {
  const PlacedHalfSpace& source = *surface.source;
  if (surface.on_page.kind == HalfSpaceKind::plane) {
    leader.bodies.insert(bodies.begin(), bodies.end());
  } else if (source.place != leader.surface.source->place) {
    leader.family_members.emplace(source.place, FamilyMember(source.kin.family, source.kin.constant));
  }
}

void SurfaceMating::add_to_cell(const Cells& cells, std::size_t leader) {
  Key key{};
  std::transform(cells.begin(), cells.end(), key.begin(), [](const CellRange& range) { return range.at; });
  const auto [entry, is_new] = cells_.try_emplace(key, Cell{leader, leader});
  if (is_new) return;
  leaders_[std::exchange(entry->second.last, leader)].next = leader;
}

SurfaceMating::Match SurfaceMating::add(const MatingSurface& surface, const Region& region,
                                        std::span<const std::uint32_t> bodies) {
  MatingSurface own = surface;
  if (own.on_page.kind == HalfSpaceKind::plane) own.on_page = with_unit_normal(own.on_page);
  const Cells cells = cells_of(own.on_page);
  if (const auto match = find(own, cells, region, bodies)) {
    Leader& leader = leaders_[match->leader];
    leader.all = around(leader.all, region);
    enlist(own, bodies, leader);
    return *match;
  }
  const std::size_t leader = leaders_.size();
  leaders_.emplace_back(own, region);
  enlist(own, bodies, leaders_.back());
  add_to_cell(cells, leader);
  return {leader, false, 0};
}

}  // namespace halfspace
