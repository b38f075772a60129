// sheet_presence.hpp - is a point of a scan line on a sheet, with every other half-space holding there? Limits included.
// Exact  The point may be irrational (line_root.hpp). Intervals answer first; where they are not sure, signs of integers.
#pragma once

#include <cstdint>

#include "host/resolve/enclosed_sheet.hpp"
#include "host/resolve/row_point.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

class PresenceOnLine;

class SheetPresence {
 public:
  // Keeps a reference to `sheets`.
  SheetPresence(const Sheets& sheets, Sheet sheet) : sheets_(sheets), sheet_(sheet), enclosed_(sheets, sheet) {}

  // False: the sheet is hidden all over the box of the point, its edges included.
  [[nodiscard]] bool may_show(const IntervalPoint& point) const;

 private:
  friend class PresenceOnLine;

  const Sheets& sheets_;
  Sheet sheet_;
  EnclosedSheet enclosed_;
};

class PresenceOnLine {
 public:
  // Keeps a reference to `presence`.
  PresenceOnLine(const SheetPresence& presence, std::int64_t y);

  // What hides the point (enclosed_sheet.hpp).
  [[nodiscard]] int hider_at(const RowPoint& x) const;

 private:
  [[nodiscard]] int exact_hider(const LineRoot& x, const Interval* near) const;

  const SheetPresence& presence_;
  std::int64_t y_;
  SheetOnLine enclosed_;
};

}  // namespace halfspace
