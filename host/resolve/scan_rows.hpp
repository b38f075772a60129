// scan_rows.hpp - cuts a body's scan lines where its curves change their order, and finds the curves' roots on a line.
//
//     y0 ---------------------   slab: integer lines strictly between two marks. On all of them the same roots stand in the
//          \        |            same order, and none coincide: one line stands for all
//     -- -- -\- -- -|- -- -- -   mark between two lines: splits, costs nothing else
//              \    |            slab
//     -----------X------------   line mark: a row of its own, where roots may coincide
//               / \              slab
//     y1 ---------------------
#pragma once

#include <cstdint>
#include <vector>

#include "host/resolve/root_marks.hpp"
#include "host/resolve/row_point.hpp"
#include "host/resolve/sheet.hpp"
#include "host/resolve/sheet_form.hpp"
#include "host/resolve/short_list.hpp"

namespace halfspace {

// Local dots, inclusive.
struct DotExtent {
  std::int64_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};

struct ScanRow {
  std::int64_t y0 = 0, y1 = 0;
  bool singular = false;  // then y0 = y1
};

// Marks are sorted, none twice.
void find_scan_rows(const std::vector<Mark>& marks, std::int64_t y0, std::int64_t y1, std::vector<ScanRow>& rows);

// A curve through a root: Branch::single means the curve with the sign that makes its x coefficient positive on this line.
struct CurveBranch {
  std::uint32_t curve = 0;
  Branch branch = Branch::single;
  bool negated = false;
};

// A quartic through a root: of the roots at which one constraint is 0 on one sheet it is the `rank`th on this line.
struct QuarticBranch {
  std::uint32_t quartic = 0, constraint = 0;  // indices
  Sheet sheet = Sheet::only;
  std::uint32_t rank = 0;
};

// One point of a scan line with every curve that passes through it.
struct RowRoot {
  RowPoint x;
  ShortList<CurveBranch> curves;
  std::vector<QuarticBranch> quartics;
};

// The roots of a face's curves, line by line, in memory that serves all lines of all faces.
class RowRoots {
 public:
  // The face's; keeps pointers.
  void set_face(const Sheets& sheets, const BoundingCurves& bounds);

  // Ascending, distinct; until the next call. Points keep pointers to the curves.
  [[nodiscard]] const std::vector<RowRoot>& on_line(std::int64_t y);

 private:
  void add_curve(std::uint32_t index, std::int64_t y);
  void add_quartic(std::uint32_t index, std::int64_t y);
  void insert(RowRoot&& root);

  const Sheets* sheets_ = nullptr;
  const BoundingCurves* bounds_ = nullptr;
  std::vector<std::vector<EnclosedForm>> forms_;  // of each quartic's constraints
  std::vector<RowPoint> points_;                  // of one curve
  std::vector<RowRoot> roots_;
};

}  // namespace halfspace
