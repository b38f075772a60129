#include "host/cli/pipeline.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <charconv>
#include <ctime>
#include <optional>
#include <utility>

#include "host/cli/load_scene.hpp"
#include "host/flatten/flatten.hpp"
#include "host/resolve/resolve.hpp"

namespace halfspace {
namespace {

constexpr std::int64_t largest_side = 32767;

std::string device_names() {
  std::string names;
  for (const KnownDevice& device : known_devices) {
    names += (names.empty() ? "" : ", ") + std::string(device.traits.name);
  }
  return names;
}

// "WxH": two decimal numbers. Values beyond 64 bits read as the largest, to be refused as too large.
std::optional<std::pair<std::int64_t, std::int64_t>> parse_size(const std::string& text) {
  std::int64_t value[2];
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 2; ++i) {
    if (i == 1 && (at == end || (*at != 'x' && *at != 'X'))) return std::nullopt;
    at += i;
    const auto [next, error] = std::from_chars(at, end, value[i]);
    if (error == std::errc::result_out_of_range) {
      value[i] = INT64_MAX;
    } else if (error != std::errc()) {
      return std::nullopt;
    }
    at = next;
  }
  if (at != end || value[0] < 1 || value[1] < 1) return std::nullopt;
  return std::pair(value[0], value[1]);
}

// The page's sides; false: refused.
bool choose_size(const PageRequest& request, PageChoice& choice) {
  const DeviceTraits& traits = choice.device->traits;
  if (!request.size) return true;
  const auto size = parse_size(*request.size);
  if (!size) {
    choice.status =
        fail(ExitStatus::command_line_wrong,
             fmt::format("--size {}: expected WIDTHxHEIGHT in dots, each at least 1, as in 640x480", *request.size));
    return false;
  }
  const std::int64_t max_width = std::min<std::int64_t>(traits.max_width, largest_side);
  const std::int64_t max_height = std::min<std::int64_t>(traits.max_height, largest_side);
  if (size->first > max_width || size->second > max_height) {
    choice.status = fail(ExitStatus::limit_exceeded, fmt::format("--size {}: the largest page of {} is {}x{} dots",
                                                                 *request.size, traits.name, max_width, max_height));
    return false;
  }
  choice.page.width = static_cast<std::int32_t>(size->first);
  choice.page.height = static_cast<std::int32_t>(size->second);
  return true;
}

// On a terminal, which stage of a job's making is at work; wiped when it is done. Silent in a pipe.
class StageLine {
 public:
  explicit StageLine(bool quiet) : show_(!quiet && isatty(STDERR_FILENO) != 0) {}
  StageLine(const StageLine&) = delete;
  StageLine& operator=(const StageLine&) = delete;
  ~StageLine() { wipe(); }

  void tell(const std::string& stage) {
    if (show_) fmt::print(stderr, "\r\x1b[K{}", stage);
    shown_ = show_;
  }
  void wipe() {
    if (std::exchange(shown_, false)) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  bool show_, shown_ = false;
};

Screen screen_named(const std::string& name) {
  if (name == "bayer") return Screen::bayer;
  return name == "blue-noise" ? Screen::blue_noise : Screen::clustered;
}

}  // namespace

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

PageChoice choose_page(const PageRequest& request) {
  PageChoice choice;
  choice.device = find_device(request.device);
  if (choice.device == nullptr) {
    choice.status = fail(ExitStatus::command_line_wrong,
                         fmt::format("-d {}: no such device; known are {}", request.device, device_names()));
    return choice;
  }
  const DeviceTraits& traits = choice.device->traits;
  choice.page = default_page(traits);
  if (!choose_size(request, choice)) return choice;
  if (request.levels != 0) choice.page.levels = request.levels;
  const Paper paper = request.background.empty()      ? traits.paper
                      : request.background == "white" ? Paper::white
                                                      : Paper::black;
  choice.page.background = background_level(paper, choice.page.levels);
  choice.screen = screen_named(request.screen);
  choice.dpi = request.dpi != 0 ? request.dpi : traits.dots_per_inch;
  return choice;
}

void warn_of_needless(const PageRequest& request, const PageChoice& choice) {
  if (request.screen.empty() || choice.page.format == DotFormat::bilevel) return;
  fmt::print(stderr, "warning: --screen {}: {} draws levels as they are, without a screen\n", request.screen,
             choice.device->traits.name);
}

Pipeline make_job(const SceneRequest& request, const PageChoice& choice, bool measure) {
  Pipeline p;
  double last = processor_seconds();
  const auto lap = [&last] {
    const double now = processor_seconds();
    return now - std::exchange(last, now);
  };
  const LoadedScene loaded = load_scene(request.paths, request.language, request.quiet);
  p.times.read = lap();
  p.status = loaded.status;
  if (p.status != ExitStatus::drawn) return p;

  StageLine stage(request.quiet);
  stage.tell("placing bodies");
  const DeviceTraits& traits = choice.device->traits;
  FlattenResult flat = flatten(loaded.scene, {choice.page.width, choice.page.height, choice.page.levels,
                                              traits.aspect_numerator, traits.aspect_denominator, request.view, false});
  p.times.flatten = lap();
  stage.wipe();
  p.status = report(flat.diagnostics, request.quiet);
  p.scene = std::move(flat.scene);
  if (p.status != ExitStatus::drawn) return p;

  stage.tell(fmt::format("resolving {} bodies", p.scene.bodies.size()));
  p.resolved = resolve(p.scene);
  p.times.resolve = lap();

  stage.tell(fmt::format("writing the job of {} faces", p.resolved.faces.size()));
  p.job = write_job(p.scene, p.resolved, {choice.page, choice.screen, measure});
  p.times.job = lap();
  stage.wipe();
  p.status = report(p.job.diagnostics, request.quiet);
  return p;
}

}  // namespace halfspace
