// root_order.hpp - what surrounds a root of a form on a scan line: the form's other roots on the sheet, and the sheet's limb.
#pragma once

#include <cstdint>
#include <vector>

#include "host/resolve/line_root.hpp"
#include "host/resolve/sheet.hpp"
#include "host/resolve/sheet_form.hpp"

namespace halfspace {

struct Obstacle {
  LineRoot x;
  bool limb = false;  // d changes its sign here
  int rank = -1;      // of a root of the part that is followed: its number on the sheet
};

// Which form on which sheet: constraint `constraint` of the sheets, and the part of its n whose roots are counted.
struct FormOnSheet {
  const Sheets* sheets = nullptr;
  std::uint32_t constraint = 0;
  Sheet sheet = Sheet::only;
  KnownQuartic* part = nullptr;                // the table's
  const std::vector<Curve>* others = nullptr;  // the other factors of n

  [[nodiscard]] const Constraint& value() const { return sheets->constraints[constraint]; }
  [[nodiscard]] bool has_limb() const { return sheets->shape == SheetShape::two_sheets; }
};

// Ascending; distinct on lines where nothing befalls the form. Of a rational sheet, the part's own roots alone. `value` is the form's.
[[nodiscard]] std::vector<Obstacle> obstacles_on_line(const FormOnSheet& form, std::int64_t y,
                                                      const ValueOnLine& value);

}  // namespace halfspace
