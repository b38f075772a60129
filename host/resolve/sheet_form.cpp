#include "host/resolve/sheet_form.hpp"

namespace halfspace {
namespace {

int factor_of(Sheet sheet) { return sheet == Sheet::front ? -1 : 1; }

// a' c^2 - b' b c + c' b^2
Polynomial rational_form(const Surface& own, const Surface& k, const mpz_class& y) {
  const Polynomial b = restricted(own.b, y);
  const Polynomial c = restricted(own.c, y);
  const Polynomial mixed = times(times(restricted(k.b, y), b), c);
  return plus(minus(times({k.a}, times(c, c)), mixed), times(restricted(k.c, y), times(b, b)));
}

}  // namespace

ValueOnLine::ValueOnLine(const Sheets& sheets, const Constraint& k, const mpz_class& y)
    : two_sheets_(sheets.shape == SheetShape::two_sheets) {
  if (sheets.shape == SheetShape::rational) {
    p_ = AskedPolynomial(rational_form(sheets.surface, k.surface, y));
    return;
  }
  p_ = AskedPolynomial(restricted(k.p, y));
  if (!two_sheets_) return;
  r_ = AskedPolynomial(restricted(k.r, y));
  d_ = AskedPolynomial(restricted(sheets.d, y));
}

int ValueOnLine::sign(Sheet sheet, const LineRoot& x) const {
  const int sign_p = p_.sign_at(x);
  if (!two_sheets_) return sign_p;
  const int sign_r = factor_of(sheet) * r_.sign_at(x);
  if (sign_r == 0 || sign_r == sign_p) return sign_p;
  const int sign_root = sign_r * d_.sign_at(x);
  if (sign_p * sign_root >= 0) return sign_p != 0 ? sign_p : sign_root;
  const Polynomial& p = p_.exact();
  const Polynomial& r = r_.exact();
  return sign_p * sign_at(minus(times(p, p), times(times(r, r), d_.exact())), x);
}

bool ValueOnLine::vanishes(Sheet sheet, const LineRoot& root) const {
  if (!two_sheets_) return true;
  const int sign_d = d_.sign_at(root);
  if (sign_d <= 0) return sign_d == 0;
  return p_.sign_at(root) == -factor_of(sheet) * r_.sign_at(root);
}

}  // namespace halfspace
