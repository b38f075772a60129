#include "boards/cortex_m/tick_clock.hpp"

namespace {

volatile std::uint32_t wraps = 0;

}  // namespace

extern "C" void systick_handler() { wraps = wraps + 1; }

namespace halfspace::cortex_m {
namespace {

// Armv6-M, B3.2.4 and B3.3.
volatile std::uint32_t& word_at(std::uintptr_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); }
volatile std::uint32_t& control() { return word_at(0xe000e010); }
volatile std::uint32_t& reload() { return word_at(0xe000e014); }
volatile std::uint32_t& current() { return word_at(0xe000e018); }
bool wrap_pending() { return (word_at(0xe000ed04) & (1U << 26)) != 0; }  // ICSR.PENDSTSET

constexpr std::uint32_t last_tick = 0xffffff;
constexpr std::uint32_t enable_with_interrupt = 7;  // processor clock, interrupt, enable

}  // namespace

TickClock::TickClock(std::uint32_t ticks_per_ms) : ticks_per_ms_(ticks_per_ms) {
  control() = 0;
  reload() = last_tick;
  current() = 0;
  control() = enable_with_interrupt;
}

// Reads again when a wrap came between the two halves.
std::uint64_t TickClock::ticks() const {
  for (;;) {
    const std::uint32_t high = wraps;
    const std::uint32_t low = last_tick - current();
    if (!wrap_pending() && high == wraps) return (static_cast<std::uint64_t>(high) << 24) + low;
  }
}

std::uint32_t TickClock::now_ms() { return static_cast<std::uint32_t>(ticks() / ticks_per_ms_); }

}  // namespace halfspace::cortex_m
