// tick_clock.hpp - SysTick, 24 bits that count down at 16 MHz, carried on to 64 bits by its interrupt.
// Counts  Under QEMU's `-icount shift=6` an instruction takes 64 ns and a tick 62.5 ns, so the ticks between two
//         moments count instructions: instructions = ticks * 125 / 128. They are instructions, not cycles.
#pragma once

#include "hal/clock.hpp"

namespace halfspace::microbit {

class TickClock final : public Clock {
 public:
  TickClock();  // starts the timer
  [[nodiscard]] std::uint64_t ticks() const;
  [[nodiscard]] std::uint32_t now_ms() override;
  void pause() override {}
};

}  // namespace halfspace::microbit
