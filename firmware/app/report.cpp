#include <charconv>
#include <string_view>

#include "firmware/app/draw_page.hpp"

namespace halfspace {
namespace {

void put(ByteSink& out, std::string_view text) {
  (void)out.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

void write_figure(ByteSink& out, std::string_view name, std::int64_t value) {
  std::array<char, 20> digits{};  // -9223372036854775808 is the longest
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  put(out, name);
  put(out, " ");
  put(out, {digits.data(), static_cast<std::size_t>(end - digits.data())});
  put(out, "\n");
}

const char* describe(DrawStatus status) {
  switch (status) {
    case DrawStatus::ok:
      return "drawn";
    case DrawStatus::not_a_job:
      return "not a job of this version: compile the scene again";
    case DrawStatus::bad_record:
      return "the job is damaged or ends early: compile the scene again";
    case DrawStatus::missing_module:
      return "the job needs an arc kind that this firmware leaves out: link it with the job's own modules";
    case DrawStatus::does_not_fit:
      return "the job needs more memory than there is: draw it smaller, with fewer levels, or in parts";
    case DrawStatus::too_many_spans:
      return "a scan line has more spans than the job's header says: compile the scene again";
    case DrawStatus::stopped:
      return "the device stopped the page";
  }
  return "unknown status";
}

void write_report(ByteSink& out, const PageReport& report) {
  const DrawResult& drawn = report.drawn;
  put(out, "status ");
  put(out, report.device != DeviceStatus::ok ? describe(report.device) : describe(drawn.status));
  put(out, "\n");
  write_figure(out, "need_bytes", drawn.need);
  write_figure(out, "have_bytes", drawn.have);
  write_figure(out, "band_rows", drawn.band_rows);
  write_figure(out, "lines", drawn.counters.lines);
  write_figure(out, "spans", drawn.counters.spans);
  write_figure(out, "dots", drawn.counters.dots);
  write_figure(out, "exact_depths", drawn.counters.exact_depths);
  write_figure(out, "exact_levels", drawn.counters.exact_levels);
}

}  // namespace halfspace
