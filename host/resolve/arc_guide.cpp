#include "host/resolve/arc_guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "host/resolve/critical_marks.hpp"
#include "host/resolve/quartic.hpp"
#include "host/resolve/segment_sign.hpp"
#include "host/resolve/separator.hpp"
#include "host/resolve/sheet_form.hpp"

namespace halfspace {
namespace {

// A window and what it asks of the guide as a whole; nothing where either will do.
struct ProvedWindow {
  Window window;
  std::optional<bool> rising, missing_right;
};

// Windows for one root of a form.
class Windows {
 public:
  Windows(const FormOnSheet& form, const EnclosedForm& near, int rank, KnownLines& lines)
      : form_(form), near_(near), rank_(rank), lines_(lines), n_(form.has_limb() ? form.value().n : form.part->form()) {
    if (!form.has_limb()) return;
    d_.emplace(as_quartic(form.sheets->d));
    p_.emplace(as_quartic(form.value().p));
    r_.emplace(as_quartic(form.value().r));
  }

  // On the lines y0 .. y1 of a row of the form.
  void add_row(bool singular, std::int64_t y0, std::int64_t y1) {
    if (singular) return add_single(y0);
    const bool rising = is_rising(y0);
    std::int64_t length = y1 - y0 + 1;
    for (std::int64_t y = y0; y <= y1;) {
      std::int64_t last = std::min(y1, y + length - 1);
      while (last > y && !add_window(y, last, rising)) last = y + (last - y) / 2;
      if (last == y) add_single(y);
      length = 2 * (last - y + 1);
      y = last + 1;
    }
  }

  [[nodiscard]] std::vector<ProvedWindow> take() { return std::move(windows_); }

 private:
  struct Line {
    const std::vector<Obstacle>& obstacles;
    const ValueOnLine& value;
    std::size_t root;
  };
  // A form that separators are tested by.
  struct Tested {
    QuarticForm exact;
    SegmentSign near;
    explicit Tested(QuarticForm p) : exact(std::move(p)), near(exact) {}
  };

  Line line(std::int64_t y) {
    auto at = lines_.find(y);
    if (at == lines_.end()) {
      ValueOnLine value(*form_.sheets, form_.value(), y, &near_);
      std::vector<Obstacle> obstacles = obstacles_on_line(form_, y, value);
      at = lines_.emplace(y, KnownLine{std::move(value), std::move(obstacles)}).first;
    }
    const KnownLine& known = at->second;
    std::size_t root = 0;
    while (known.obstacles[root].rank != rank_) ++root;
    return {known.obstacles, known.value, root};
  }

  // The dots beside the root: no dot between them but one that is the root.
  void add_single(std::int64_t y) {
    const Line at = line(y);
    const LineRoot& x = at.obstacles[at.root].x;
    const auto row = static_cast<std::int32_t>(y);
    windows_.push_back({{row, row, dot_separator(ceiling_of(x) - 1), dot_separator(floor_of(x) + 1)}, {}, {}});
  }

  // Is the form negative just left of the root?
  bool is_rising(std::int64_t y) {
    const Line at = line(y);
    const LineRoot& x = at.obstacles[at.root].x;
    const LineRoot beside =
        at.root == 0 ? rational_root(floor_of(x) - 1, 1) : rational_between(at.obstacles[at.root - 1].x, x);
    if (!form_.has_limb()) return sign_at(restricted(form_.part->form(), y), beside) < 0;
    return at.value.sign(form_.sheet, beside) < 0;
  }

  // The first, the middle and the last line of a window.
  struct Sampled {
    std::array<std::int64_t, 3> y;
    std::array<Line, 3> at;
  };

  // Beyond the limb that is counted as missing nothing is asked; at the other side's limb a separator comes first.
  bool add_window(std::int64_t y0, std::int64_t y1, bool rising) {
    const std::int64_t middle = y0 + (y1 - y0) / 2;
    const Sampled lines{{y0, middle, y1}, {line(y0), line(middle), line(y1)}};
    const Line& first = lines.at.front();
    const bool left = first.root > 0 && first.obstacles[first.root - 1].limb;
    const bool right = first.root + 1 < first.obstacles.size() && first.obstacles[first.root + 1].limb;
    if (!left && !right) return add_window(lines, rising, std::nullopt);
    if (left != right) return add_window(lines, rising, right);
    const bool as_before = !windows_.empty() && windows_.back().missing_right.value_or(false);
    return add_window(lines, rising, as_before) || add_window(lines, rising, !as_before);
  }

  bool add_window(const Sampled& lines, bool rising, std::optional<bool> missing_right) {
    const auto row = [&lines](std::size_t i) { return static_cast<std::int32_t>(lines.y[i]); };
    ProvedWindow next{{row(0), row(2), {}, {}}, rising, missing_right};
    if (!separate(lines, -1, missing_right == false, next.window.left)) return false;
    if (!separate(lines, 1, missing_right == true, next.window.right)) return false;
    windows_.push_back(next);
    return true;
  }

  // The separator on one side (-1 left, 1 right), if one is needed; false if none was found.
  bool separate(const Sampled& lines, int side, bool missing, std::optional<Separator>& found) {
    const Line& first = lines.at.front();
    const auto exists = [&first, side](std::size_t steps) {
      return side < 0 ? first.root >= steps : first.root + steps < first.obstacles.size();
    };
    const std::size_t near = missing ? 1 : 0;  // obstacles between the root and the separator: the limb, or none
    if (!exists(near + 1)) return true;
    Channel channel;
    for (std::size_t i = 0; i < lines.at.size(); ++i) {
      const Line& here = lines.at[i];
      const LineRoot& inner = here.obstacles[moved(here.root, side, near)].x;
      const LineRoot& outer = here.obstacles[moved(here.root, side, near + 1)].x;
      channel.add(lines.y[i], side < 0 ? outer : inner, side < 0 ? inner : outer);
    }
    found = channel.separator();
    return found && channel.holds(*found) && is_clear(*found, lines.y.front(), lines.y.back());
  }

  static std::size_t moved(std::size_t root, int side, std::size_t steps) {
    return side < 0 ? root - steps : root + steps;
  }

  // The form's sign all along the separator; 0 where it may vanish.
  static int sign_along(const Separator& separator, std::int64_t y0, std::int64_t length, const Tested& form) {
    constexpr double unit = separator_unit;
    const auto certain =
        form.near.along(static_cast<double>(separator.at) / unit, static_cast<double>(separator.step) / unit,
                        static_cast<double>(y0), static_cast<double>(length));
    if (certain) return *certain;
    const Polynomial p = along(from_line(form.exact, static_cast<long>(y0)), static_cast<long>(separator.at),
                               static_cast<long>(separator.step), separator_unit);
    return surely_without_zero(p, 0, static_cast<long>(length)) ? sgn(p[0]) : 0;
  }

  // Neither d nor the form vanishes along the separator. Where d < 0 from the start there is no form.
  [[nodiscard]] bool is_clear(const Separator& separator, std::int64_t y0, std::int64_t y1) const {
    const auto sign = [&](const Tested& form) { return sign_along(separator, y0, y1 - y0, form); };
    if (!form_.has_limb()) return sign(n_) != 0;
    const int d = sign(*d_);
    if (d <= 0) return d < 0;
    if (sign(n_) != 0) return true;
    const int t = form_.sheet == Sheet::front ? -1 : 1;
    const int p = sign(*p_);
    return p != 0 && p == t * sign(*r_);
  }

  const FormOnSheet& form_;
  const EnclosedForm& near_;
  int rank_;
  KnownLines& lines_;
  Tested n_;  // the form, or on two sheets P^2 - R^2 d
  std::optional<Tested> d_, p_, r_;
  std::vector<ProvedWindow> windows_;
};

// Does the guide so far allow for the window?
bool agrees(const std::optional<bool>& known, const std::optional<bool>& next) {
  return !known || !next || *known == *next;
}

std::vector<GuidedRun> joined(const std::vector<ProvedWindow>& windows) {
  std::vector<GuidedRun> runs;
  std::optional<bool> rising;
  std::optional<bool> missing_right;
  for (const ProvedWindow& next : windows) {
    if (runs.empty() || !agrees(rising, next.rising) || !agrees(missing_right, next.missing_right)) {
      runs.push_back({next.window.y0, next.window.y1, {}});
      rising = missing_right = std::nullopt;
    }
    if (next.rising) rising = next.rising;
    if (next.missing_right) missing_right = next.missing_right;
    GuidedRun& run = runs.back();
    run.y1 = next.window.y1;
    run.guide.rising = rising.value_or(true);
    run.guide.missing_right = missing_right.value_or(false);
    run.guide.windows.push_back(next.window);
  }
  return runs;
}

std::variant<Curve, RadicalForm, QuarticForm> form_of(const FormOnSheet& form) {
  if (!form.has_limb()) return form.part->form();
  const Constraint& k = form.value();
  return RadicalForm{k.p, (form.sheet == Sheet::front ? -1 : 1) * k.r, form.sheets->d};
}

std::vector<ScanRow> rows_of(const FormOnSheet& form, const DotExtent& extent) {
  BoundingCurves bounds;
  bounds.quartics.push_back({form.part, {form.constraint}, {form.others}, std::nullopt});
  if (form.has_limb()) {
    bounds.quartics.back().radical = Radical{form.value().p, form.value().r};
    trace_own(form.sheets->d, Section{Curve{}, 1}, bounds.curves);
    for (const Curve& other : *form.others) trace(other, std::nullopt, false, form.constraint, bounds.curves);
  }
  std::vector<Mark> marks;
  find_critical_marks(bounds, {}, extent.y0, extent.y1, marks);
  std::vector<ScanRow> rows;
  find_scan_rows(marks, extent.y0, extent.y1, rows);
  return rows;
}

}  // namespace

ArcGuide::ArcGuide(const FormOnSheet& form, const DotExtent& extent)
    : form_on_sheet_(form),
      near_(*form_on_sheet_.sheets, form_on_sheet_.value()),
      form_(form_of(form_on_sheet_)),
      rows_(rows_of(form_on_sheet_, extent)) {}

std::vector<GuidedRun> ArcGuide::runs(std::uint32_t rank, std::int64_t y0, std::int64_t y1) {
  Windows windows(form_on_sheet_, near_, static_cast<int>(rank), lines_);
  for (const ScanRow& row : rows_) {
    const std::int64_t first = std::max(y0, row.y0);
    const std::int64_t last = std::min(y1, row.y1);
    if (first <= last) windows.add_row(row.singular, first, last);
  }
  return joined(windows.take());
}

}  // namespace halfspace
