#include "host/resolve/quadric_meeting.hpp"

#include <array>
#include <vector>

#include "host/resolve/enclosed_sheet.hpp"

namespace halfspace {
namespace {

constexpr int budget = 8192;        // boxes a sheet; more than a hundred times what a gap of a dot needs
constexpr double finest = 0x1p-16;  // dots: a box of this size that still may hold a meeting counts as one

// Corners are multiples of 2^-17 below 2^17, so midpoints are exact.
bool is_finest(const Box& box) { return box.x1 - box.x0 <= finest && box.y1 - box.y0 <= finest; }

std::array<Box, 2> halves(const Box& box) {
  if (box.x1 - box.x0 > box.y1 - box.y0) {
    const double x = (box.x0 + box.x1) / 2;
    return {{{box.x0, box.y0, x, box.y1}, {x, box.y0, box.x1, box.y1}}};
  }
  const double y = (box.y0 + box.y1) / 2;
  return {{{box.x0, box.y0, box.x1, y}, {box.x0, y, box.x1, box.y1}}};
}

// Depth first: a true meeting is reached after one path of halvings.
std::optional<QuadricMeeting> search(const EnclosedSheet& sheet, const Extent& extent) {
  std::vector<Box> open{{static_cast<double>(extent.x0), static_cast<double>(extent.y0), static_cast<double>(extent.x1),
                         static_cast<double>(extent.y1)}};
  for (int boxes = 0; !open.empty(); ++boxes) {
    const Box box = open.back();
    open.pop_back();
    const auto other = sheet.possible_meeting(box);
    if (!other) continue;
    if (is_finest(box) || boxes >= budget) return QuadricMeeting{*other, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
    for (const Box& half : halves(box)) open.push_back(half);
  }
  return std::nullopt;
}

}  // namespace

std::optional<QuadricMeeting> find_meeting(const Sheets& sheets, const Extent& extent) {
  if (!has_untraced_constraint(sheets)) return std::nullopt;
  if (sheets.shape == SheetShape::rational) return search(EnclosedSheet(sheets, Sheet::only), extent);
  if (const auto meeting = search(EnclosedSheet(sheets, Sheet::front), extent)) return meeting;
  return search(EnclosedSheet(sheets, Sheet::back), extent);
}

}  // namespace halfspace
