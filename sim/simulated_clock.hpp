// simulated_clock.hpp - a clock that runs only while a driver waits: a pause is a millisecond, and costs no
// time.
#pragma once

#include "hal/clock.hpp"

namespace halfspace {

class SimulatedClock final : public Clock {
 public:
  std::uint32_t now_ms() override { return now_ms_; }
  void pause() override { ++now_ms_; }

 private:
  std::uint32_t now_ms_ = 0;
};

}  // namespace halfspace
