// enclosed_sheet.hpp - the forms of sheet.hpp over a box of the page, in intervals: quick answers that are never wrong.
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
struct Box {
  double x0, y0, x1, y1;
};

// A curve's polynomial with rounded coefficients, all divided by the same power of two so that they are at most 1.
// `over` adds a bound for every rounding: centre and radius, half the work of operations on intervals.
class EnclosedCurve {
 public:
  EnclosedCurve() = default;
  EnclosedCurve(const Curve& p, long exponent);
  [[nodiscard]] Interval over(const Box& box) const;

 private:
  std::array<double, 6> q_{};
};

// The same for a curve without terms of second order.
class EnclosedLine {
 public:
  EnclosedLine() = default;
  EnclosedLine(const Curve& p, long exponent);
  [[nodiscard]] Interval over(const Box& box) const;

 private:
  std::array<double, 3> q_{};
};

enum class Verdict : std::uint8_t { nowhere, everywhere, unsure };

class EnclosedSheet {
 public:
  EnclosedSheet(const Sheets& sheets, Sheet sheet);

  // Where in the box does the sheet exist with every constraint holding?
  [[nodiscard]] Verdict shows_over(const Box& box) const;

  // The same in parts, for what is asked exactly otherwise: does the sheet exist all over the box, does a constraint hold wherever it does?
  [[nodiscard]] bool surely_exists(const Box& box) const;
  [[nodiscard]] bool surely_holds(std::size_t constraint, const Box& box) const;

  // Does the constraint hold, and is not 0, wherever in the box the sheet exists with the others holding?
  [[nodiscard]] bool implies(std::size_t constraint, const Box& box) const;

 private:
  struct EnclosedConstraint {
    int sense = 1;
    EnclosedCurve p;  // rational sheets: c' and b' of the other surface, and its a'
    EnclosedLine r;
    Interval a;
  };
  // The own forms over one box.
  struct OnBox {
    Interval d, root, b, c;
    bool exists = false;  // surely
  };

  [[nodiscard]] EnclosedConstraint enclosed(const Constraint& k, long root_exponent) const;
  [[nodiscard]] Interval value_of(const EnclosedConstraint& k, const OnBox& own, const Box& box) const;
  [[nodiscard]] static bool is_held(const EnclosedConstraint& k, const Interval& value);
  [[nodiscard]] OnBox own_forms(const Box& box) const;

  SheetShape shape_;
  double t_;         // of P + t R sqrt(d)
  EnclosedCurve d_;  // of two sheets
  EnclosedLine b_;   // of a rational one
  EnclosedCurve c_;
  std::vector<EnclosedConstraint> constraints_;
};

}  // namespace halfspace
