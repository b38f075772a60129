// guided_arc.hpp - an arc whose form has more than one root on a line: sought between the separators of a window.
//
//     separators     \                  |            dots at or left of the left one lie left of the root,
//     dots    .  .  . \ .  .  .  .  .  .| .  .       dots at or right of the right one right of it, unasked;
//     root             \      |         |            between them the form changes its sign once
//
// Form    step_x, back_x, step_y, jump_x, load, and sign(missing): that of its value, or `missing` where there is none.
// Bounds  The search keeps to the window and the scissor, whatever a damaged job says: a line takes at most the window's dots.
//         Separators are sums of at most 2^15 steps of at most 2^47 (job_format.hpp): no overflow.
// Cost    A line costs a step down and two signs, and a step and a sign for every dot that the crossing moved.
#pragma once

#include <algorithm>

#include "firmware/core/arc.hpp"

namespace halfspace {

// Both separators on the current line, in 2^-16 page dots. One that is not there lies off any page.
struct ArcWindow {
  static constexpr std::int64_t far = std::int64_t{1} << 62;
  std::int64_t left = -far, left_step = 0;
  std::int64_t right = far, right_step = 0;

  static ArcWindow read(JobReader& in, std::int32_t origin_x) {
    ArcWindow w;
    const std::int64_t origin = static_cast<std::int64_t>(origin_x) * (1 << separator_fraction);
    const std::int32_t sides = in.number_in(0, 3);
    if ((sides & 1) != 0) {
      w.left = in.number_within(largest_separator) + origin;
      w.left_step = in.number_within(largest_separator);
    }
    if ((sides & 2) != 0) {
      w.right = in.number_within(largest_separator) + origin;
      w.right_step = in.number_within(largest_separator);
    }
    return w;
  }
  void step_y() {
    left += left_step;
    right += right_step;
  }
  [[nodiscard]] std::int64_t first_asked() const { return (left >> separator_fraction) + 1; }
  [[nodiscard]] std::int64_t first_unasked() const { return -(-right >> separator_fraction); }
};

template <class Form>
struct GuidedArc {
  Form form;  // stands at dot x of the current line
  ArcWindow window;
  std::int32_t origin_x = 0;
  std::int16_t x = 0;
  std::int16_t x_min = 0, x_end = 0;  // x_end = scissor.x1 + 1: "no dot of the line"
  bool rising = false, missing_right = false;

  // Sets every member.
  void load(JobReader& in, const ArcStart& start) {
    const std::int32_t flags = in.number_in(0, 3);
    rising = (flags & 1) != 0;
    missing_right = (flags & 2) != 0;
    origin_x = start.origin_x;
    x = static_cast<std::int16_t>(start.x);
    x_min = static_cast<std::int16_t>(start.x_min);
    x_end = static_cast<std::int16_t>(start.x_max + 1);
    window = ArcWindow::read(in, origin_x);
    form.load(in, start.x - start.origin_x, start.y - start.origin_y);
  }
  // On which side of the root the current dot lies: -1 left, 0 on it, 1 right.
  [[nodiscard]] int side() const {
    const int right = rising ? 1 : -1;
    return right * form.sign(missing_right ? right : -right);
  }
  ArcCrossing settle() {
    const std::int64_t low = std::clamp<std::int64_t>(window.first_asked(), x_min, x_end);
    const std::int64_t high = std::clamp<std::int64_t>(window.first_unasked(), low, x_end);
    const auto begin = static_cast<std::int16_t>(std::clamp<std::int64_t>(x, low, high));
    if (begin != x) form.jump_x(begin - x);
    x = begin;
    int here = x < high ? side() : 1;
    if (here < 0) {
      do {
        form.step_x();
        ++x;
        here = x < high ? side() : 1;
      } while (here < 0);
    } else {
      while (x > low) {
        form.back_x();
        const int left = side();
        if (left < 0) {
          form.step_x();
          break;
        }
        here = left;
        --x;
      }
    }
    return {x, static_cast<std::int16_t>(here == 0 ? x + 1 : x)};
  }
};

template <class Form>
constexpr ArcModule guided_module{
    .bytes = static_cast<std::int32_t>(sizeof(GuidedArc<Form>)),
    .load = [](JobReader& in, const ArcStart& start,
               void* state) { static_cast<GuidedArc<Form>*>(state)->load(in, start); },
    .settle = [](void* state) { return static_cast<GuidedArc<Form>*>(state)->settle(); },
    .next =
        [](void* state) {
          auto& arc = *static_cast<GuidedArc<Form>*>(state);
          arc.form.step_y();
          arc.window.step_y();
          return arc.settle();
        },
    .enter_window =
        [](JobReader& in, void* state) {
          auto& arc = *static_cast<GuidedArc<Form>*>(state);
          arc.window = ArcWindow::read(in, arc.origin_x);
        },
    .jump_down = nullptr,
    .ahead = nullptr,
};

}  // namespace halfspace
