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
    blur_ = entry + 6;
    unsure_ = blur_ + unit;
    base_ = static_cast<std::int32_t>(left) + 4 + entry;
    is_usable_ = unsure_ < one_dot / 8 && (x0 << place_bits) >= place_of(entries_[0]) - unsure_ &&
                 (x1 << place_bits) <= place_of(entries_[s_.entries - 1]);
  }
  // The rulings of the whole span have been surveyed.
  [[nodiscard]] bool is_usable() const { return is_usable_; }

  void paint() { job_.painter.is_bilevel() ? paint_by<BilevelRuns>() : paint_by<RunPainter>(); }

 private:
  static std::int32_t level_of(std::uint32_t entry) {
    return static_cast<std::int32_t>(entry & ((1U << entry_level_bits) - 1));
  }
  static std::int32_t upper(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::int32_t>(std::uint64_t{a} * b >> 32);
  }
  // From there on an entry's level holds; what its low bits add is in unsure_.
  [[nodiscard]] std::int32_t place_of(std::uint32_t entry) const { return base_ + upper(entry, width_); }
  // The first entry whose level holds only from `place` on or later. Without their low bits entries are in order.
  [[nodiscard]] std::int32_t first_from(std::int32_t place) const {
    std::int32_t i = 0;
    for (std::int32_t end = s_.entries; i < end;) {
      const std::int32_t middle = i + (end - i) / 2;
      const bool is_before = place_of(entries_[middle] >> entry_level_bits << entry_level_bits) < place;
      (is_before ? i : end) = is_before ? middle + 1 : middle;
    }
    return i;
  }

  template <class Run>
  void paint_by() {
    const std::int32_t from = first_from(x0_ << place_bits);
    const std::int32_t end = first_from((x1_ << place_bits) + blur_ + 1);
    const std::int32_t level = level_of(entries_[from > 0 ? from - 1 : 0]);
    Run run(job_.painter, x0_, level);
    if (job_.painter.is_bilevel()) {
      paint_edges(run, level, entries_ + from, entries_ + end);
    } else {
      paint(run, entries_ + from, entries_ + end);
    }
    run.end(x1_);
    job_.counters.level_spans += static_cast<std::uint32_t>(1 + end - from);
    if (split_ != nullptr) split();
  }

  // Leaves out entries to a level that looks like the last one: these matter nowhere, as beside its interval, and in it, the level is one of
  // both.
  template <class Run>
  void paint_edges(Run& run, std::int32_t level, const std::uint32_t* at, const std::uint32_t* end) {
    const LevelEdges edges = job_.painter.edges();
    std::int32_t* const shown = job_.scratch.data();
    const std::int32_t* const room = shown + job_.scratch.size();
    while (at != end) {
      std::int32_t* to = shown;
      while (at != end && to != room) {
        const std::int32_t rise = level_of(*at) - level;
        // Entries to levels that look alike, as far as they go on as the first does. As levels change by one at most, all do if the last does.
        const std::int32_t alike = rise > 0   ? edges.from(level + 1) - level - 1
                                   : rise < 0 ? level - edges.to(level)
                                              : 0;
        std::int32_t hop = std::min(alike, static_cast<std::int32_t>(end - at) - 1);
        if (level_of(at[hop]) != level + (hop + 1) * rise) {
          for (hop = 0; level_of(at[hop + 1]) - level_of(at[hop]) == rise;) ++hop;
        }
        at += hop;
        if (hop == alike) *to++ = static_cast<std::int32_t>(*at);
        level = level_of(*at++);
      }
      paint(run, shown, to);
    }
  }

  template <class Run, class Entry>
  void paint(Run& run, const Entry* at, const Entry* end) {
    for (at = paint_certain(run, at, end); at != end; at = paint_certain(run, at + 1, end)) {
      // An entry may change the level on either side of a dot, which may have been asked for another entry's sake.
      const auto entry = static_cast<std::uint32_t>(*at);
      const std::int32_t x = place_of(entry) >> place_bits;
      if (x != asked_) {
        const std::int32_t level = ask(x, level_of(entry));
        run.change(x, level);
        if (s_.left_slope == 0 && s_.width_slope == 0) settle_column(entry, x, level);
      }
      if (x < x1_) run.change(x + 1, level_of(entry));
    }
  }

  // As far as no dot is unsure: the loop that most of the time goes to. Returns the entry to ask about, or the end.
  template <class Run, class Entry>
  [[nodiscard]] const Entry* paint_certain(Run& painter, const Entry* at, const Entry* end) const {
    Run run = painter;
    const std::int32_t base = base_ + one_dot, unsure = unsure_;
    const std::uint32_t width = width_;
    for (; at != end; ++at) {
      const auto entry = static_cast<std::uint32_t>(*at);
      const std::int32_t place = base + upper(entry, width);
      if ((place & (one_dot - 1)) <= unsure) break;
      run.change(place >> place_bits, level_of(entry));
    }
    painter = run;
    return at;
  }

  // The level of dot x, next to `guess` as a rule.
  [[nodiscard, gnu::noinline]] std::int32_t ask(std::int32_t x, std::int32_t guess) {
    asked_ = x;
    ++job_.counters.level_spans;
    ++job_.counters.intensities;
    return search_level(job_.table, guess, [&](std::int32_t k) { return reaches_level(job_, x, y_, k); });
  }

  // Where rulings are columns and a dot has told its level, all dots of its column have: the entry is moved off them, to the side where it
  // changes; or to both sides, once the line is done, where a ridge touches a level in the column alone.
  [[gnu::noinline]] void settle_column(std::uint32_t entry, std::int32_t x, std::int32_t level) {
    if (job_.face.kind != FaceKind::root || !job_.face.surface.is_upright()) return;
    std::uint32_t* const end = entries_ + s_.entries;
    std::uint32_t* const at = std::find(entries_, end, entry);
    if (at == entries_ || at + 1 >= end) return;
    const std::int32_t before = level_of(at[-1]), behind = level_of(entry);
    const bool moves_left = level != before, moves_right = !moves_left || level != behind;
    const std::uint32_t left = moved(entry, -(unsure_ + 1), level);
    const std::uint32_t right = moved(entry, 2 * unsure_ + 2, behind);
    if (moves_left && (left <= at[-1] || !is_certain(left, x - 1))) return;
    if (moves_right && (right >= at[1] || !is_certain(right, x))) return;
    if (!moves_left || !moves_right) {
      *at = moves_left ? left : right;
    } else if (before == behind) {
      split_ = at;
      split_left_ = left;
      split_right_ = right;
    }
  }
  void split() {
    std::uint32_t* const end = entries_ + s_.entries;
    if (static_cast<std::size_t>(s_.entries) == job_.contours->block.size()) return;
    std::copy_backward(split_ + 1, end, end + 1);
    split_[0] = split_left_;
    split_[1] = split_right_;
    ++job_.contours->straight.entries;
  }
  [[nodiscard]] std::uint32_t moved(std::uint32_t entry, std::int32_t places, std::int32_t level) const {
    const auto a_place = static_cast<std::uint32_t>((std::uint64_t{1} << 32) / width_ + 1);
    const std::uint32_t there = entry + a_place * static_cast<std::uint32_t>(places);  // by less than 2^17 2^13
    return there >> entry_level_bits << entry_level_bits | static_cast<std::uint32_t>(level);
  }
  [[nodiscard]] bool is_certain(std::uint32_t entry, std::int32_t x) const {
    const std::int32_t place = place_of(entry);
    return place >> place_bits == x && (place & (one_dot - 1)) > unsure_;
  }

  const ShadeJob& job_;
  const StraightContours& s_;
  std::uint32_t* entries_;
  std::int32_t y_, x0_, x1_;
  bool is_usable_ = false;
  std::uint32_t width_ = 0;             // of the rulings surveyed, on this line
  std::int32_t base_ = 0, unsure_ = 0;  // of where an entry's level holds for sure, and by how much less it may
  std::int32_t blur_ = 0;               // unsure_ of an entry without its low bits
  std::int32_t asked_ = -1;             // the dot last asked for
  std::uint32_t* split_ = nullptr;      // an entry to be replaced by two
  std::uint32_t split_left_ = 0, split_right_ = 0;
};

}  // namespace

// The first where it pays; a later one, further on, where it should and the last has saved four times as much, or spans have missed it
// since. After a failure it is twice as much.
bool is_survey_due(StraightContours& s, std::int32_t lines, const SurveyChance& chance) {
  if (!s.tried) {
    s.begun.add(chance.gain);
    return s.begun.pays(lines, chance.cost);
  }
  s.missed += chance.gain;
  return std::int64_t{chance.gain} * lines >= chance.cost && s.missed >= std::int64_t{chance.cost} << s.failures;
}

bool straight_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  if (job.contours->block.empty()) return false;
  StraightSpan span(job, y, x0, x1);
  if (!span.is_usable()) return false;
  span.paint();
  return true;
}

bool surveyed_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  StraightContours& s = job.contours->straight;
  if (job.contours->block.empty()) return false;
  s.missed = 0;
  s.tried = true;
  if (!survey_rulings(job, y, x0, x1)) {
    s.failures = static_cast<std::uint16_t>(std::min(s.failures + 1, 16));
    return false;
  }
  s.failures = 0;
  return straight_contour(job, y, x0, x1);
}

}  // namespace halfspace
