// arc_table.hpp - the arcs of one body, each stored once however many faces it bounds.
// A face names a boundary by curve, branch and sign; the lines on which faces use a name are collected, and runs of lines that
// touch become one arc, or several where one guide does not do. So every line of an arc is a line on which some cell proved that the
// branch exists. One table serves the bodies one after another.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "host/resolve/arc_guide.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

struct ArcName {
  std::uint32_t curve = no_arc;  // no_arc: the cell is not bounded on this side
  Branch branch = Branch::single;
  bool negated = false;
  int shift = 0;        // added to a line's value: +-1 moves a boundary that is itself excluded past the dots on it
  bool guided = false;  // then `curve` counts the guides, and `rank` their roots on a line
  std::uint32_t rank = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): the zero is in what the compiler writes
  friend auto operator<=>(const ArcName&, const ArcName&) = default;
};

class ArcTable {
 public:
  // Forgets the arcs of the body before it, but keeps their memory. Lines are page lines here, local ones in a guide.
  void start_body(std::int64_t origin_y);

  // Keeps a pointer.
  [[nodiscard]] std::uint32_t curve_index(const Curve& curve);
  [[nodiscard]] std::uint32_t add_guide(const FormOnSheet& form);
  void use(const ArcName& name, std::int32_t y0, std::int32_t y1);
  void join_uses(std::uint32_t body, const DotExtent& extent, std::vector<Arc>& arcs);  // once, after every use

  // The arc on line y and its last line; no_arc for a side without one.
  struct Piece {
    std::uint32_t arc = no_arc;
    std::int32_t y1 = std::numeric_limits<std::int32_t>::max();
  };
  [[nodiscard]] Piece piece(const ArcName& name, std::int32_t y) const;

 private:
  struct Run {
    ArcName name;
    std::int32_t y0, y1;
    std::uint32_t arc;
  };
  void append_arcs(const Run& run, std::map<std::uint32_t, ArcGuide>& guides, const DotExtent& extent,
                   std::vector<Arc>& arcs) const;

  std::int64_t origin_y_ = 0;
  std::vector<const Curve*> curves_;
  std::vector<FormOnSheet> guided_;
  std::vector<Run> uses_;
  std::vector<Run> runs_;  // the arcs' own, by name and line
};

}  // namespace halfspace
