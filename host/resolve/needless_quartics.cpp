#include "host/resolve/needless_quartics.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "host/resolve/enclosed_sheet.hpp"
#include "host/resolve/quartic.hpp"

namespace halfspace {
namespace {

constexpr int most_boxes = 300;
constexpr double least_share = 0x1p-6;  // of the page's larger side

std::array<DotBox, 2> halves(const DotBox& box) {
  std::array<DotBox, 2> parts{box, box};
  if (box.x1 - box.x0 > box.y1 - box.y0) {
    parts[0].x1 = parts[1].x0 = (box.x0 + box.x1) / 2;
  } else {
    parts[0].y1 = parts[1].y0 = (box.y0 + box.y1) / 2;
  }
  return parts;
}

bool is_implied(const EnclosedSheet& sheet, std::size_t constraint, const DotBox& page) {
  const auto size = [](const DotBox& box) { return std::max(box.x1 - box.x0, box.y1 - box.y0); };
  const double least = size(page) * least_share;
  std::vector<DotBox> open{page};
  for (int n = 0; !open.empty(); ++n) {
    const DotBox box = open.back();
    open.pop_back();
    if (sheet.implies(constraint, box)) continue;
    if (n == most_boxes || size(box) <= least) return false;
    for (const DotBox& half : halves(box)) open.push_back(half);
  }
  return true;
}

bool is_needless(const Sheets& sheets, std::size_t constraint, const DotBox& page) {
  const std::span<const Sheet> all = sheets_in(sheets);
  return std::all_of(all.begin(), all.end(),
                     [&](Sheet sheet) { return is_implied(EnclosedSheet(sheets, sheet), constraint, page); });
}

}  // namespace

void drop_needless_quartics(Sheets& sheets, const DotExtent& extent) {
  const DotBox page{static_cast<double>(extent.x0), static_cast<double>(extent.y0), static_cast<double>(extent.x1),
                    static_cast<double>(extent.y1)};
  for (std::size_t i = sheets.constraints.size(); i-- > 0;) {
    if (degree_of(sheets.constraints[i].n) <= 2 || !is_needless(sheets, i, page)) continue;
    sheets.constraints.erase(sheets.constraints.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace halfspace
