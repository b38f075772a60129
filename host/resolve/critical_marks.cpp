#include "host/resolve/critical_marks.hpp"

#include <algorithm>
#include <cmath>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

// Where the derivative in x of a curve of second order in x is 0.
Curve turning_line(const Curve& p) { return {{0, 0, 0, 2 * p.q[0], p.q[1], p.q[3]}}; }

// A polynomial in y that vanishes where a line and a curve meet.
Polynomial crossing_lines(const Curve& line, const Curve& p) {
  return sgn(line.q[3]) == 0 ? turning_lines(line) : meeting_lines(line, p);
}

// A conic that meets a curve, and a polynomial in y that vanishes where they meet.
struct ConicMeeting {
  Curve conic;
  Polynomial lines;
};

// Where a quartic P^2 = R^2 d meets a section line^2 = factor^2 d: on one of the conics factor P = +-R line, so that nothing above
// degree four is needed. Nothing if such a conic holds the section.
std::optional<std::vector<ConicMeeting>> meeting_with_section(const TracedQuartic& quartic, const TracedCurve& traced) {
  if (!quartic.radical || !traced.section) return std::nullopt;
  const Curve first = traced.section->factor * quartic.radical->p;
  const Curve second = product_of_lines(quartic.radical->r, traced.section->line);
  std::vector<ConicMeeting> meetings;
  for (const Curve& conic : {first - second, first + second}) {
    if (is_zero(conic)) return std::nullopt;
    if (is_constant(conic)) continue;
    const bool without_x = sgn(conic.q[0]) == 0 && sgn(conic.q[1]) == 0 && sgn(conic.q[3]) == 0;
    meetings.push_back({conic, without_x ? turning_lines(conic) : meeting_lines(conic, traced.curve)});
    if (meetings.back().lines.empty()) continue;  // the section has no x: its turning lines hold all its points
    if (degree(meetings.back().lines) < 0) return std::nullopt;
    if (is_zero(second)) break;
  }
  return meetings;
}

bool is_limb(const TracedCurve& traced) { return traced.section && is_zero(traced.section->line); }

class Search {
 public:
  Search(const std::vector<SheetPresence>& sheets, std::int64_t y0, std::int64_t y1)
      : sheets_(sheets), y0_(y0), y1_(y1) {}

  void add_turns(const TracedCurve& p) {
    if (sgn(p.curve.q[0]) == 0) return add_all(turning_lines(p.curve));
    add_points(turning_line(p.curve), p, [&] { return turning_lines(p.curve); });
  }

  void add_meeting(const TracedCurve& p, const TracedCurve& q) {
    const auto lines = lines_through_meeting(p, q);
    if (!lines) return add_strips(p.enclosed, q.enclosed, meeting_lines(p.curve, q.curve));
    const TracedCurve& other = p.enclosed.is_line ? q : p;
    for (const Curve& line : *lines) {
      if (!is_constant(line)) add_points(line, other, [&] { return crossing_lines(line, other.curve); });
    }
  }

  // Of two curves that meet where the polynomial vanishes: those of its marks whose strip holds a piece of both on the face.
  void add_strips(const IntervalCurve& p, const IntervalCurve& q, const Polynomial& polynomial) {
    for (const Mark mark : root_marks(polynomial, y0_, y1_)) {
      if (may_meet_within(p, q, lines_of(mark))) marks_.push_back(mark);
    }
  }

  void add_all(const Polynomial& p) { add(root_marks(p, y0_, y1_)); }

  void add(const std::vector<Mark>& marks) { marks_.insert(marks_.end(), marks.begin(), marks.end()); }

  std::vector<Mark> take() {
    std::sort(marks_.begin(), marks_.end());
    marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
    return std::move(marks_);
  }

 private:
  // Where the line meets the curve; `polynomial` has its roots there and is asked for when intervals are not enough.
  template <typename MakePolynomial>
  void add_points(const Curve& line, const TracedCurve& p, const MakePolynomial& polynomial) {
    const auto reach = static_cast<double>(std::max(std::abs(y0_), std::abs(y1_)));
    const auto points = meeting_points(interval_curve(line), p.enclosed, reach);
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
  std::vector<Mark> marks_;
};

}  // namespace

std::vector<Mark> critical_marks(const BoundingCurves& bounds, const std::vector<SheetPresence>& sheets,
                                 QuarticTable& table, std::int64_t y0, std::int64_t y1) {
  const std::vector<TracedCurve>& curves = bounds.curves;
  const std::vector<TracedQuartic>& quartics = bounds.quartics;
  Search search(sheets, y0, y1);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    search.add_turns(curves[i]);
    for (std::size_t j = 0; j < i; ++j) search.add_meeting(curves[i], curves[j]);
  }
  for (std::size_t i = 0; i < quartics.size(); ++i) {
    const QuarticForm& quartic = quartics[i].curve;
    search.add(table.turns(quartic));
    for (const TracedCurve& other : curves) {
      if (const auto found = meeting_with_section(quartics[i], other)) {
        for (const ConicMeeting& meeting : *found) {
          if (is_limb(
                  other)) {  // also off the face: there a root passes from sheet to sheet, and the next is renumbered
            search.add_all(meeting.lines);
          } else {
            search.add_strips(interval_curve(meeting.conic), other.enclosed, meeting.lines);
          }
        }
      } else {
        search.add(table.meetings(quartic, as_quartic(other.curve)));
      }
    }
    for (std::size_t j = 0; j < i; ++j) search.add(table.meetings(quartic, quartics[j].curve));
  }
  return search.take();
}

}  // namespace halfspace
