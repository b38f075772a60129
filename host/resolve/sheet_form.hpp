// sheet_form.hpp - the exact sign of a constraint's value on the sheets, along one scan line.
//   P + t R sqrt(d)   has the sign of P or of t R sqrt(d) where these agree, else that of P times the sign of P^2 - R^2 d
// Exact  In intervals where these are sure, else by signs of polynomials in x at an algebraic number (line_root.hpp).
#pragma once

#include <optional>

#include "host/resolve/enclosed_sheet.hpp"
#include "host/resolve/line_root.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

// P, R and d with rounded coefficients, for all lines.
struct EnclosedForm {
  EnclosedForm(const Sheets& sheets, const Constraint& k);
  EnclosedCurve p, r, d;
};

class ValueOnLine {
 public:
  // Keeps references to the sheets and the constraint. `near`: of the same, on two sheets.
  ValueOnLine(const Sheets& sheets, const Constraint& k, long y, const EnclosedForm* near = nullptr);

  // At a point where the sheet exists.
  [[nodiscard]] int sign(Sheet sheet, const LineRoot& x) const;

  // At a root of the constraint's n: does the sheet exist there, and is the value 0 on this one of the two?
  [[nodiscard]] bool vanishes(Sheet sheet, const LineRoot& root) const;

 private:
  struct OnLine {
    QuadraticOnLine p, r, d;
  };
  struct Exact {
    AskedPolynomial p, r, d;
  };
  // Nothing where the line is not enclosed.
  [[nodiscard]] const OnLine* near(const LineRoot& x) const;
  [[nodiscard]] const Exact& exact() const;

  const Sheets* sheets_;
  const Constraint* constraint_;
  long y_;
  std::optional<OnLine> near_;
  mutable std::optional<Exact> exact_;
};

}  // namespace halfspace
