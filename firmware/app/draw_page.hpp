// draw_page.hpp - the controller's program: a job in, a page on a device out.
// Order   Header, room, begin page, bands, end page. A job that needs more memory than there is, is refused before the
//         device hears of it; a page that fails later is aborted, so the device is left ready for another.
// Errors  Returned: the core's in `drawn`, the device's in `device`. The page is whole only when both are ok.
// Memory  Lent by the caller, aligned to 8 bytes; the band height is the device's, halved until the job fits.
#pragma once

#include <string_view>

#include "firmware/core/engine.hpp"
#include "hal/byte_sink.hpp"
#include "hal/clock.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

struct PageReport {
  DrawResult drawn;  // need and have are filled in even when the job is refused
  DeviceStatus device = DeviceStatus::ok;

  [[nodiscard]] bool ok() const { return drawn.status == DrawStatus::ok && device == DeviceStatus::ok; }
};

[[nodiscard]] PageReport draw_page(ByteSource& job, RasterDevice& device, Clock& clock, std::span<std::byte> memory,
                                   Shader shader, const Modules& modules);

// What went wrong and its remedy, for a person; need and have stand in the result.
[[nodiscard]] const char* describe(DrawStatus status);

// A line of "name value".
void write_figure(ByteSink& out, std::string_view name, std::int64_t value);
// The report as such lines, the message first.
void write_report(ByteSink& out, const PageReport& report);

}  // namespace halfspace
