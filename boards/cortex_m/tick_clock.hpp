// tick_clock.hpp - SysTick, 24 bits that count down at the processor's clock, carried on to 64 bits by its interrupt.
// Counts  Under QEMU's `-icount shift=6` an instruction takes 64 ns, so the ticks between two moments count instructions. At
//         16 MHz (microbit) a tick takes 62.5 ns: instructions = ticks * 125 / 128. At 25 MHz (mps2-an385) it takes 40 ns:
//         instructions = ticks * 5 / 8. They are instructions, not cycles.
#pragma once

#include "hal/clock.hpp"

namespace halfspace::cortex_m {

class TickClock final : public Clock {
 public:
  explicit TickClock(std::uint32_t ticks_per_ms);  // starts the timer
  [[nodiscard]] std::uint64_t ticks() const;
  [[nodiscard]] std::uint32_t now_ms() override;
  void pause() override {}

 private:
  std::uint32_t ticks_per_ms_;
};

}  // namespace halfspace::cortex_m
