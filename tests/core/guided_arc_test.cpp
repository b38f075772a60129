// Arcs of forms with several roots on a line: random forms are signed dot by dot with GMP, windows are laid around a change of
// sign, and the page that the writer's job gives must begin, or end, at that change on every line.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "firmware/core/engine.hpp"
#include "firmware/core/memory_source.hpp"
#include "host/job/job_writer.hpp"
#include "host/job/limits.hpp"
#include "tests/core/numbers.hpp"
#include "tests/core/sample_job.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

constexpr std::int32_t width = 80, height = 90;
constexpr std::int32_t x_min = 3, x_max = 74, x_end = x_max + 1;
constexpr std::int64_t dot = std::int64_t{1} << separator_fraction;

using Form = std::variant<RadicalForm, QuarticForm>;

mpz_class value_at(const Curve& c, long x, long y) {
  const auto& q = c.q;
  return (q[0] * x + q[1] * y + q[3]) * x + (q[2] * y + q[4]) * y + q[5];
}

// The form's signs on line y, local, for dots x0, x0 + 1, ...; `missing` where it has none.
void fill_signs(const RadicalForm& form, long x0, long y, int missing, std::span<int> signs) {
  for (int& sign : signs) {
    const mpz_class p = value_at(form.p, x0, y);
    const mpz_class r = value_at(form.r, x0, y);
    const mpz_class d = value_at(form.d, x0, y);
    // v -> v |v| keeps the order of p and -r sqrt(d).
    sign = d < 0 ? missing : sgn(mpz_class(sgn(p) * p * p + sgn(r) * r * r * d));
    ++x0;
  }
}

void fill_signs(const QuarticForm& form, long x0, long y, int, std::span<int> signs) {
  std::array<mpz_class, 5> line;  // its coefficients of 1, x .. x^4
  for (int degree = 4, k = 0; degree >= 0; --degree) {
    mpz_class y_power = 1;
    for (int j = 0; j <= degree; ++j, ++k) {
      line[static_cast<std::size_t>(degree - j)] += form.q[static_cast<std::size_t>(k)] * y_power;
      y_power *= y;
    }
  }
  for (int& sign : signs) {
    mpz_class value;
    for (std::size_t i = 5; i-- > 0;) value = value * x0 + line[i];
    sign = sgn(value);
    ++x0;
  }
}

struct Setting {
  Form form;
  std::int32_t origin_x = 0, origin_y = 0;
  bool rising = false, missing_right = false;
};

// On which side of a root each dot of a line lies, by the form's sign: -1 left, 0 on it, 1 right.
std::array<int, x_end> sides_of(const Setting& s, std::int32_t y) {
  std::array<int, x_end> sides{};
  const int right = s.rising ? 1 : -1;
  const int missing = s.missing_right ? right : -right;
  const auto fill = [&](const auto& form) {
    fill_signs(form, x_min - s.origin_x, y - s.origin_y, missing, std::span(sides).subspan(x_min));
  };
  std::visit(fill, s.form);
  for (int& side : sides) side *= right;
  return sides;
}

struct Range {
  std::int64_t low, high;
  [[nodiscard]] bool holds(std::int64_t v) const { return low <= v && v <= high; }
};
constexpr std::int64_t far = 1000 * dot;

// A change of sign from left to right, and where separators may stand that leave no other change between them.
struct Change {
  std::int32_t at_or_right, right;
  Range left_separator, right_separator;
};

std::vector<Change> changes_of(const std::array<int, x_end>& sides) {
  const auto side = [&sides](std::int32_t x) { return sides[static_cast<std::size_t>(x)]; };
  std::vector<Change> changes;
  for (std::int32_t c = x_min; c <= x_end; ++c) {
    if ((c > x_min && side(c - 1) >= 0) || (c < x_end && side(c) < 0)) continue;
    const std::int32_t right = c < x_end && side(c) == 0 ? c + 1 : c;
    if (right < x_end && side(right) <= 0) continue;
    std::int32_t a = c;
    while (a > x_min && side(a - 1) < 0) --a;
    std::int32_t b = right;
    while (b < x_end && side(b) > 0) ++b;
    // The first dot asked is in a .. c, the first not asked any more in right .. b.
    changes.push_back({c,
                       right,
                       {a == x_min ? -far : (a - 1) * dot, c == x_end ? far : c * dot - 1},
                       {right == x_min ? -far : (right - 1) * dot + 1, b == x_end ? far : b * dot}});
  }
  return changes;
}

struct Lines {
  std::int32_t y0 = 0;
  std::vector<Change> changes;
};

// From a line with a change on, down the page: as a rule the nearest change, at times any.
Lines follow(const Setting& s, std::int32_t y, Dice& dice) {
  Lines lines{y, {}};
  for (; y < height; ++y) {
    const std::vector<Change> changes = changes_of(sides_of(s, y));
    if (changes.empty()) break;
    const std::int32_t before = lines.changes.empty() ? 0 : lines.changes.back().at_or_right;
    const auto nearer = [before](const Change& a, const Change& b) {
      return std::abs(a.at_or_right - before) < std::abs(b.at_or_right - before);
    };
    const bool any = lines.changes.empty() || dice() % 8 == 0;
    lines.changes.push_back(any ? changes[dice() % changes.size()]
                                : *std::min_element(changes.begin(), changes.end(), nearer));
  }
  return lines;
}

// A separator drawn by lot that stands well on the first line, and the lines from there on that it serves.
std::pair<std::optional<Separator>, std::size_t> draw_separator(const std::vector<Range>& ranges, std::size_t first,
                                                                bool is_left, std::int32_t origin_x, Dice& dice) {
  const auto none_fits = [is_left](const Range& r) { return is_left ? r.low == -far : r.high == far; };
  std::size_t end = first;
  if (none_fits(ranges[first]) && dice() % 3 == 0) {
    while (end < ranges.size() && none_fits(ranges[end])) ++end;
    return {std::nullopt, end};
  }
  Separator s{between(dice, ranges[first].low, ranges[first].high), dice() % 2 == 0 ? 0 : between(dice, -dot, dot)};
  while (end < ranges.size() && ranges[end].holds(s.at + s.step * static_cast<std::int64_t>(end - first))) ++end;
  s.at -= origin_x * dot;
  return {s, end};
}

std::vector<Window> windows_of(const Lines& lines, std::int32_t origin_x, Dice& dice) {
  std::vector<Range> left, right;
  for (const Change& c : lines.changes) {
    left.push_back(c.left_separator);
    right.push_back(c.right_separator);
  }
  std::vector<Window> windows;
  for (std::size_t first = 0; first < lines.changes.size();) {
    const auto [l, left_end] = draw_separator(left, first, true, origin_x, dice);
    const auto [r, right_end] = draw_separator(right, first, false, origin_x, dice);
    const std::size_t end = std::min(left_end, right_end);
    windows.push_back(
        {lines.y0 + static_cast<std::int32_t>(first), lines.y0 + static_cast<std::int32_t>(end) - 1, l, r});
    first = end;
  }
  return windows;
}

// A black plane on one side of an arc, on white.
struct Plane {
  IntegerScene scene;
  ResolvedScene resolved;

  Plane(const Setting& s, const Lines& lines, const std::vector<Window>& windows) {
    scene.width = width;
    scene.height = height;
    scene.levels = 65;
    scene.scissor = {x_min, 0, x_max, height - 1};
    scene.lighting.normal_matrix = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    scene.lighting.light = {0, 0, -1};
    scene.bodies.resize(1);
    scene.bodies[0].origin = {s.origin_x, s.origin_y, 0};
    scene.bodies[0].half_spaces.resize(1);
    scene.bodies[0].half_spaces[0].c[2] = 1;
    const std::int32_t y1 = lines.y0 + static_cast<std::int32_t>(lines.changes.size()) - 1;
    Arc arc{0, Curve{}, Branch::single, {s.rising, s.missing_right, windows}, lines.y0, y1};
    std::visit([&arc](const auto& form) { arc.form = form; }, s.form);
    resolved.arcs = {arc};
    resolved.faces = {{0, 0, Sheet::only}};
    resolved.cells = {{0, no_arc, no_arc, lines.y0, y1}};
  }
  [[nodiscard]] std::optional<ArcKind> kind() const { return arc_kind(scene, resolved.arcs[0]); }

  std::vector<std::uint8_t> draw(bool right_of_arc) {
    resolved.cells[0].left = right_of_arc ? 0 : no_arc;
    resolved.cells[0].right = right_of_arc ? no_arc : 0;
    JobOptions options;
    options.page = {width, height, DotFormat::gray, 65, 64};
    const JobResult job = write_job(scene, resolved, options);
    if (!job.diagnostics.empty()) return {};
    MemorySource source(job.bytes);
    return draw_job(source, std::size_t{1} << 16).bytes;
  }
};

std::vector<std::uint8_t> expected_page(const Lines& lines, bool right_of_arc) {
  std::vector<std::uint8_t> page(width * height, 64);
  for (std::size_t i = 0; i < lines.changes.size(); ++i) {
    const Change& c = lines.changes[i];
    const auto row = page.begin() + (lines.y0 + static_cast<std::ptrdiff_t>(i)) * width;
    if (right_of_arc) {
      std::fill(row + c.at_or_right, row + x_end, 0);
    } else {
      std::fill(row + x_min, row + c.right, 0);
    }
  }
  return page;
}

struct Seen {
  std::map<ArcKind, int> lines;
  int beside_others = 0, ties = 0;  // with another change on the same line; on a dot
};

// Every stretch of lines with a change, drawn on either side.
void expect_drawn(const Setting& s, Dice& dice, Seen& seen) {
  for (std::int32_t y = static_cast<std::int32_t>(between(dice, 0, 20)); y < height;) {
    const Lines lines = follow(s, y, dice);
    const auto count = static_cast<std::int32_t>(lines.changes.size());
    y += count + 1;
    if (count == 0) continue;
    const std::vector<Window> windows = windows_of(lines, s.origin_x, dice);
    Plane plane(s, lines, windows);
    if (!plane.kind()) return;
    for (const bool right_of_arc : {true, false}) {
      const std::vector<std::uint8_t> drawn = plane.draw(right_of_arc);
      const std::vector<std::uint8_t> expected = expected_page(lines, right_of_arc);
      ASSERT_EQ(drawn.size(), expected.size());
      const auto at = std::mismatch(drawn.begin(), drawn.end(), expected.begin()).first - drawn.begin();
      ASSERT_EQ(at, std::ssize(drawn)) << "dot " << at % width << " of line " << at / width;
    }
    seen.lines[*plane.kind()] += count;
    for (const Change& c : lines.changes) {
      seen.beside_others += c.left_separator.low != -far || c.right_separator.high != far ? 1 : 0;
      seen.ties += c.right != c.at_or_right ? 1 : 0;
    }
  }
}

// Of at most `bits` bits: as a rule nearly as long, at times of any length.
mpz_class coefficient(Dice& dice, int bits) {
  if (bits <= 0 || dice() % 4 == 0) return random_bits(dice, bits);
  mpz_class c = 0;
  while (c == 0) c = random_bits(dice, 31);
  c %= 1024;
  return bits >= 10 ? mpz_class(c << static_cast<unsigned>(bits - 10)) + random_bits(dice, bits - 10)
                    : mpz_class(c >> static_cast<unsigned>(10 - bits));
}

// Coefficients such that all terms weigh about the same in the middle of the page, 2^6 dots from the origin.
Curve random_conic(Dice& dice, int bits) {
  Curve c;
  for (std::size_t i = 0; i < 6; ++i) c.q[i] = coefficient(dice, bits + (i < 3 ? 0 : i < 5 ? 6 : 12));
  return c;
}

Curve random_line(Dice& dice, int bits) {
  return {{0, 0, 0, coefficient(dice, bits), coefficient(dice, bits), coefficient(dice, bits + 6)}};
}

Curve product(const Curve& f, const Curve& g) {  // of two lines
  const auto &a = f.q, &b = g.q;
  return {{a[3] * b[3], a[3] * b[4] + a[4] * b[3], a[4] * b[4], a[3] * b[5] + a[5] * b[3], a[4] * b[5] + a[5] * b[4],
           a[5] * b[5]}};
}

RadicalForm random_radical(Dice& dice, int bits) {
  const int root_bits = static_cast<int>(between(dice, 0, bits / 2));
  const bool two_lines = dice() % 2 == 0;
  const Curve p =
      two_lines ? product(random_line(dice, bits / 2), random_line(dice, bits / 2)) : random_conic(dice, bits);
  const int r_bits = bits - root_bits - static_cast<int>(between(dice, 0, std::min(6, bits - root_bits)));
  return {p, random_line(dice, r_bits), random_conic(dice, 2 * root_bits)};
}

// p + r |l| = m n where l >= 0: ties wherever m or n meets a dot.
RadicalForm radical_with_ties(Dice& dice) {
  const Curve l = random_line(dice, 3);
  RadicalForm form;
  form.r = random_line(dice, 3);
  form.d = product(l, l);
  form.p = product(random_line(dice, 2), random_line(dice, 2));
  const Curve taken = product(form.r, l);
  for (std::size_t i = 0; i < 6; ++i) form.p.q[i] -= taken.q[i];
  return form;
}

QuarticForm random_quartic(Dice& dice, int bits) {
  QuarticForm form;
  for (std::size_t i = 0; i < 15; ++i)
    form.q[i] = coefficient(dice, bits + (i < 5 ? 0 : i < 9 ? 6 : i < 12 ? 12 : i < 14 ? 18 : 24));
  return form;
}

// A product of two lines and of two more, or of a conic.
QuarticForm product_quartic(Dice& dice, int bits) {
  const Curve f = product(random_line(dice, bits), random_line(dice, bits));
  const Curve g =
      dice() % 2 == 0 ? random_conic(dice, 2 * bits) : product(random_line(dice, bits), random_line(dice, bits));
  QuarticForm form;
  // Where x^a y^b stands in a conic, and in a quartic.
  static constexpr int power[6][2] = {{2, 0}, {1, 1}, {0, 2}, {1, 0}, {0, 1}, {0, 0}};
  static constexpr int first[5] = {14, 12, 9, 5, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const int y = power[i][1] + power[j][1];
      form.q[static_cast<std::size_t>(first[power[i][0] + power[j][0] + y] + y)] += f.q[i] * g.q[j];
    }
  }
  return form;
}

// With four roots on many lines: a product, and a little beside it.
QuarticForm split_quartic(Dice& dice, int bits) {
  QuarticForm form = product_quartic(dice, bits / 4);
  const QuarticForm little = random_quartic(dice, bits * 3 / 4);
  for (std::size_t i = 0; i < 15; ++i) form.q[i] += little.q[i];
  return form;
}

Setting place(const Form& form, Dice& dice) {
  return {form, static_cast<std::int32_t>(between(dice, -20, 100)), static_cast<std::int32_t>(between(dice, -20, 110)),
          dice() % 2 == 0, dice() % 2 == 0};
}

constexpr int trials = testing::trials(304);

TEST(GuidedArc, RadicalsOfEveryWidth) {
  Dice dice(70);
  Seen seen;
  for (int trial = 0; trial < trials; ++trial) {
    const int bits = trial % 5 == 0 ? 5 : static_cast<int>(between(dice, 20, 350));
    expect_drawn(place(random_radical(dice, bits), dice), dice, seen);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  for (const ArcKind kind : {ArcKind::radical128, ArcKind::radical256, ArcKind::radical384}) {
    EXPECT_GT(seen.lines[kind], testing::trials(2000)) << static_cast<int>(kind);
  }
  EXPECT_GT(seen.beside_others, testing::trials(2000));
}

TEST(GuidedArc, QuarticsOfEveryWidth) {
  Dice dice(71);
  Seen seen;
  for (int trial = 0; trial < trials; ++trial) {
    const int bits = trial % 5 == 0 ? 3 : static_cast<int>(between(dice, 20, 350));
    const QuarticForm form = trial % 2 == 0 ? random_quartic(dice, bits) : split_quartic(dice, bits);
    expect_drawn(place(form, dice), dice, seen);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  for (const ArcKind kind : {ArcKind::quartic128, ArcKind::quartic256, ArcKind::quartic384}) {
    EXPECT_GT(seen.lines[kind], testing::trials(2000)) << static_cast<int>(kind);
  }
  EXPECT_GT(seen.beside_others, testing::trials(2000));
}

TEST(GuidedArc, RootsOnDots) {
  Dice dice(72);
  Seen seen;
  for (int trial = 0; trial < trials; ++trial) {
    const Form form = trial % 2 == 0 ? Form(radical_with_ties(dice)) : Form(product_quartic(dice, 2));
    expect_drawn(place(form, dice), dice, seen);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(seen.ties, testing::trials(1000));
}

// x + y sqrt(1) with a coefficient of the given width: values on the page need 7 bits more.
Arc wide_arc(int bits) {
  RadicalForm form;
  form.p.q[3] = (mpz_class(1) << static_cast<unsigned>(bits)) - 1;
  form.r.q[4] = 1;
  form.d.q[5] = 1;
  return {0, form, Branch::single, {true, false, {{0, 9, {}, {}}}}, 0, 9};
}

TEST(GuidedArc, KindsAreAsNarrowAsTheFormsValues) {
  IntegerScene scene;
  scene.scissor = {0, 0, 126, 9};  // local dots to 128, the one beyond included
  scene.bodies.resize(1);
  EXPECT_EQ(arc_kind(scene, wide_arc(120)), ArcKind::radical128);
  EXPECT_EQ(arc_kind(scene, wide_arc(121)), ArcKind::radical256);
  EXPECT_EQ(arc_kind(scene, wide_arc(248)), ArcKind::radical256);
  EXPECT_EQ(arc_kind(scene, wide_arc(249)), ArcKind::radical384);
  EXPECT_EQ(arc_kind(scene, wide_arc(376)), ArcKind::radical384);
  EXPECT_FALSE(arc_kind(scene, wide_arc(377)));
  QuarticForm quartic;
  quartic.q[1] = 1;  // x^3 y
  scene.scissor = {0, 0, 1022, 1022};
  Arc arc{0, quartic, Branch::single, {}, 0, 9};
  EXPECT_EQ(arc_kind(scene, arc), ArcKind::quartic128);
  std::get<QuarticForm>(arc.form).q[1] = mpz_class(1) << 86;  // times 2^40
  EXPECT_EQ(arc_kind(scene, arc), ArcKind::quartic128);
  std::get<QuarticForm>(arc.form).q[1] *= 2;
  EXPECT_EQ(arc_kind(scene, arc), ArcKind::quartic256);
}

TEST(GuidedArc, WhatDoesNotFitIsALimitOfTheScene) {
  const auto message = [](const Arc& arc) {
    const Setting s{std::get<RadicalForm>(arc.form)};
    Plane plane(s, {0, std::vector<Change>(10)}, arc.guide.windows);
    JobOptions options;
    options.page = {width, height, DotFormat::gray, 65, 64};
    const JobResult job = write_job(plane.scene, plane.resolved, options);
    return job.diagnostics.empty() ? std::string() : job.diagnostics.front().message;
  };
  Arc arc = wide_arc(377);
  EXPECT_NE(message(arc).find("more than 383 bits"), std::string::npos) << message(arc);
  arc = wide_arc(10);
  EXPECT_EQ(message(arc), "");
  arc.guide.windows[0].left = Separator{-largest_separator, largest_separator};
  EXPECT_EQ(message(arc), "");
  arc.guide.windows[0].right = Separator{0, largest_separator + 1};
  EXPECT_NE(message(arc).find("2^31 dots off"), std::string::npos) << message(arc);
}

}  // namespace
}  // namespace halfspace
