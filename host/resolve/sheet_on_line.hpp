// sheet_on_line.hpp - is a point of one scan line on a sheet, with every other half-space holding there?
// Exact  The point may be irrational; see line_root.hpp. Nothing is approximated.
#pragma once

#include <vector>

#include "host/resolve/line_root.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

// c2 x^2 + c1 x + c0 on the scan line y.
[[nodiscard]] LinePolynomial restricted(const Curve& p, const mpz_class& y);

class SheetOnLine {
 public:
  SheetOnLine(const Sheets& sheets, const mpz_class& y);

  // Closed: the sheet exists at x and every constraint is <= 0 there.
  [[nodiscard]] bool shows_at(const LineRoot& x, Sheet sheet) const;

 private:
  struct ConstraintOnLine {
    int sense;
    LinePolynomial p, r;  // rational sheets: c' and b' of the other surface, and its a'
    mpz_class a;
  };

  [[nodiscard]] bool shows_on_two_sheets(const LinePoint& x, int t) const;
  [[nodiscard]] bool shows_on_flat(const LinePoint& x) const;
  [[nodiscard]] bool shows_on_rational(const LinePoint& x) const;

  SheetShape shape_;
  LinePolynomial d_, b_, c_;
  std::vector<ConstraintOnLine> constraints_;
};

}  // namespace halfspace
