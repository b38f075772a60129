#include "host/cli/output_page.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "hal/device_sink.hpp"
#include "host/cli/job_input.hpp"
#include "host/picture/simulated_device.hpp"
#include "host/picture/write_bytes.hpp"

namespace halfspace {
namespace {

constexpr std::uint32_t patience_ms = 30000;

// Passes bands on and, on a terminal, tells how far the page has come, from the first band on; silent in a pipe.
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
    if (shown_ && now - last_ < std::chrono::milliseconds(200)) return;
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

const char* word(DotFormat format) { return format == DotFormat::bilevel ? "bilevel" : "gray"; }

// Refused: told, with the devices that do take the page.
ExitStatus check_device(const DeviceTraits& traits, const JobInput& job) {
  const Page& page = job.header().page;
  if (takes_page(traits, page)) return ExitStatus::drawn;
  // A wrong kind of page is a wrong -d; a page too large is a limit of the device.
  const ExitStatus status = page.format == traits.format ? ExitStatus::limit_exceeded : ExitStatus::command_line_wrong;
  return job.fail(
      status,
      fmt::format("the job draws a {} page of {} x {} dots, and {} takes {} pages of at most {} x {}; compile the "
                  "scene with -d {}, or run the job on one of {}",
                  word(page.format), page.width, page.height, traits.name, word(traits.format), traits.max_width,
                  traits.max_height, traits.name, devices_for(page)));
}

}  // namespace

ExitStatus write_text(const std::string& path, const std::string& text) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto error = write_bytes(path, {bytes, text.size()});
  return error ? fail(ExitStatus::device_or_file_failed, *error) : ExitStatus::drawn;
}

bool takes_page(const DeviceTraits& traits, const Page& page) {
  return page.format == traits.format && page.width <= traits.max_width && page.height <= traits.max_height;
}

std::string devices_for(const Page& page) {
  std::string names;
  for (const KnownDevice& device : known_devices) {
    if (takes_page(device.traits, page)) names += (names.empty() ? "" : ", ") + std::string(device.traits.name);
  }
  return names;
}

std::optional<std::string> choose_output(const std::string& asked, const KnownDevice& device) {
  const bool text_device = device.kind == DeviceKind::ascii || device.kind == DeviceKind::braille;
  const std::string output = asked.empty() && text_device ? "-" : asked;
  if (output.empty()) {
    fail(ExitStatus::command_line_wrong,
         fmt::format("-o is missing: name the file that {} writes", device.traits.name));
    return std::nullopt;
  }
  if (const auto error = check_output_name(output, device.traits)) {
    fail(ExitStatus::command_line_wrong, *error);
    return std::nullopt;
  }
  return output;
}

void warn_of_density(std::int32_t dpi, const std::string& output, const KnownDevice& device) {
  if (dpi == 0 || holds_density(output, device)) return;
  fmt::print(stderr, "warning: --dpi {}: {} holds no density\n", dpi, output);
}

DrawnPage draw_page(ByteSource& job_bytes, const DrawRequest& request) {
  DrawnPage drawn;
  drawn.status = ExitStatus::device_or_file_failed;
  const double start = processor_seconds();
  const DeviceTraits& traits = request.device->traits;
  const auto device_failed = [&](const std::string& what) {
    drawn.status = fail(ExitStatus::device_or_file_failed, fmt::format("{}: {}", traits.name, what));
  };
  JobInput job(job_bytes, request.job_name);
  if (!job.has_header()) return drawn;
  drawn.header = job.header();
  drawn.status = check_device(traits, job);
  if (drawn.status != ExitStatus::drawn) return drawn;
  const auto simulated = make_simulated_device(*request.device, drawn.header.page, request.dpi);
  RasterDevice& device = simulated->device();
  if (const DeviceStatus status = device.begin_page(drawn.header.page); status != DeviceStatus::ok) {
    device_failed(fmt::format("the page is refused: {}", describe(status)));
    return drawn;
  }
  const std::int32_t rows = traits.preferred_band_rows;
  drawn.core_bytes = memory_wanted(drawn.header, rows);
  std::vector<std::uint64_t> memory(drawn.core_bytes / 8 + 1);
  DeviceSink sink(device, simulated->clock(), patience_ms);
  {
    ProgressSink progress(sink, drawn.header.page.height, !request.quiet && isatty(STDERR_FILENO) != 0);
    drawn.result =
        draw(job.reader(), drawn.header, progress, std::as_writable_bytes(std::span(memory)),
             {.shader = request.shader, .stride = request.stride, .band_rows = rows, .measure = false}, all_modules);
  }
  if (drawn.result.status == DrawStatus::stopped) {
    device.abort();
    device_failed(describe(sink.status()));
    return drawn;
  }
  drawn.status = job.verdict(drawn.result);
  drawn.job_bytes = job.bytes();
  if (drawn.status != ExitStatus::drawn) {
    device.abort();
    return drawn;
  }
  if (const DeviceStatus status = device.end_page(); status != DeviceStatus::ok) {
    device_failed(fmt::format("the page could not be ended: {}", describe(status)));
    return drawn;
  }
  drawn.seconds = processor_seconds() - start;
  if (const auto error = write_output(*simulated, request.dpi, request.output)) {
    drawn.status = fail(ExitStatus::device_or_file_failed, *error);
  }
  return drawn;
}

}  // namespace halfspace
