// The wiring: the job in flash, drawn to the host's file dots.bin; what it took goes to the console.
// Exit status  0 drawn, 3 the device failed, 4 the job was refused (the numbers of the command line).
#include "boards/microbit/dot_stream.hpp"
#include "boards/microbit/memory_map.hpp"
#include "boards/microbit/semihosting.hpp"
#include "boards/microbit/tick_clock.hpp"
#include "firmware/app/draw_page.hpp"
#include "firmware/app/embedded_job.hpp"
#include "firmware/core/memory_source.hpp"

namespace halfspace::microbit {
namespace {

int run() {
  TickClock clock;
  HostFile console(console_name);
  HostFile dots("dots.bin");
  DotStream device(dots, clock);
  MemorySource job(embedded_job.bytes);

  const std::uint64_t start = clock.ticks();
  const PageReport report = draw_page(job, device, clock, arena(), embedded_job.shader, embedded_job.modules);
  const std::uint64_t end = clock.ticks();
  const std::size_t stack = stack_used();
  dots.close();

  write_report(console, report);
  write_figure(console, "ticks", static_cast<std::int64_t>(end - start));
  write_figure(console, "stack_bytes", static_cast<std::int64_t>(stack));
  write_figure(console, "stack_size", static_cast<std::int64_t>(stack_size()));
  if (report.device != DeviceStatus::ok) return 3;
  return report.ok() ? 0 : 4;
}

}  // namespace
}  // namespace halfspace::microbit

int main() { return halfspace::microbit::run(); }
