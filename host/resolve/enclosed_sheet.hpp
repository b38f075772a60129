// enclosed_sheet.hpp - the forms of sheet.hpp over a box of the page or along a scan line, in intervals: quick answers that are never wrong.
// Used as the filter before exact signs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/flatten/interval.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

// Local dots; any doubles with x0 <= x1, y0 <= y1.
struct DotBox {
  double x0, y0, x1, y1;
};

// A quadratic a x^2 + b x + c on one scan line; b and c are sums, whose terms' sizes add up to size_of_b and size_of_c. `over` adds a bound for
// every rounding: centre and radius, half the work of operations on intervals.
class QuadraticOnLine {
 public:
  QuadraticOnLine() = default;
  QuadraticOnLine(double a, double b, double c, double size_of_b, double size_of_c)
      : a_(a), b_(b), c_(c), size_of_b_(size_of_b), size_of_c_(size_of_c) {}
  [[nodiscard]] Interval over(const Interval& x) const;

 private:
  double a_ = 0, b_ = 0, c_ = 0, size_of_b_ = 0, size_of_c_ = 0;
};

// A curve's polynomial with rounded coefficients, all divided by the same power of two so that they are at most 1. Bounded as above.
class EnclosedCurve {
 public:
  EnclosedCurve() = default;
  EnclosedCurve(const Curve& p, long exponent);
  [[nodiscard]] Interval over(const DotBox& box) const;
  [[nodiscard]] QuadraticOnLine on_line(double y) const;

 private:
  std::array<double, 6> q_{};
};

// What hides a point: nothing, the sheet itself, which is missing there, or the constraint of that index, which fails.
inline constexpr int nothing_hides = -1;
inline constexpr int sheet_hides = -2;

enum class Verdict : std::uint8_t { nowhere, everywhere, unsure };

// A sheet and its constraints over places: boxes of the page, or intervals of a scan line.
template <class Form, class Place>
class SheetForms {
 public:
  // Where in the place does the sheet exist with every constraint holding?
  [[nodiscard]] Verdict shows_over(const Place& place) const;
  // What hid the last place that was nowhere.
  [[nodiscard]] int last_hider() const { return last_hider_; }

  // The same in parts, for what is asked exactly otherwise: does the sheet exist all over the place, does a constraint hold wherever it
  // does?
  [[nodiscard]] bool surely_exists(const Place& place) const { return own_forms(place).exists; }
  [[nodiscard]] bool surely_holds(std::size_t constraint, const Place& place) const;

  // Does the constraint hold, and is not 0, wherever in the place the sheet exists with the others holding?
  [[nodiscard]] bool implies(std::size_t constraint, const Place& place) const;

 protected:
  struct ConstraintForm {
    int sense = 1;
    Form p, r;  // rational sheets: c' and b' of the other surface, and its a'
    Interval a;
  };
  // The own forms over one place.
  struct Own {
    Interval d, root, b, c;  // the root is for the constraints
    bool exists = false;     // surely
  };
  [[nodiscard]] Interval value_of(const ConstraintForm& k, const Own& own, const Place& place) const;
  [[nodiscard]] static bool is_held(const ConstraintForm& k, const Interval& value);
  [[nodiscard]] Own own_forms(const Place& place) const;

  SheetShape shape_ = SheetShape::none;
  bool is_front_ = false;
  Form d_;      // of two sheets
  Form b_, c_;  // of a rational one
  std::vector<ConstraintForm> constraints_;
  mutable std::size_t last_to_hide_ = 0;  // the constraint that is asked first: it often hides the next place too
  mutable int last_hider_ = nothing_hides;
};

class SheetOnLine : public SheetForms<QuadraticOnLine, Interval> {
  friend class EnclosedSheet;
};

class EnclosedSheet : public SheetForms<EnclosedCurve, DotBox> {
 public:
  EnclosedSheet(const Sheets& sheets, Sheet sheet);
  [[nodiscard]] SheetOnLine on_line(double y) const;

 private:
  [[nodiscard]] ConstraintForm enclosed(const Constraint& k, long root_exponent) const;
};

}  // namespace halfspace
