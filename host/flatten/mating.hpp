// mating.hpp - planes that agree within 2^-10 dot over their bodies become one plane, so that no crack opens.
// Rule     A plane joins the first one before it, written either way round, from which it is nowhere further than
//          2^-10 dot in the boxes of both; else it stands for itself and for those to come. Planes of one body join only if
//          they are the same but for the last bits: in a body as thin as a line, two that cross there would agree too.
// Cost     A hash grid of unit normals and distances from the page's middle: linear in the planes. So planes are found
//          whose normals differ by less than 2^-10 and whose distances there by less than 1/8 dot, which leaves out
//          only bodies under a dot across, or some hundred times further from the middle than they are large.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "host/flatten/local_box.hpp"

namespace halfspace {

class PlaneMating {
 public:
  struct Match {
    std::size_t leader = 0;  // numbered from 0 in the order of appearance
    bool opposite = false;   // the leader is written the other way round
  };
  struct Leader {
    RealHalfSpace plane;                       // unit normal
    Box first;                                 // of its own body
    Region all;                                // of all that joined
    std::unordered_set<std::uint32_t> bodies;  // of all that joined
  };

  explicit PlaneMating(const Vector3& middle) : middle_(middle) {}

  // The plane has a normal.
  // `bodies` use it.
  Match add(const RealHalfSpace& plane, const Region& region, const std::vector<std::uint32_t>& bodies);

  [[nodiscard]] const std::vector<Leader>& leaders() const { return leaders_; }

 private:
  using Key = std::array<std::int64_t, 4>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  [[nodiscard]] Vector4 position_of(const RealHalfSpace& plane) const;
  [[nodiscard]] std::size_t find(const RealHalfSpace& plane, const Box& box,
                                 const std::vector<std::uint32_t>& bodies) const;

  Vector3 middle_;
  std::vector<Leader> leaders_;
  std::unordered_map<Key, std::vector<std::size_t>, KeyHash> cells_;
};

}  // namespace halfspace
