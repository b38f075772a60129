// plan.hpp - what a report draws: all of it, or little enough for a test.
#pragma once

#include <cstddef>
#include <vector>

#include "host/report/subject.hpp"

namespace halfspace {

struct Plan {
  std::size_t most_scenes = 1000;  // of a suite
  std::vector<PageSize> gallery{{264, 275, 65}, {1056, 1100, 17}, {1056, 1100, 65}, {1056, 1100, 256}};
  std::vector<PageSize> hard{{64, 64, 65}, {190, 161, 17}, {190, 161, 65}, {190, 161, 256}};
  std::vector<int> dots_per_inch{100, 200, 300, 600, 1200};
  int side_inches = 4;  // of the square page that dots_per_inch is for
  PageSize povray_page{2112, 1700, 65}, balls_page{2000, 2000, 65}, atoms_page{1200, 1200, 65};
  int atoms = 4000;
  int runs = 5;
  std::vector<std::int32_t> board_radii{50, 100, 500, 1000};
  bool board = true;
};

[[nodiscard]] inline Plan quick_plan() {
  Plan plan;
  plan.most_scenes = 2;
  plan.gallery = {{66, 55, 17}};
  plan.hard = {{33, 33, 17}};
  plan.dots_per_inch = {20, 40};
  plan.povray_page = {96, 77, 65};
  plan.balls_page = plan.atoms_page = {96, 96, 65};
  plan.atoms = 50;
  plan.runs = 3;
  plan.board = false;
  return plan;
}

}  // namespace halfspace
