// sheet_form.hpp - the exact sign of a constraint's value on the sheets, along one scan line.
//   P + t R sqrt(d)   has the sign of P or of t R sqrt(d) where these agree, else that of P times the sign of P^2 - R^2 d
// Exact  By signs of polynomials in x at an algebraic number (line_root.hpp).
#pragma once

#include "host/resolve/line_root.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

class ValueOnLine {
 public:
  ValueOnLine(const Sheets& sheets, const Constraint& k, const mpz_class& y);

  // At a point where the sheet exists.
  [[nodiscard]] int sign(Sheet sheet, const LineRoot& x) const;

  // At a root of the constraint's n: does the sheet exist there, and is the value 0 on this one of the two?
  [[nodiscard]] bool vanishes(Sheet sheet, const LineRoot& root) const;

 private:
  bool two_sheets_;
  AskedPolynomial p_, r_, d_;
};

}  // namespace halfspace
