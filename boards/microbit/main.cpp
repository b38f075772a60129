// The wiring: the job in flash, drawn to the host's file dots.bin; what it took goes to the console.
// Exit status  0 drawn, 3 the device failed, 4 the job was refused (the numbers of the command line).
#include "boards/cortex_m/memory_map.hpp"
#include "boards/cortex_m/semihosting.hpp"
#include "boards/cortex_m/tick_clock.hpp"
#include "boards/microbit/dot_stream.hpp"
#include "firmware/app/draw_page.hpp"
#include "firmware/app/embedded_job.hpp"
#include "firmware/core/memory_source.hpp"

namespace halfspace::microbit {
namespace {

int run() {
  cortex_m::TickClock clock(16'000);  // ticks a millisecond
  cortex_m::HostFile console(cortex_m::console_name);
  cortex_m::HostFile dots("dots.bin");
  DotStream device(dots, clock);
  MemorySource job(embedded_job.bytes);

  const std::uint64_t start = clock.ticks();
  const PageReport report = draw_page(job, device, clock, cortex_m::arena(), embedded_job.shader, embedded_job.modules);
  const std::uint64_t end = clock.ticks();
  const std::size_t stack = cortex_m::stack_used();
  dots.close();

  write_report(console, report);
  write_figure(console, "ticks", static_cast<std::int64_t>(end - start));
  write_figure(console, "stack_bytes", static_cast<std::int64_t>(stack));
  write_figure(console, "stack_size", static_cast<std::int64_t>(cortex_m::stack_size()));
  if (report.device != DeviceStatus::ok) return 3;
  return report.ok() ? 0 : 4;
}

}  // namespace
}  // namespace halfspace::microbit

int main() { return halfspace::microbit::run(); }
