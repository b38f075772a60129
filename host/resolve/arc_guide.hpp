// arc_guide.hpp - how the core finds one root among several of a form of fourth degree: windows of scan lines with separators.
//
//        limb   separator  arc  separator   next root of the form on this sheet
//          (  d > 0  |      /      |       /            A separator is proved on all lines of its window at once: its place on the
//         (          |     /       |      /             first line is compared exactly, and n and d, restricted to it, are polynomials
//          (         |    /        |     /              in y without a zero up to the last line (docs/meeting.md).
//
// Lines on which the form's roots meet, and those where no straight line fits between two roots, have separators of their own: the
// dots beside the root.
#pragma once

#include <cstdint>
#include <map>
#include <variant>
#include <vector>

#include "host/resolve/resolved_scene.hpp"
#include "host/resolve/root_order.hpp"
#include "host/resolve/scan_rows.hpp"

namespace halfspace {

// Lines of one arc, and what its reader needs (resolved_scene.hpp). Local lines, in the windows too.
struct GuidedRun {
  std::int64_t y0 = 0, y1 = -1;
  Guide guide;
};

// Lines that were looked at.
struct KnownLine {
  ValueOnLine value;
  std::vector<Obstacle> obstacles;
};
using KnownLines = std::map<std::int64_t, KnownLine>;

// The roots of one constraint of degree three or four on one sheet.
class ArcGuide {
 public:
  // Keeps the form's pointers.
  ArcGuide(const FormOnSheet& form, const DotExtent& extent);

  [[nodiscard]] const std::variant<Curve, RadicalForm, QuarticForm>& form() const { return form_; }

  // Runs that together are the lines y0 .. y1, on each of which the root of this rank exists.
  [[nodiscard]] std::vector<GuidedRun> runs(std::uint32_t rank, std::int64_t y0, std::int64_t y1);

 private:
  FormOnSheet form_on_sheet_;
  EnclosedForm near_;
  std::variant<Curve, RadicalForm, QuarticForm> form_;
  std::vector<ScanRow> rows_;  // of this form alone
  KnownLines lines_;
};

}  // namespace halfspace
