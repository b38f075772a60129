// arc_table.hpp - the arcs of one body, each stored once however many faces it bounds.
// A face names a boundary by curve, branch and sign; the lines on which faces use a name are collected, and runs of lines that
// touch become one arc. So every line of an arc is a line on which some cell proved that the branch exists.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

struct ArcName {
  std::uint32_t curve = no_arc;  // no_arc: the cell is not bounded on this side
  Branch branch = Branch::single;
  bool negated = false;
  int shift = 0;  // added to a line's value: +-1 moves a boundary that is itself excluded past the dots on it

  friend bool operator==(const ArcName&, const ArcName&) = default;
  friend bool operator<(const ArcName& a, const ArcName& b) {
    return std::tie(a.curve, a.branch, a.negated, a.shift) < std::tie(b.curve, b.branch, b.negated, b.shift);
  }
};

class ArcTable {
 public:
  [[nodiscard]] std::uint32_t curve_index(const Curve& curve);
  void use(const ArcName& name, std::int32_t y0, std::int32_t y1);  // page scan lines
  void join_uses(std::uint32_t body, std::vector<Arc>& arcs);       // once, after every use
  [[nodiscard]] std::uint32_t arc(const ArcName& name, std::int32_t y) const;

 private:
  struct Run {
    std::int32_t y0, y1;
    std::uint32_t arc;
  };
  [[nodiscard]] Curve curve_of(const ArcName& name) const;

  std::vector<Curve> curves_;
  std::map<ArcName, std::vector<Run>> runs_;
};

}  // namespace halfspace
