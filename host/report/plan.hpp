// plan.hpp - what a report draws: all of it, or little enough for a test.
#pragma once

#include <cstddef>
#include <vector>

#include "host/report/subject.hpp"

namespace halfspace {

// Of a face on a page of its own, in dots.
struct BoardSize {
  std::int32_t radius = 0, levels = 2;
};

struct Plan {
  std::size_t most_scenes = 1000;  // of a suite
  std::vector<PageSize> gallery{{264, 275, 65}, {528, 550, 17}, {528, 550, 65}, {528, 550, 256}};
  std::vector<PageSize> hard{{64, 64, 65}, {190, 161, 17}, {190, 161, 65}, {190, 161, 256}};
  std::vector<int> dots_per_inch{100, 200, 300, 600, 1200};
  int side_inches = 4;  // of the square page that dots_per_inch is for
  PageSize povray_page{2112, 1700, 65};
  std::vector<PageSize> raster3d_pages{{2000, 2000, 65}, {4000, 4000, 65}};
  int atoms = 4000;
  std::vector<int> resolver_atoms{1000, 3000, 10000};
  int runs = 5;         // of a drawing; the median counts
  int whole_runs = 15;  // of a whole scene, beside other programs
  bool board = true;
  std::int32_t board_radius = 500;
  std::vector<BoardSize> board_sizes{{5, 2},    {5, 65},    {5, 256}, {25, 17},   {25, 65},   {100, 2},   {100, 17},
                                     {100, 65}, {100, 256}, {500, 2}, {500, 256}, {1000, 17}, {1000, 65}, {1000, 256}};
};

[[nodiscard]] inline Plan quick_plan() {
  Plan plan;
  plan.most_scenes = 2;
  plan.gallery = {{33, 27, 17}};
  plan.hard = {{17, 17, 17}};
  plan.dots_per_inch = {8, 16};
  plan.povray_page = {64, 51, 65};
  plan.raster3d_pages = {{48, 48, 65}};
  plan.atoms = 20;
  plan.resolver_atoms = {10};
  plan.runs = plan.whole_runs = 1;
  plan.board = false;
  return plan;
}

}  // namespace halfspace
