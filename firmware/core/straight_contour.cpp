#include "firmware/core/straight_contour.hpp"

#include <algorithm>

#include "firmware/core/contour.hpp"
#include "firmware/core/level_search.hpp"
#include "firmware/core/ruling_survey.hpp"

namespace halfspace {
namespace {

constexpr int place_bits = 15;  // places are 2^-15 dot
constexpr std::int32_t one_dot = 1 << place_bits;

// A line's entries in places: one of p lies at base + p width, with the error of lines less than 1/2 below and 4 above (three floors).
class StraightSpan {
 public:
  StraightSpan(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1)
      : job_(job), s_(job.contours->straight), entries_(job.contours->block.data()), y_(y), x0_(x0), x1_(x1) {
    if (s_.entries == 0) return;
    const std::int64_t lines = y - s_.line;
    if (lines < -survey_lines || lines > survey_lines) return;
    constexpr int to_places = line_bits - place_bits;
    const std::int64_t left = (s_.left + s_.left_slope * lines) >> to_places;
    const std::int64_t width = (s_.width + s_.width_slope * lines) >> to_places;
    constexpr std::int64_t far = std::int64_t{41000} << place_bits;
    constexpr std::int64_t wide = std::int64_t{1} << (14 + place_bits);
    if (left <= -far || left >= far || width < one_dot || width >= wide || width < s_.width >> (to_places + 2)) return;
    width_ = static_cast<std::uint32_t>(width);
    // An entry's level counts as less than a unit of p.
    const std::int32_t unit = static_cast<std::int32_t>(width >> 24) + 1;
    const std::int32_t entry = upper(static_cast<std::uint32_t>(s_.entry_width) << 8, width_) + 1;
    unsure_ = entry + unit + 6;
    base_ = static_cast<std::int32_t>(left) + 4 + entry;
    is_usable_ = unsure_ < one_dot / 8 && (x0 << place_bits) >= end_of(0) - unsure_ &&
                 (x1 << place_bits) <= end_of(s_.entries - 1);
  }
  // The rulings of the whole span have been surveyed.
  [[nodiscard]] bool is_usable() const { return is_usable_; }

  void paint() {
    std::int32_t i = 0;
    for (std::int32_t end = s_.entries; i < end;) {
      const std::int32_t middle = i + (end - i) / 2;
      (end_of(middle) < x0_ << place_bits ? i : end) = end_of(middle) < x0_ << place_bits ? middle + 1 : middle;
    }
    level_ = level_of(entries_[i > 0 ? i - 1 : 0]);
    from_ = x0_;
    RunPainter run(job_.painter, x0_, level_);
    for (i = paint_certain(run, i); i < s_.entries; i = paint_certain(run, i + 1)) ask(run, i);
    if (from_ <= x1_) run.change(from_, level_);
    run.end(x1_);
    job_.counters.level_spans += runs_;
  }

 private:
  static std::int32_t level_of(std::uint32_t entry) {
    return static_cast<std::int32_t>(entry & ((1U << entry_level_bits) - 1));
  }
  static std::int32_t upper(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::int32_t>(std::uint64_t{a} * b >> 32);
  }
  // From there on an entry's level holds.
  [[nodiscard]] std::int32_t end_of(std::int32_t i) const { return base_ + upper(entries_[i], width_); }

  // Entries from i on, as far as no dot is unsure: the loop that most of the time goes to. Returns the entry to ask about, or their
  // number.
  [[nodiscard]] std::int32_t paint_certain(RunPainter& painter, std::int32_t i) {
    RunPainter run = painter;
    std::int32_t from = from_, level = level_;
    std::uint32_t runs = runs_;
    const std::int32_t base = base_, unsure = unsure_, x1 = x1_, end = s_.entries;
    const std::uint32_t width = width_;
    const std::uint32_t* const entries = entries_;
    for (; i < end; ++i) {
      const std::uint32_t entry = entries[i];
      const std::int32_t at = base + upper(entry, width);
      if ((at & (one_dot - 1)) <= unsure) break;
      const std::int32_t x = (at >> place_bits) + 1;
      if (x > from) {
        if (x > x1) {
          i = end;
          break;
        }
        run.change(from, level);
        ++runs;
        from = x;
      }
      level = level_of(entry);
    }
    painter = run;
    from_ = from;
    level_ = level;
    runs_ = runs;
    return i;
  }

  // Entry i, which may change the level on either side of a dot.
  [[gnu::noinline]] void ask(RunPainter& run, std::int32_t i) {
    const std::int32_t x = end_of(i) >> place_bits;
    if (x >= from_ && x <= x1_) {
      if (x > from_) run.change(from_, level_);
      level_ = search_level(job_.table, level_, [&](std::int32_t k) { return reaches_level(job_, x, y_, k); });
      run.change(x, level_);
      from_ = x + 1;
      runs_ += 2;
      ++job_.counters.intensities;
    }
    if (x <= x1_) level_ = level_of(entries_[i]);
  }

  const ShadeJob& job_;
  const StraightContours& s_;
  const std::uint32_t* entries_;
  std::int32_t y_, x0_, x1_;
  bool is_usable_ = false;
  std::uint32_t width_ = 0;             // of the rulings surveyed, on this line
  std::int32_t base_ = 0, unsure_ = 0;  // of where an entry's level holds for sure, and by how much less it may
  std::int32_t from_ = 0, level_ = 0;   // from that dot on that level, not shown yet
  std::uint32_t runs_ = 1;
};

}  // namespace

// The first pays where it saves that on a face as high as the span is wide; later ones, further on, where spans have missed as much since,
// those by the last survey counting an eighth. After a failure it is twice as much.
bool is_survey_due(const StraightContours& s, std::int32_t n, const SurveyChance& chance) {
  return (!s.tried && std::int64_t{chance.gain} * n >= chance.cost) || s.missed >= std::int64_t{chance.cost}
                                                                                       << s.failures;
}

bool straight_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1,
                      const SurveyChance& chance) {
  StraightContours& s = job.contours->straight;
  if (job.contours->block.empty()) return false;
  StraightSpan span(job, y, x0, x1);
  if (span.is_usable()) {
    span.paint();
    s.missed += chance.gain / 8;
    return true;
  }
  s.missed += chance.gain;
  if (!is_survey_due(s, x1 - x0 + 1, chance)) return false;
  s.missed = 0;
  s.tried = true;
  if (!survey_rulings(job, y, x0, x1)) {
    s.failures = static_cast<std::uint16_t>(std::min(s.failures + 1, 16));
    return false;
  }
  s.failures = 0;
  StraightSpan surveyed(job, y, x0, x1);
  if (!surveyed.is_usable()) return false;
  surveyed.paint();
  return true;
}

}  // namespace halfspace
