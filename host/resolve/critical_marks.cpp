#include "host/resolve/critical_marks.hpp"

#include <algorithm>
#include <cmath>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

// Where the derivative in x of a curve of second order in x is 0.
IntervalCurve turning_line(const IntervalCurve& p) {
  const Interval slope{2 * p.q[0].low, 2 * p.q[0].high};
  return {{Interval{}, Interval{}, Interval{}, slope, p.q[1], p.q[3]}, true};
}

// A polynomial in y that vanishes where a line and a curve meet.
Polynomial crossing_lines(const Curve& line, const Curve& p) {
  return sgn(line.q[3]) == 0 ? turning_lines(line) : meeting_lines(line, p);
}

bool has_no_x(const Curve& p) { return sgn(p.q[0]) == 0 && sgn(p.q[1]) == 0 && sgn(p.q[3]) == 0; }

// Two curves that meet where a polynomial in y vanishes; where p has no x, wherever p is. Keeps references.
class Meeting {
 public:
  Meeting(const Curve& p, const IntervalCurve& near_p, const TracedCurve& q) : p_(p), near_p_(near_p), q_(q) {
    lines_ = has_no_x(p_) ? enclosed(exact_lines()) : meeting_lines(near_p, q.enclosed);
  }

  [[nodiscard]] const IntervalCurve& p() const { return near_p_; }
  [[nodiscard]] const IntervalCurve& q() const { return q_.enclosed; }
  [[nodiscard]] bool have_common_component() const {
    const auto end = lines_.c.begin() + static_cast<std::ptrdiff_t>(lines_.size);
    return lines_.size > 0 && std::all_of(lines_.c.begin(), end, [](const Interval& c) { return c.may_vanish(); }) &&
           degree(exact_lines()) < 0;
  }
  [[nodiscard]] std::vector<Mark> marks(std::int64_t y0, std::int64_t y1) const {
    return root_marks(
        lines_, [this] { return exact_lines(); }, y0, y1);
  }

 private:
  [[nodiscard]] Polynomial exact_lines() const {
    return has_no_x(p_) ? turning_lines(p_) : meeting_lines(p_, q_.curve);
  }

  const Curve& p_;
  const IntervalCurve& near_p_;
  const TracedCurve& q_;
  IntervalPolynomial lines_;
};

// A curve and its enclosure.
struct Conic {
  Curve curve;
  IntervalCurve enclosed;
};

// A quartic P^2 = R^2 d meets a section line^2 = factor^2 d on one of these, factor P = +-R line, so that nothing above degree four is needed.
// None known: nothing.
std::optional<std::vector<Conic>> conics_through_meeting(const TracedQuartic& quartic, const TracedCurve& traced) {
  if (!quartic.radical || !traced.section) return std::nullopt;
  const Curve first = traced.section->factor * quartic.radical->p;
  const Curve second = product_of_lines(quartic.radical->r, traced.section->line);
  std::vector<Conic> conics;
  for (const Curve& conic : {first - second, first + second}) {
    if (is_zero(conic)) return std::nullopt;
    if (!is_constant(conic)) conics.push_back({conic, interval_curve(conic)});
    if (is_zero(second)) break;
  }
  return conics;
}

bool is_limb(const TracedCurve& traced) { return traced.section && is_zero(traced.section->line); }

class Search {
 public:
  // Adds to `marks`.
  Search(const std::vector<SheetPresence>& sheets, std::int64_t y0, std::int64_t y1, std::vector<Mark>& marks)
      : sheets_(sheets), y0_(y0), y1_(y1), marks_(marks) {}

  void add_turns(const TracedCurve& p) {
    if (sgn(p.curve.q[0]) == 0) return add_all(turning_lines(p.curve));
    add_points(turning_line(p.enclosed), p, [&] { return turning_lines(p.curve); });
  }

  void add_meeting(const TracedCurve& p, const TracedCurve& q) {
    if (p.enclosed.is_line) return add_crossing(p.curve, p.enclosed, q);
    if (q.enclosed.is_line) return add_crossing(q.curve, q.enclosed, p);
    const auto lines = lines_through_meeting(p, q);
    if (!lines) return add_strips(Meeting(p.curve, p.enclosed, q));
    for (const Curve& line : *lines) {
      if (!is_constant(line)) add_crossing(line, interval_curve(line), p);
    }
  }

  // False if no conics are known, or one of them holds the section.
  bool add_meeting(const TracedQuartic& quartic, const TracedCurve& other) {
    const auto conics = conics_through_meeting(quartic, other);
    if (!conics) return false;
    std::vector<Meeting> meetings;
    meetings.reserve(conics->size());
    for (const Conic& conic : *conics) {
      meetings.emplace_back(conic.curve, conic.enclosed, other);
      if (meetings.back().have_common_component()) return false;
    }
    for (const Meeting& meeting : meetings) {
      if (is_limb(other)) {  // also off the face: there a root passes from sheet to sheet, and the next is renumbered
        add(meeting.marks(y0_, y1_));
      } else {
        add_strips(meeting);
      }
    }
    return true;
  }

  void add(const std::vector<Mark>& marks) { marks_.insert(marks_.end(), marks.begin(), marks.end()); }

  void sort() {
    std::sort(marks_.begin(), marks_.end());
    marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
  }

 private:
  // Those of the marks whose strip holds a piece of both curves on the face.
  void add_strips(const Meeting& meeting) {
    for (const Mark mark : meeting.marks(y0_, y1_)) {
      if (may_meet_within(meeting.p(), meeting.q(), lines_of(mark))) marks_.push_back(mark);
    }
  }

  void add_all(const Polynomial& p) { add(root_marks(p, y0_, y1_)); }

  void add_crossing(const Curve& line, const IntervalCurve& enclosed, const TracedCurve& p) {
    add_points(enclosed, p, [&] { return crossing_lines(line, p.curve); });
  }

  // Where the line meets the curve; `polynomial` has its roots there and is asked for when intervals are not enough.
  template <typename MakePolynomial>
  void add_points(const IntervalCurve& line, const TracedCurve& p, const MakePolynomial& polynomial) {
    const auto reach = static_cast<double>(std::max(std::abs(y0_), std::abs(y1_)));
    const auto points = meeting_points(line, p.enclosed, reach);
    if (!points) return add_all(polynomial());
    std::vector<Interval> unsure;
    for (std::size_t i = 0; i < static_cast<std::size_t>(points->count); ++i) {
      const IntervalPoint& point = points->at[i];
      if (!may_show(point)) continue;
      const double line_above = std::floor(point.y.low);
      if (point.y.low > line_above && point.y.high < line_above + 1) {
        marks_.push_back(2 * static_cast<Mark>(line_above) + 1);
      } else {
        unsure.push_back(point.y);
      }
    }
    if (!unsure.empty()) add_near(unsure, polynomial());
  }

  // The marks of the polynomial that touch one of the intervals.
  void add_near(const std::vector<Interval>& where, const Polynomial& polynomial) {
    for (const Mark mark : root_marks(polynomial, y0_, y1_)) {
      const Interval y = lines_of(mark);
      if (std::any_of(where.begin(), where.end(),
                      [&y](const Interval& near) { return !(near.high < y.low || near.low > y.high); })) {
        marks_.push_back(mark);
      }
    }
  }

  [[nodiscard]] bool may_meet_within(const IntervalCurve& p, const IntervalCurve& q, const Interval& y) const {
    const auto of_p = roots_in_x(p, y);
    const auto of_q = roots_in_x(q, y);
    if (!of_p || !of_q) return true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(of_p->count); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(of_q->count); ++j) {
        const Interval x{std::max(of_p->x[i].low, of_q->x[j].low), std::min(of_p->x[i].high, of_q->x[j].high)};
        if (x.low <= x.high && may_show({x, y})) return true;
      }
    }
    return false;
  }

  static Interval lines_of(Mark mark) {
    return {std::floor(static_cast<double>(mark) / 2), std::ceil(static_cast<double>(mark) / 2)};
  }

  [[nodiscard]] bool may_show(const IntervalPoint& point) const {
    if (point.y.high < static_cast<double>(y0_) || point.y.low > static_cast<double>(y1_)) return false;
    return sheets_.empty() || std::any_of(sheets_.begin(), sheets_.end(),
                                          [&point](const SheetPresence& sheet) { return sheet.may_show(point); });
  }

  const std::vector<SheetPresence>& sheets_;
  std::int64_t y0_, y1_;
  std::vector<Mark>& marks_;
};

}  // namespace

void find_critical_marks(const BoundingCurves& bounds, const std::vector<SheetPresence>& sheets, std::int64_t y0,
                         std::int64_t y1, std::vector<Mark>& marks) {
  const std::vector<TracedCurve>& curves = bounds.curves;
  const std::vector<TracedQuartic>& quartics = bounds.quartics;
  marks.clear();
  Search search(sheets, y0, y1, marks);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    search.add_turns(curves[i]);
    for (std::size_t j = 0; j < i; ++j) search.add_meeting(curves[i], curves[j]);
  }
  for (std::size_t i = 0; i < quartics.size(); ++i) {
    KnownQuartic& quartic = *quartics[i].curve;
    search.add(quartic.turns(quartics[i].radical));
    for (const TracedCurve& other : curves) {
      if (!search.add_meeting(quartics[i], other)) search.add(quartic.meetings(other.curve));
    }
    for (std::size_t j = 0; j < i; ++j) search.add(quartic.meetings(*quartics[j].curve));
  }
  search.sort();
}

}  // namespace halfspace
