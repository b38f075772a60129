#include "firmware/app/draw_page.hpp"

#include "hal/device_sink.hpp"

namespace halfspace {
namespace {

// A plotter that feeds a whole form, the slowest honest wait, is done in well under this time.
constexpr std::uint32_t patience_ms = 10'000;

bool fits(const JobHeader& header, std::size_t have, DrawResult& result) {
  result.need = static_cast<std::int64_t>(memory_needed(header, 1));
  result.have = static_cast<std::int64_t>(have);
  if (result.need > result.have) result.status = DrawStatus::does_not_fit;
  return result.need <= result.have;
}

}  // namespace

PageReport draw_page(ByteSource& job, RasterDevice& device, Clock& clock, std::span<std::byte> memory, Shader shader,
                     const Modules& modules) {
  PageReport report;
  JobReader in(job);
  JobHeader header;
  if (!read_header(in, header)) {
    report.drawn.status = DrawStatus::not_a_job;
    return report;
  }
  if (!fits(header, memory.size(), report.drawn)) return report;
  report.device = retry_while_busy(clock, patience_ms, [&] { return device.begin_page(header.page); });
  if (report.device != DeviceStatus::ok) return report;

  DeviceSink sink(device, clock, patience_ms);
  report.drawn = draw(in, header, sink, memory,
                      {.shader = shader, .band_rows = device.traits().preferred_band_rows, .measure = false}, modules);
  report.device = sink.status();
  if (report.drawn.status == DrawStatus::ok) {
    report.device = retry_while_busy(clock, patience_ms, [&] { return device.end_page(); });
  }
  if (!report.ok()) device.abort();
  return report;
}

}  // namespace halfspace
