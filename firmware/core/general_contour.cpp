// Any face: a scan line is cut into pieces on which the intensity is proven monotone (ridge_form.hpp), and each piece into
// chords (level_chord.hpp), whose ends tell where between them the boundaries between levels lie, to a small part of a dot.
//   Tracks   Once a boundary is found, its path over a strip of lines is sought (boundary_tracks.hpp), and most lines take it from there.
//   Proof    A place comes with a proven error; a dot within it is asked.
//   Lengths  A chord as long as keeps that error small: grown from chord to chord, halved where it is not.
// State   Between lines the forms of a block of them, which any line of it could make anew, and the tracks; a line without them has the same dots.
#include <algorithm>

#include "firmware/core/boundary_tracks.hpp"
#include "firmware/core/chord_divisor.hpp"
#include "firmware/core/contour.hpp"
#include "firmware/core/level_chord.hpp"
#include "firmware/core/line_section.hpp"
#include "firmware/core/quotient_ridge.hpp"
#include "firmware/core/quotient_section.hpp"
#include "firmware/core/ridge_form.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t short_piece = 6;   // dots that are asked one by one, rather than cut further
constexpr std::int32_t first_chord = 24;  // dots
constexpr std::int32_t few_dots = 16;     // that are not worth a ridge form: they go one by one
constexpr std::int32_t least_chord = 8;   // dots of a span that chords are tried on, before a ridge form is made
constexpr std::int32_t short_span = 80;   // at most
constexpr int most_failures = 2;          // of these
constexpr std::int32_t most_vain = 3;     // spans on which they failed: then they are tried on one line of eight
constexpr std::int32_t many_unsure = 64;  // courses on a block's lines: ridge forms of 64 bits take less
// Errors of places, 2^-16 dot: a chord is cut above the one, and below the other the next is longer.
constexpr std::int32_t coarse = 1 << 15, fine = 1 << 11;
constexpr std::int32_t most_blur = 3 << 15;  // where all dots within it are asked

// The parts that a span of a face with a root is traced by; and one whose z is a quotient.
struct RootParts {
  using Forms = SectionForms;
  using Line = LineForms;
  using Section = LineSection;
  using Ridge = RidgeForm;
  using RidgeDot = halfspace::RidgeDot;
  using Dot = LevelDot;
  using Chord = LevelChord;

  static const Forms& forms(const GeneralContours& face) { return face.forms; }
  static Ridge ridge(const GeneralContours& face, const Line& line) {
    return {face.forms, line, face.unsure_courses >= many_unsure};
  }
  // Whether s falls from a to b by more than 1 / 2^bits of it.
  static bool falls(const Dot& a, const Dot& b, int bits) { return a.s - (a.s >> bits) > b.s; }
  // How often s at a goes into that at b, up to 64; 1 if not twice.
  static std::int32_t growth(const Dot& a, const Dot& b) {
    return b.s / 2 <= a.s ? 1 : std::min<std::int32_t>(b.s / std::max<std::int32_t>(a.s, 1), 64);
  }
};
struct QuotientParts {
  using Forms = QuotientForms;
  using Line = QuotientLine;
  using Section = QuotientSection;
  using Ridge = QuotientRidge;
  using RidgeDot = QuotientRidge::Dot;
  using Dot = QuotientDot;
  using Chord = QuotientChord;

  static const Forms& forms(const GeneralContours& face) { return face.quotient; }
  static Ridge ridge(const GeneralContours& /*face*/, const Line& line) { return Ridge(line); }
  // It has no limb.
  static bool falls(const Dot& /*a*/, const Dot& /*b*/, int /*bits*/) { return false; }
  static std::int32_t growth(const Dot& /*a*/, const Dot& /*b*/) { return 1; }
};

// Its lines are rulings, of one level each: the quadric has no x.
bool is_along_lines(const ActiveFace& face) {
  return face.c[0].is_zero() && face.c[3].is_zero() && face.c[5].is_zero() && face.c[6].is_zero();
}

// Tracks pay on blocks that begin on a span of 256 dots or more, where most of a block's lines show each boundary, and where forms are by s;
// and a face with straight contours has other use for its block.
constexpr std::int32_t fewest_dots = 416, block_lines = 32;
std::span<std::uint32_t> tracked_block(const ShadeJob& job) {
  const FaceContours& face = *job.contours;
  const SectionForms& forms = face.general.forms;
  if (face.kind != ContourKind::general || face.general.is_quotient || face.general.has_other || forms.by_depth) {
    return {};
  }
  const bool pays = forms.x1 - forms.x0 >= fewest_dots && job.painter.edges_of(block_lines) >= block_lines / 2;
  return pays ? face.block : std::span<std::uint32_t>{};
}

template <class Parts, class Painter>  // of a row
class SpanTracer {
 public:
  SpanTracer(const ShadeJob& job, const typename Parts::Line& line, std::int32_t y, std::int32_t x0)
      : job_(job),
        y_(y),
        bars_(job.contours->general.bars),
        on_line_(line),
        line_(Parts::forms(job.contours->general), line),
        tracks_(job.contours->general, tracked_block(job), y),
        edges_(job.painter.edges()),
        painter_(job.painter, x0, 0) {}

  void run(std::int32_t x0, std::int32_t x1);

 private:
  using Dot = typename Parts::Dot;
  using Chord = typename Parts::Chord;
  using Ridge = typename Parts::Ridge;
  using RidgeDot = typename Parts::RidgeDot;
  // A dot where a piece may begin or end.
  struct Stop {
    RidgeDot ridge;
    Dot dot;
  };

  [[nodiscard]] Dot level_dot(std::int32_t t) const {
    ++job_.contours->general.steps;
    return {line_, t, bars_.error};
  }
  // Whether a dot reaches level k; `above` is that of its bar.
  [[nodiscard]] bool reaches(const Dot& dot, std::int32_t k, std::int32_t above) const {
    if (above > dot.error) return true;
    return above >= -dot.error && settle(dot.t, k);
  }
  [[nodiscard]] bool reaches(const Dot& dot, std::int32_t k) const { return reaches(dot, k, dot.above(bars_.at(k))); }
  [[nodiscard, gnu::noinline]] bool settle(std::int32_t t, std::int32_t k) const {
    job_.contours->general.steps += 4;
    const std::int32_t x = line_.middle() + t;
    const Answer answer = line_.forms().reaches(x, y_, job_.table.squares[static_cast<std::size_t>(k)]);
    return answer == Answer::unsure ? reaches_level(job_, x, y_, k) : answer == Answer::yes;
  }
  // By a guess from a level's bar: they go up evenly.
  [[nodiscard]] std::int32_t level_of(const Dot& dot) const {
    const std::int32_t gap = std::max<std::int32_t>(high_product(static_cast<std::int32_t>(bars_.step), dot.n), 1);
    const std::int32_t near = job_.table.top_level + dot.above(bars_.top) / gap - 1;
    return search_level(job_.table, std::clamp(near, job_.table.ambient_level, job_.table.top_level),
                        [&](std::int32_t k) { return reaches(dot, k); });
  }
  [[nodiscard]] Stop stop_at(const Ridge& ridge, std::int32_t t) const { return {ridge.at(t), level_dot(t)}; }

  struct Piece {
    Course course;
    bool level;  // all of it
  };
  [[nodiscard]] Piece next_piece(const Ridge& form, const Stop& a, Stop& b) const;
  [[nodiscard]] bool keeps_level(const Dot& a, const Dot& b) const;
  void dot_by_dot(const Dot& from, const Dot& to);
  void step_over(const Dot& from, const Dot& to);
  void dot(const Dot& dot);
  struct RidgeStop {
    std::int32_t t;
    RidgeDot ridge;
  };
  RidgeStop last_alike(const Ridge& form, RidgeStop from, RidgeStop other) const;
  void ridge_between(const Ridge& form, const Stop& a, const Stop& b);
  void by_pieces(const Ridge& form, const Dot& from, const Dot& to);
  [[nodiscard]] bool trusts_chords(std::int32_t dots) const;
  [[nodiscard]] std::int32_t only_boundary(std::int32_t k, bool rising, std::int32_t t, std::int32_t width,
                                           const LevelPlace& place) const;
  [[nodiscard]] bool passes(Dot& a, const Dot& c);
  [[nodiscard]] Dot by_chords(Dot a, const Dot& b);
  [[nodiscard]] std::int32_t chord_width(const Dot& a, const Dot& b) const;
  struct Reached {
    std::int32_t k;  // the next boundary's level
    std::int32_t t;  // a dot that it does not lie left of
  };
  [[gnu::noinline]] Reached follow(Reached from, std::int32_t end, bool rising, const Dot& a, const Dot& b);
  void monotone(Dot a, const Dot& b, bool rising);
  [[nodiscard]] std::int32_t boundary(std::int32_t k, bool rising, std::int32_t t, std::int32_t width,
                                      const LevelPlace& place) const;
  [[nodiscard, gnu::noinline]] std::int32_t asked_boundary(std::int32_t k, bool rising, std::int32_t before,
                                                           std::int32_t from) const;

  // The levels from the one so far to the next are passed.
  void reach_level(std::int32_t next) {
    job_.counters.level_spans += size(next - level_);
    level_ = next;
  }

  // The next boundary that shows, from level k on; and whether it comes before level `end`.
  [[nodiscard]] std::int32_t edge(std::int32_t k, std::int32_t sign) const {
    return sign > 0 ? edges_.from(k) : edges_.to(k);
  }
  [[nodiscard]] static bool has_boundary(std::int32_t k, std::int32_t end, std::int32_t sign) {
    return (end - k) * sign > 0;
  }

  const ShadeJob& job_;
  std::int32_t y_;
  const LevelBars& bars_;
  const typename Parts::Line& on_line_;
  typename Parts::Section line_;
  BoundaryTracks tracks_;
  LevelEdges edges_;
  Painter painter_;
  std::int32_t level_ = 0;            // so far
  std::int32_t chord_ = first_chord;  // the next one's width, if it may be
};

// Both, and all dots between them, have the level so far.
template <class Parts, class Painter>
bool SpanTracer<Parts, Painter>::keeps_level(const Dot& a, const Dot& b) const {
  const Chord chord(line_, a, b);
  const auto keeps = [&](int sign, std::int32_t k) {
    const std::uint32_t bar = bars_.at(k);
    return chord.keeps_sign(sign, bar, a.above(bar), b.above(bar));
  };
  return (level_ == job_.table.ambient_level || keeps(1, level_)) &&
         (level_ == job_.table.top_level || keeps(-1, level_ + 1));
}

// A dot for itself.
template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::dot(const Dot& dot) {
  const std::int32_t next = level_of(dot);
  if (next != level_) painter_.change(line_.middle() + dot.t, next);
  reach_level(next);
  ++job_.counters.intensities;
}

// Each dot after `from` up to `to` for itself.
template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::dot_by_dot(const Dot& from, const Dot& to) {
  for (std::int32_t t = from.t + 1; t < to.t; ++t) dot(level_dot(t));
  dot(to);
}

// On from `from` to `to`, where the course is not known.
template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::step_over(const Dot& from, const Dot& to) {
  if (to.t - from.t == 1 || !keeps_level(from, to)) dot_by_dot(from, to);
}

// The last dot from `from` towards another whose course is surely that of `from`, where the form has one root between them.
template <class Parts, class Painter>
auto SpanTracer<Parts, Painter>::last_alike(const Ridge& form, RidgeStop from, RidgeStop other) const -> RidgeStop {
  const int sign = from.ridge.sign();
  bool from_moved = false;
  bool other_moved = false;
  for (int tries = 0;; ++tries) {
    const std::int32_t way = other.t - from.t;
    if (way == 1 || way == -1) return from;
    // Regula falsi, an end that stays twice halved [Dowell, Jarratt 1971]; |w| < 2^30, |way| < 2^11.
    const std::int32_t fall = from.ridge.w - other.ridge.w;
    const int shift = std::max(0, 13 - std::countl_zero(static_cast<std::uint32_t>(fall < 0 ? -fall : fall)));
    std::int32_t step = tries < 8 && fall != 0 ? way * (from.ridge.w >> shift) / (fall >> shift) : way / 2;
    step = way > 0 ? std::clamp<std::int32_t>(step, 1, way - 1) : std::clamp<std::int32_t>(step, way + 1, -1);
    const RidgeStop next{from.t + step, form.at(from.t + step)};
    if (next.ridge.sign() == sign) {
      from = next;
      if (from_moved) other.ridge.w /= 2;
      from_moved = true;
      other_moved = false;
    } else {
      other = next;
      if (other_moved) from.ridge.w /= 2;
      other_moved = true;
      from_moved = false;
    }
  }
}

template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::ridge_between(const Ridge& form, const Stop& a, const Stop& b) {
  RidgeStop from{a.dot.t, a.ridge};
  RidgeStop to{b.dot.t, b.ridge};
  std::int32_t& ridge = job_.contours->general.ridge;
  if (const std::int32_t t = ridge - line_.middle(); from.t < t && t < to.t) {  // near the last line's
    const RidgeStop there{t, form.at(t)};
    (there.ridge.sign() == from.ridge.sign() ? from : to) = there;
  }
  const RidgeStop first = last_alike(form, from, to);
  ridge = line_.middle() + first.t;
  const Dot left = first.t == a.dot.t ? a.dot : level_dot(first.t);
  monotone(a.dot, left, a.ridge.sign() > 0);
  RidgeStop last{first.t + 1, form.at(first.t + 1)};
  if (last.ridge.sign() != b.ridge.sign()) last = last_alike(form, {b.dot.t, b.ridge}, first);
  const Dot right = last.t == b.dot.t ? b.dot : level_dot(last.t);
  step_over(left, right);
  monotone(right, b.dot, b.ridge.sign() > 0);
}

// The first dot beyond level k right of dot t, where it is not yet reached, and at most `width` from there. An unknown place errs by more
// than any width.
template <class Parts, class Painter>
std::int32_t SpanTracer<Parts, Painter>::boundary(std::int32_t k, bool rising, std::int32_t t, std::int32_t width,
                                                  const LevelPlace& place) const {
  const std::int32_t before = (place.at - place.error) >> 16;
  const std::int32_t last = (place.at + place.error) >> 16;
  const std::int32_t from = t + std::min(last + 1, width);
  return before == last ? from : asked_boundary(k, rising, t + std::max<std::int32_t>(before, 0), from);
}

// The first dot beyond level k between `before`, which is not, and `from`, which is.
template <class Parts, class Painter>
std::int32_t SpanTracer<Parts, Painter>::asked_boundary(std::int32_t k, bool rising, std::int32_t before,
                                                        std::int32_t from) const {
  while (from - before > 1) {
    const std::int32_t middle = before + (from - before) / 2;
    const Answer answer = line_.reaches(middle, job_.table.squares[static_cast<std::size_t>(k)]);
    const bool yes = answer == Answer::unsure ? settle(middle, k) : answer == Answer::yes;
    (yes == rising ? from : before) = middle;
  }
  return from;
}

// Of the next chord from a. Where s halves before the end, that is a limb, and a chord into it would be cut (level_chord.cpp).
template <class Parts, class Painter>
std::int32_t SpanTracer<Parts, Painter>::chord_width(const Dot& a, const Dot& b) const {
  const std::int32_t rest = b.t - a.t;
  if (rest > 1 && rest < 2 * chord_ && (Parts::falls(a, b, 1) || Parts::falls(b, a, 1))) return rest / 2;
  return rest <= chord_ + chord_ / 2 ? rest : chord_;
}

// Boundaries from level k on that have paths, between dots a and b of a piece: no dot of theirs is computed but to ask.
template <class Parts, class Painter>
auto SpanTracer<Parts, Painter>::follow(Reached from, std::int32_t end, bool rising, const Dot& a, const Dot& b)
    -> Reached {
  const std::int32_t sign = rising ? 1 : -1;
  const std::int32_t below = rising ? 0 : 1;
  const std::int32_t middle = line_.middle();
  const std::int32_t first = middle + a.t;
  const std::int32_t last = middle + b.t;
  const PathLine line = tracks_.line();
  std::int32_t beyond = 0;
  std::int32_t k = from.k;
  Painter painter = painter_;
  for (; has_boundary(k, end, sign); k = edge(k + sign, sign)) {
    const std::uint32_t* path = tracks_.slot_of(k, rising);
    if (!BoundaryTracks::is_path(*path)) break;
    const std::int32_t x = line.x_of(*path);
    const std::int32_t error = BoundaryTracks::error_of(*path);
    const std::int32_t before = (x - error) >> 16;
    const std::int32_t there = (x + error) >> 16;
    if (before < first || there >= last) break;
    beyond = there + 1;
    if (there != before) beyond = middle + asked_boundary(k, rising, before - middle, beyond - middle);
    painter.change(beyond, k - below);
  }
  painter_ = painter;
  return {k, k == from.k ? from.t : beyond - 1 - middle};
}

// From a to b, where levels only rise or fall. A lead is F where they rise, -F where they fall: it goes up.
template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::monotone(Dot a, const Dot& b, bool rising) {
  const std::int32_t sign = rising ? 1 : -1;
  const std::int32_t below = rising ? 0 : 1;  // of a boundary's level, what is painted beyond it
  const std::int32_t last_level = level_of(b);
  const std::int32_t end = rising ? last_level + 1 : last_level;
  const std::uint32_t bar_step = rising ? bars_.step : -bars_.step;
  std::int32_t k = rising ? level_ + 1 : level_;  // the next boundary's
  if ((end - k) * sign <= 0) return;
  reach_level(last_level);
  const auto is_beyond = [&](const Dot& dot, std::int32_t lead) {
    return has_boundary(k, end, sign) && (lead > dot.error || (lead >= -dot.error && settle(dot.t, k) == rising));
  };
  // As many levels as dots: dots one by one take less.
  const auto is_crowded = [&](const Lead& lead, std::uint32_t bar, std::int32_t width) {
    return job_.painter.edges_of((end - k) * sign) > width &&
           lead.of(bar + static_cast<std::uint32_t>(width) * bar_step) > 0;
  };
  std::int32_t followed = -1;
  k = edge(k, sign);
  while (has_boundary(k, end, sign) && a.t < b.t) {
    if (k != followed && tracks_.any() && BoundaryTracks::is_path(*tracks_.slot_of(k, rising))) {
      const Reached reached = follow({k, a.t}, end, rising, a, b);
      followed = reached.k;
      if (!has_boundary(reached.k, end, sign)) return;
      if (reached.t > a.t) a = level_dot(reached.t);
      k = reached.k;
    }
    const std::int32_t rest = b.t - a.t;
    const std::int32_t width = chord_width(a, b);
    const Dot c = width == rest ? b : level_dot(a.t + width);
    const Lead lead_c = c.lead(sign);
    std::uint32_t bar = bars_.at(k);
    std::int32_t at_c = lead_c.of(bar);
    if (!is_beyond(c, at_c)) {
      chord_ = std::min(width + width / 4 + 1, longest_half);
    } else if (width == 1) {  // all boundaries between them are one
      int passed = 0;
      do {
        ++passed;
        k = edge(k + sign, sign);
        at_c = lead_c.of(bars_.at(k));
      } while (is_beyond(c, at_c));
      painter_.change(line_.middle() + c.t, k - sign - below);
      if (passed == 1) chord_ = 2;
    } else if (is_crowded(lead_c, bar, width)) {
      chord_ = 1;
      continue;
    } else if (const std::int32_t ratio = Parts::growth(a, c); ratio > 1) {
      // From a limb, where s^2 is about linear: as far as it is not twice as large.
      chord_ = std::max<std::int32_t>(width / (ratio * ratio), 1);
      continue;
    } else {
      Chord chord(line_, a, c);
      if (!rising) chord.mirror();
      const Lead lead_a = a.lead(sign);
      LevelPlace place = chord.place(bar, lead_a.of(bar), at_c);
      if (width > 2 && place.error > coarse) {
        chord_ = width / 2;
        continue;
      }
      const bool nears_limb = Parts::falls(a, c, 2);
      chord_ = nears_limb ? (width + 1) / 2 : place.error < fine ? 2 * width : width;
      const std::int32_t middle = line_.middle();
      for (;;) {
        painter_.change(middle + boundary(k, rising, a.t, width, place), k - below);
        if (place.error < coarse) tracks_.begin(k, rising, a.t * (1 << 16) + place.at);
        k = edge(k + sign, sign);
        bar = bars_.at(k);
        at_c = lead_c.of(bar);
        if (!is_beyond(c, at_c)) break;
        place = chord.place(bar, lead_a.of(bar), at_c);
      }
    }
    a = c;
  }
}

// What is known from a to b, b drawn nearer until that is something or they are near each other.
template <class Parts, class Painter>
auto SpanTracer<Parts, Painter>::next_piece(const Ridge& form, const Stop& a, Stop& b) const -> Piece {
  for (;;) {
    const Course course = form.course(a.ridge, b.ridge);
    job_.contours->general.steps += 5;
    if (course != Course::unsure) return {course, false};
    if (keeps_level(a.dot, b.dot)) return {course, true};
    ++job_.contours->general.unsure_courses;
    if (b.dot.t - a.dot.t <= short_piece) return {course, false};
    b = stop_at(form, a.dot.t + (b.dot.t - a.dot.t) / 2);
  }
}

// The same, in dots from t, where nothing proves that F has one sign on either side of it within the place's error: all dots there are asked. 0 if
// they have more.
template <class Parts, class Painter>
std::int32_t SpanTracer<Parts, Painter>::only_boundary(std::int32_t k, bool rising, std::int32_t t, std::int32_t width,
                                                       const LevelPlace& place) const {
  const std::int32_t before = std::max<std::int32_t>((place.at - place.error) >> 16, 0);
  std::int32_t from = std::min<std::int32_t>(((place.at + place.error) >> 16) + 1, width);
  bool all_beyond = true;
  for (std::int32_t at = from - 1; at > before; --at) {
    const bool is_beyond = asked_boundary(k, rising, t + at - 1, t + at + 1) == t + at;
    if (is_beyond && !all_beyond) return 0;
    all_beyond = is_beyond;
    if (is_beyond) from = at;
  }
  return from;
}

// From a to c by their chord alone: what shows changes once at each boundary between their levels and at no other, as F is a quadratic without
// a turn, but for a known error. False if that is not so; a is as far as it is.
template <class Parts, class Painter>
bool SpanTracer<Parts, Painter>::passes(Dot& a, const Dot& c) {
  const std::int32_t width = c.t - a.t;
  const std::int32_t next = level_of(c);
  const bool rising = next > level_;
  const std::int32_t sign = rising ? 1 : -1;
  const std::int32_t below = rising ? 0 : 1;
  Chord chord(line_, a, c);
  const auto keeps = [&](int side, std::int32_t k) {
    const std::uint32_t bar = bars_.at(k);
    return chord.keeps_sign(side, bar, a.above(bar), c.above(bar));
  };
  const std::int32_t reached = edges_.to(std::min(level_, next));
  const std::int32_t missed = edges_.from(std::max(level_, next) + 1);
  if (reached > job_.table.ambient_level && !keeps(1, reached)) return false;
  if (missed <= job_.table.top_level && !keeps(-1, missed)) return false;
  if (!rising) chord.mirror();
  const Lead lead_a = a.lead(sign);
  const Lead lead_c = c.lead(sign);
  const std::int32_t end = rising ? next + 1 : next;
  std::int32_t beyond = 0;
  for (std::int32_t k = edge(rising ? level_ + 1 : level_, sign); has_boundary(k, end, sign);
       k = edge(k + sign, sign)) {
    const std::uint32_t bar = bars_.at(k);
    const LevelPlace place = chord.place(bar, lead_a.of(bar), lead_c.of(bar));
    const std::int32_t at = width > 2 && place.error > most_blur ? 0 : only_boundary(k, rising, a.t, width, place);
    if (at == 0) {
      if (beyond == 0) return false;
      a = level_dot(a.t + beyond);
      dot(a);
      return false;
    }
    beyond = at;
    painter_.change(line_.middle() + a.t + at, k - below);
  }
  reach_level(next);
  return true;
}

// Up to the dot returned; where chords fail the rest needs the ridge form.
template <class Parts, class Painter>
auto SpanTracer<Parts, Painter>::by_chords(Dot a, const Dot& b) -> Dot {
  std::int32_t width = b.t - a.t;
  for (int failures = 0; a.t < b.t && failures < most_failures;) {
    width = std::min(width, b.t - a.t);
    const Dot c = width == b.t - a.t ? b : level_dot(a.t + width);
    if (width == 1) {
      dot(c);
    } else if (!passes(a, c)) {
      width = std::max<std::int32_t>((c.t - a.t) / 2, 1);
      ++failures;
      continue;
    }
    width *= 2;
    a = c;
  }
  std::int32_t& vain = job_.contours->general.vain_chords;
  vain = a.t < b.t ? std::min(vain + 1, most_vain) : 0;
  return a;
}

// Whether a span is so short, and chords did not fail on the last ones.
template <class Parts, class Painter>
bool SpanTracer<Parts, Painter>::trusts_chords(std::int32_t dots) const {
  return dots >= least_chord && dots <= short_span && !tracks_.any() &&
         (job_.contours->general.vain_chords < most_vain || y_ % 8 == 0);
}

// From dot to dot, by pieces whose course is known.
template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::by_pieces(const Ridge& form, const Dot& from, const Dot& to) {
  Stop a{form.at(from.t), from};
  const Stop last{form.at(to.t), to};
  std::int32_t reach = 2 * longest_half;  // of a piece, as far as is worth a try
  while (a.dot.t < last.dot.t) {
    Stop b = last.dot.t - a.dot.t <= reach ? last : stop_at(form, a.dot.t + reach);
    const Piece piece = next_piece(form, a, b);
    reach = std::min(4 * (b.dot.t - a.dot.t), 2 * longest_half);
    if (piece.course == Course::ridge) {
      ridge_between(form, a, b);
    } else if (piece.course != Course::unsure) {
      monotone(a.dot, b.dot, a.ridge.sign() > 0);
    } else if (!piece.level) {
      dot_by_dot(a.dot, b.dot);
    }
    a = b;
  }
}

template <class Parts, class Painter>
void SpanTracer<Parts, Painter>::run(std::int32_t x0, std::int32_t x1) {
  const Dot a = level_dot(x0 - line_.middle());
  level_ = level_of(a);
  painter_.change(x0, level_);
  ++job_.counters.level_spans;
  const std::int32_t dots = x1 - x0 + 1;
  if (dots > 1 && !is_along_lines(job_.face)) {
    const Dot b = level_dot(x1 - line_.middle());
    const Dot from = trusts_chords(dots) ? by_chords(a, b) : a;
    if (b.t - from.t >= few_dots) {
      by_pieces(Parts::ridge(job_.contours->general, on_line_), from, b);
    } else if (from.t < b.t) {
      dot_by_dot(from, b);
    }
  }
  painter_.end(x1);
}

// L = 0 on the whole line.
bool is_dark(const ShadeJob& job, std::int32_t y) {
  const ActiveFace& face = job.face;
  return job.contours->general.forms.may_be_dark && face.surface.light.at(0, y - face.origin_y).is_zero();
}

template <class Parts>
void trace_line(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const typename Parts::Line line = Parts::forms(job.contours->general).on(y);
  if (job.painter.is_bilevel()) return SpanTracer<Parts, BilevelRuns>(job, line, y, x0).run(x0, x1);
  SpanTracer<Parts, RunPainter>(job, line, y, x0).run(x0, x1);
}

// A face with forms by z may be seen in several spans of a line, not all of which have them. The forms of the span before lie in the face's
// block, which has no tracks then, if they fit.
void exchange_forms(FaceContours& face) {
  GeneralContours& general = face.general;
  if (face.kind != ContourKind::general || face.block.size_bytes() < sizeof(SectionForms)) return;
  const SectionForms last = general.forms;
  const std::span<std::byte> store = std::as_writable_bytes(face.block).first<sizeof last>();
  if (general.has_other) std::ranges::copy(store, std::as_writable_bytes(std::span(&general.forms, 1)).begin());
  std::ranges::copy(std::as_bytes(std::span(&last, 1)), store.begin());
  general.has_other = true;
  general.other_is_by_depth = last.by_depth;
}

void trace_root(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  GeneralContours& general = job.contours->general;
  SectionForms& forms = general.forms;
  if (!forms.holds(y, x0, x1) && (forms.by_depth || general.has_other)) exchange_forms(*job.contours);
  if (!forms.holds(y, x0, x1)) {
    forms.cover(job, y, x0, x1);
    general.strip.drop();
    general.unsure_courses = 0;
    general.has_other = general.has_other && (forms.by_depth || general.other_is_by_depth);
  }
  if (!is_dark(job, y)) return trace_line<RootParts>(job, y, x0, x1);
  job.painter.fill(x0, x1, job.table.ambient_level);
  ++job.counters.level_spans;
}

void trace_quotient(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  QuotientForms& forms = job.contours->general.quotient;
  if (!forms.holds(y, x0, x1) && !forms.cover(job, y, x0, x1)) {
    forms = {};
    return shade_rational_span(job, Shader::isqrt, y, x0, x1);
  }
  forms.turn(quotient_sign(job.face, x0, y));
  trace_line<QuotientParts>(job, y, x0, x1);
}

}  // namespace

// T_k goes as k unit - most ambient. The top one is a root of 30 bits, off by 3, and by what its square, cut to 32 bits, lacks;
// a step is off by less than 1 of 31 bits.
LevelBars LevelBars::of(const LevelTable& table, const Lighting& lighting) {
  LevelBars bars{0, 0, table.top_level, 0};
  const std::uint64_t square = std::uint64_t{table.squares[static_cast<std::size_t>(table.top_level)]} << 28 | 1;
  const std::int32_t root = std::min<std::int32_t>(quick_root(square), (1 << 30) - 1);
  bars.top = static_cast<std::uint32_t>(root) << 1;
  bars.error = 4 + (table.top_level - table.ambient_level + 1) / 2 + (1 << 28) / std::max<std::int32_t>(root, 1);
  const std::int64_t height =
      std::int64_t{table.top_level} * lighting.unit - std::int64_t{table.levels - 1} * lighting.ambient;
  if (table.top_level > table.ambient_level + 1) {
    bars.step = static_cast<std::uint32_t>(std::uint64_t{bars.top} * static_cast<std::uint64_t>(lighting.unit) /
                                           static_cast<std::uint64_t>(height));
  }
  return bars;
}

bool general_contour(const ShadeJob& job, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  GeneralContours& face = job.contours->general;
  if (face.bars.error == 0) {
    face.bars = LevelBars::of(job.table, job.lighting);
    face.is_quotient = job.face.kind == FaceKind::rational && !has_polynomial_normal(job.face, job.lighting);
    if (face.is_quotient) face.quotient = QuotientForms{};
  }
  face.steps = 0;
  while (x0 <= x1) {
    const std::int32_t end = std::min(x1, x0 + 2 * longest_half - 1);
    (face.is_quotient ? trace_quotient : trace_root)(job, y, x0, end);
    x0 = end + 1;
  }
  return true;
}

}  // namespace halfspace
