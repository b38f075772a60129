// processor_time.hpp - seconds of this thread's processor for an action: the median of several runs.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace halfspace {

inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

[[nodiscard]] inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Runs that are shorter than the clock can tell apart are repeated and shared out.
template <class Action>
[[nodiscard]] double median_seconds(int runs, Action action) {
  constexpr double shortest = 2e-3;
  std::vector<double> times;
  int repeats = 1;
  while (static_cast<int>(times.size()) < runs) {
    const double start = thread_seconds();
    for (int i = 0; i < repeats; ++i) action();
    const double time = thread_seconds() - start;
    if (time < shortest && times.empty() && repeats < 1 << 16) {
      repeats *= 2;
    } else {
      times.push_back(time / repeats);
    }
  }
  return median(std::move(times));
}

}  // namespace halfspace
