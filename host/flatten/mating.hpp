// mating.hpp - half-spaces that have the same surface, so that what touches in the scene touches in the integers.
// Rule     A surface joins the first one before it, written either way round and with any factor, from which it is nowhere
//          further than 2^-10 dot (or 16 targets, if that is less) in its bodies' boxes; else it stands for itself and for those
//          to come. For planes the boxes of the first count too.
//          Planes of one body join only if they are the same but for the last bits: in a body as thin as a line, two that cross
//          there would agree too. Quadrics of one group join only if their decimals are in proportion: shells stay two.
// Cost     A hash grid, linear in the surfaces. So those are found that are neighbours there: planes by unit normal, within
//          2^-10, and distance from the page's middle, within 1/8 dot, which leaves out only bodies under a dot across, or some
//          hundred times further from the middle than they are large; quadrics by their coefficients where the page is
//          of size 1, within 2^-40 of the largest: what the same numbers are that were written with a dozen digits.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "host/flatten/placement.hpp"
#include "host/flatten/quantise.hpp"

namespace halfspace {

// What joins: a half-space with a surface, in the dot frame and as its statement says.
struct MatingSurface {
  RealHalfSpace on_page;
  const PlacedHalfSpace* source = nullptr;  // outlives the mating, as does the matrix of its place
  const Matrix4* inverse = nullptr;
};

class SurfaceMating {
 public:
  struct Match {
    std::size_t leader = 0;  // numbered from 0 in the order of appearance
    bool opposite = false;   // the leader is written the other way round
    Real apart = 0;          // dots: how far it is from the leader in its own region
  };

  // Of a page of this size, whose middle is at vrp's depth. `surfaces` are expected.
  SurfaceMating(const Vector3& middle, Real page_size, std::size_t surfaces = 0)
      : middle_(middle), page_size_(page_size) {
    leaders_.reserve(surfaces);
    cells_.reserve(surfaces);
  }

  // `bodies` use it.
  Match add(const MatingSurface& surface, const Region& region, std::span<const std::uint32_t> bodies);

  // Of all that joined the leader.
  [[nodiscard]] const Region& region_of(std::size_t leader) const { return leaders_[leader].all; }
  [[nodiscard]] std::size_t count() const { return leaders_.size(); }

 private:
  // Cells of a coordinate's size, and of its neighbours.
  struct CellRange {
    std::int64_t at, low, high;
  };
  using Cells = std::array<CellRange, 10>;
  using Key = std::array<std::int64_t, 10>;
  using Position = std::array<Real, 10>;  // what neighbours agree in
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Candidate {
    MatingSurface surface;
    Position position;
    const Region& region;
    std::span<const std::uint32_t> bodies;
  };
  using FamilyMember = std::pair<std::size_t, Real>;
  struct Leader {
    Leader(const MatingSurface& own, const Region& region) : surface(own), first(region), all(region) {}

    MatingSurface surface;
    std::optional<Position> position;  // where it was asked for
    Region first;                      // of its own bodies
    Region all;
    std::unordered_set<std::uint32_t> bodies;            // of all planes that joined
    std::map<std::size_t, FamilyMember> family_members;  // of the other groups whose quadrics joined
    std::size_t next = no_leader;                        // in the cell
  };
  struct Cell {
    std::size_t first = no_leader, last = no_leader;  // leaders
  };
  static constexpr std::size_t no_leader = static_cast<std::size_t>(-1);

  [[nodiscard]] Position position_of(const RealHalfSpace& shape) const;
  [[nodiscard]] static CellRange cells_around(HalfSpaceKind kind, std::size_t coordinate, double v);
  // In doubles where these will do.
  [[nodiscard]] Cells cells_of(const RealHalfSpace& shape) const;
  [[nodiscard]] static Candidate reversed(Candidate candidate);
  [[nodiscard]] std::optional<Match> find(const MatingSurface& surface, const Cells& cells, const Region& region,
                                          std::span<const std::uint32_t> bodies);
  // Takes the leader if it agrees and comes before the best so far.
  void offer(const Candidate& candidate, std::size_t leader, bool opposite, std::optional<Match>& best);
  // None where the two have to stay two.
  [[nodiscard]] std::optional<Real> apart(const Candidate& candidate, Leader& leader) const;
  [[nodiscard]] static std::optional<Real> plane_apart(const Candidate& candidate, const Leader& leader);
  [[nodiscard]] static std::optional<Real> quadric_apart(const Candidate& candidate, const Leader& leader);
  [[nodiscard]] static std::optional<FamilyMember> member_of(const Leader& leader, std::size_t place);
  static void enlist(const MatingSurface& surface, std::span<const std::uint32_t> bodies, Leader& leader);
  void add_to_cell(const Cells& cells, std::size_t leader);

  Vector3 middle_;
  Real page_size_;
  std::vector<Leader> leaders_;
  std::unordered_map<Key, Cell, KeyHash> cells_;
};

}  // namespace halfspace
