// sheet_presence.hpp - is a point of a scan line on a sheet, with every other half-space holding there? Limits included.
// Exact  The point may be irrational (line_root.hpp). Intervals answer first; where they are not sure, signs of integers.
#pragma once

#include <cstdint>

#include "host/resolve/enclosed_sheet.hpp"
#include "host/resolve/row_point.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

class SheetPresence {
 public:
  // Keeps a reference to `sheets`.
  SheetPresence(const Sheets& sheets, Sheet sheet) : sheets_(sheets), sheet_(sheet), enclosed_(sheets, sheet) {}

  [[nodiscard]] bool shows_at(const RowPoint& x, std::int64_t y) const;

  // False: the sheet is hidden all over the box of the point, its edges included.
  [[nodiscard]] bool may_show(const IntervalPoint& point) const;

 private:
  [[nodiscard]] bool shows_exactly(const LineRoot& x, std::int64_t line, const Box* box) const;

  const Sheets& sheets_;
  Sheet sheet_;
  EnclosedSheet enclosed_;
};

}  // namespace halfspace
