#include "host/cli/output_page.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "firmware/core/memory_source.hpp"
#include "hal/device_sink.hpp"
#include "host/picture/simulated_device.hpp"
#include "host/picture/write_bytes.hpp"

namespace halfspace {
namespace {

constexpr std::uint32_t patience_ms = 30000;

// Passes bands on and, on a terminal, tells how far the page has come; silent in a pipe.
class ProgressSink final : public BandSink {
 public:
  ProgressSink(BandSink& next, std::int32_t height, bool show) : next_(next), height_(height), show_(show) {}
  ProgressSink(const ProgressSink&) = delete;
  ProgressSink& operator=(const ProgressSink&) = delete;
  ~ProgressSink() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
  }

  bool put_band(const Band& band) override {
    if (show_) tell(band.y + band.rows);
    return next_.put_band(band);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void tell(std::int32_t lines) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, "\r\x1b[Kscan line {} of {}, {:.0f} s left", lines, height_,
               elapsed * (height_ - lines) / lines);
    shown_ = true;
  }

  BandSink& next_;
  std::int32_t height_;
  bool show_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

const char* describe(DrawStatus status) {
  switch (status) {
    case DrawStatus::not_a_job:
      return "the job's header is damaged";
    case DrawStatus::bad_record:
      return "the job is damaged";
    case DrawStatus::missing_module:
      return "the job names an arc kind that this program leaves out";
    case DrawStatus::does_not_fit:
      return "the job does not fit the core's memory";
    case DrawStatus::too_many_spans:
      return "a scan line has too many spans; draw the scene smaller or in parts";
    default:
      return "the page was stopped";
  }
}

}  // namespace

ExitStatus write_text(const std::string& path, const std::string& text) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto error = write_bytes(path, {bytes, text.size()});
  return error ? fail(ExitStatus::device_or_file_failed, *error) : ExitStatus::drawn;
}

DrawnPage draw_page(const PageChoice& choice, const JobResult& job, const DrawRequest& request) {
  DrawnPage drawn;
  const double start = processor_seconds();
  const auto simulated = make_simulated_device(*choice.device, choice.page, choice.dpi);
  RasterDevice& device = simulated->device();
  const auto device_failed = [&](const std::string& what) {
    drawn.status = fail(ExitStatus::device_or_file_failed, fmt::format("{}: {}", choice.device->traits.name, what));
  };
  if (const DeviceStatus status = device.begin_page(choice.page); status != DeviceStatus::ok) {
    device_failed(fmt::format("the page is refused: {}", describe(status)));
    return drawn;
  }
  const std::int32_t rows = choice.device->traits.preferred_band_rows;
  drawn.core_bytes = memory_needed(job.header, rows);
  std::vector<std::uint64_t> memory(drawn.core_bytes / 8 + 1);
  MemorySource source(job.bytes);
  DeviceSink sink(device, simulated->clock(), patience_ms);
  {
    ProgressSink progress(sink, choice.page.height, !request.quiet && isatty(STDERR_FILENO) != 0);
    drawn.result =
        draw(source, progress, std::as_writable_bytes(std::span(memory)),
             {.shader = request.shader, .stride = request.stride, .band_rows = rows, .measure = false}, all_modules);
  }
  if (drawn.result.status != DrawStatus::ok) {
    device.abort();
    if (drawn.result.status == DrawStatus::stopped) {
      device_failed(describe(sink.status()));
    } else {
      const bool limit = drawn.result.status == DrawStatus::too_many_spans;
      drawn.status = fail(limit ? ExitStatus::limit_exceeded : ExitStatus::device_or_file_failed,
                          fmt::format("{} (scan line {})", describe(drawn.result.status), drawn.result.line));
    }
    return drawn;
  }
  if (const DeviceStatus status = device.end_page(); status != DeviceStatus::ok) {
    device_failed(fmt::format("the page could not be ended: {}", describe(status)));
    return drawn;
  }
  drawn.seconds = processor_seconds() - start;
  if (const auto error = write_output(*simulated, choice.dpi, request.output)) {
    drawn.status = fail(ExitStatus::device_or_file_failed, *error);
  }
  return drawn;
}

}  // namespace halfspace
