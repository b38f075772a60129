// extent_filter.hpp - the candidates of extent.cpp in intervals of doubles: which are certain to change nothing, because a half-space
// excludes them or they are inside the box of the points already found, and about where the others lie.
// Certain  Every term's margin (2^-51 of it) is far wider than what extent.cpp's roundings in Real make of it (2^-112), so an
//          interval holds what Real gets, and what is told here is so there. Where no slack is allowed nothing else may be dropped:
//          extents, and with them scenes that are fitted to the page, are those without the filter, to the bit.
// Cost     A tenth of Real's.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "host/flatten/extent.hpp"
#include "host/flatten/interval.hpp"
#include "host/flatten/matrix.hpp"

namespace halfspace {

using IntervalVector = std::array<Interval, 3>;

[[nodiscard]] Interval enclosure(Real v);

// normal . x + offset = 0, of any scale.
struct IntervalPlane {
  IntervalVector normal{};
  Interval offset;
};
[[nodiscard]] IntervalVector enclosure(const Vector3& v);
[[nodiscard]] IntervalPlane enclosure(const Vector3& normal, Real offset);

struct IntervalLine {
  IntervalVector point{}, direction{};  // direction of any length
};

// None: the planes may be parallel.
[[nodiscard]] std::optional<IntervalLine> meeting_line(const IntervalPlane& a, const IntervalPlane& b);

class ExtentFilter {
 public:
  // `tolerance`: how far above 0, relative to its terms, a value still counts as 0.
  ExtentFilter(std::span<const Side> sides, double tolerance);

  using Owners = std::initializer_list<std::size_t>;  // sides that the point lies on by construction

  // What has been found so far.
  void set_box(const Box& box);

  // Points that may be needed. None: that cannot be told.
  struct Points {
    std::size_t count = 0;
    std::array<IntervalVector, 2> at;
  };
  using Found = std::optional<Points>;
  [[nodiscard]] Found on_plane(const IntervalLine& line, const IntervalPlane& plane, Owners on) const;
  [[nodiscard]] Found on_quadric(const IntervalLine& line, std::size_t quadric, Owners on) const;

  // Does a side hold at it, or fail: none, if that cannot be told.
  [[nodiscard]] bool is_in_box(const IntervalVector& p) const;
  [[nodiscard]] std::optional<bool> holds_at(std::size_t side, const IntervalVector& p) const;

  // Does the body end along d and along -d?
  [[nodiscard]] bool ends_along(const IntervalVector& d) const;
  // Along the directions u, v and those of the plane of u and v on the quadrics' asymptotic cones?
  [[nodiscard]] bool ends_in_plane(const IntervalVector& u, const IntervalVector& v,
                                   std::span<const std::size_t> quadrics) const;

 private:
  // Signed so that the value is negative inside.
  struct FilterSide {
    bool is_plane = false;
    std::array<Interval, 10> c;
    double size = 0;  // of the coefficients that decide far out
  };
  [[nodiscard]] bool drops(const IntervalVector& p, Owners on) const;
  [[nodiscard]] bool drops_beyond(const IntervalLine& line, double t, Owners on) const;
  [[nodiscard]] bool forbids(const FilterSide& side, const IntervalVector& d) const;

  double tolerance_;
  std::vector<FilterSide> sides_;
  std::optional<std::array<Interval, 3>> inside_;  // the box, from above its low to below its high corner
};

}  // namespace halfspace
