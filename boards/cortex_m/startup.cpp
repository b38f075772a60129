// From power-on to main: variables set, stack painted, constructors run. A fault ends the program with status 99.
#include <cstdint>

#include "boards/cortex_m/memory_map.hpp"
#include "boards/cortex_m/semihosting.hpp"

extern "C" {
extern const std::uint32_t data_in_flash[];
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];
using Constructor = void (*)();
extern const Constructor init_array_begin[], init_array_end[];
void systick_handler();

[[noreturn]] void reset_handler();
[[noreturn]] void fault_handler() { halfspace::cortex_m::exit_program(99); }
}

int main();

namespace {

union Vector {
  void* stack;
  void (*handler)();
};

// Armv6-M's sixteen entries; the board's own interrupts stay off.
__attribute__((section(".vectors"), used)) const Vector vectors[16] = {
    {.stack = stack_top},       {.handler = reset_handler}, {.handler = fault_handler}, {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler}, {.handler = systick_handler},
};

}  // namespace

void reset_handler() {
  const std::uint32_t* from = data_in_flash;
  for (std::uint32_t* to = data_begin; to < data_end; ++to) *to = *from++;
  for (std::uint32_t* to = bss_begin; to < bss_end; ++to) *to = 0;
  halfspace::cortex_m::paint_stack();
  for (const Constructor* constructor = init_array_begin; constructor < init_array_end; ++constructor) (*constructor)();
  halfspace::cortex_m::exit_program(main());
}
