// Contours give the dots of the shader that takes them one by one (which shade_test.cpp holds against GMP).
#include "firmware/core/contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "firmware/core/real.hpp"
#include "tests/core/faces.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

class Contours {
 public:
  Contours(const Lighting& lighting, std::int32_t levels, std::int32_t width, std::int32_t height,
           DotFormat format = DotFormat::gray, Screen screen = Screen::clustered)
      : lighting_(lighting),
        page_{width, height, format, levels, 0},
        words_(row_words(page_)),
        squares_(static_cast<std::size_t>(levels)),
        scratch_(static_cast<std::size_t>(levels)),
        block_(contour_block_words(levels)),
        table_(make_levels(lighting, levels, squares_)) {
    contours.block = block_;
    if (format == DotFormat::gray) return;
    patterns_.resize(static_cast<std::size_t>(levels) * cell_side);
    edges_.resize(edge_words(levels) * cell_side);
    make_patterns(screen, levels, patterns_);
    find_edges(levels, patterns_, edges_);
  }

  // The run's levels, or a bilevel page's whole row; empty: declined.
  std::vector<std::uint8_t> shade(const TestFace& face, const ExactModule& exact, bool by_contours, std::int32_t y,
                                  DotRun run) {
    RowPainter painter(page_, words_, patterns_, edges_);
    painter.begin(y);
    const ShadeJob job{face.active, lighting_, table_, exact, painter, counters, 1, &contours, scratch_};
    if (by_contours) {
      if (!all_contours.shade(job, Shader::contour, y, run.x0, run.x1)) return {};
    } else {
      const auto shade_span = face.active.kind == FaceKind::root ? &shade_root_span : &shade_rational_span;
      shade_span(job, Shader::isqrt, y, run.x0, run.x1);
    }
    std::vector<std::uint8_t> levels(page_.row_bytes());
    painter.copy_to(levels);
    if (page_.format == DotFormat::bilevel) return levels;
    return {levels.begin() + run.x0, levels.begin() + run.x1 + 1};
  }

  // The lines of which straight_contour declines a run.
  int lines_not_straight(const TestFace& face, const ExactModule& exact) {
    int lines = 0;
    for (std::int32_t y = 0; y < page_.height; ++y) {
      RowPainter painter(page_, words_, {});
      painter.begin(y);
      const ShadeJob job{face.active, lighting_, table_, exact, painter, counters, 1, &contours, scratch_};
      const std::vector<DotRun> runs = runs_of(face, y, page_.width);
      const bool all =
          has_straight_contours(face.active) && std::all_of(runs.begin(), runs.end(), [&](const DotRun& run) {
            return straight_contour(job, y, run.x0, run.x1) || surveyed_contour(job, y, run.x0, run.x1);
          });
      lines += all ? 0 : 1;
    }
    return lines;
  }

  Counters counters;
  FaceContours contours;

 private:
  const Lighting& lighting_;
  Page page_;
  std::vector<std::uint32_t> words_, squares_;
  std::vector<std::int32_t> scratch_;
  std::vector<std::uint32_t> block_;
  std::vector<PatternRow> patterns_;
  std::vector<std::uint32_t> edges_;
  LevelTable table_;
};

struct Tally {
  std::uint64_t dots = 0, declined = 0;
};

// Every other trial on a bilevel page, where only levels that look otherwise are sought, in every screen.
DotFormat format_of(int trial) { return trial % 2 == 0 ? DotFormat::gray : DotFormat::bilevel; }
Screen screen_of(int trial) { return static_cast<Screen>(trial / 2 % 3); }

void expect_same_dots(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t side,
                      Dice& dice, int lines, int trial, Tally& tally) {
  const ExactModule* exact = exact_for({&face}, lighting, levels, side);
  if (exact == nullptr) return;
  Contours canvas(lighting, levels, side, side, format_of(trial), screen_of(trial));
  for (int i = 0; i < lines; ++i) {
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    for (const DotRun& run : runs_of(face, y, side)) {
      const auto from = static_cast<std::int32_t>(between(dice, run.x0, run.x1));
      const auto to = static_cast<std::int32_t>(between(dice, from, run.x1));
      for (const DotRun& part : {run, DotRun{from, to}}) {
        const auto levels_by_dots = canvas.shade(face, *exact, false, y, part);
        const auto levels_by_contours = canvas.shade(face, *exact, true, y, part);
        tally.dots += levels_by_dots.size();
        if (levels_by_contours.empty()) {
          tally.declined += levels_by_dots.size();
          continue;
        }
        ASSERT_EQ(levels_by_contours, levels_by_dots) << "line " << y << " dots " << part.x0 << ".." << part.x1;
      }
    }
  }
}

std::int32_t some_levels(Dice& dice) {
  constexpr std::int32_t levels[] = {2, 3, 17, 65, 65, 256, 256};
  return levels[dice() % 7];
}

Lighting some_lighting(Dice& dice) {
  Lighting l;
  for (int i = 0; i < 3; ++i) l.matrix[i][i] = 1 << 14;
  if (dice() % 3 == 0) l.matrix[1][1] = static_cast<std::int32_t>(between(dice, 1 << 13, 1 << 15));  // dots not square
  for (auto& c : l.light) c = static_cast<std::int32_t>(between(dice, -(1 << 15), 1 << 15));
  switch (dice() % 8) {
    case 0:
      l.light = {0, 0, static_cast<std::int32_t>(between(dice, -10, 10))};
      break;
    case 1:
      l.light[dice() % 3] = 0;
      break;
    case 2:
      l.light[2] = static_cast<std::int32_t>(between(dice, -3, 3));
      break;
    case 3: {  // near the normal of lines of the page, or on it
      const auto most = static_cast<std::int32_t>(between(dice, 0, 12));
      l.light[0] >>= most;
      l.light[2] >>= between(dice, most, 16);
      break;
    }
    default:
      break;
  }
  l.unit = static_cast<std::int32_t>(between(dice, 1, 1 << 16));
  l.ambient = dice() % 2 == 0 ? 0 : static_cast<std::int32_t>(between(dice, 0, l.unit));
  l.parallel = dice() % 2 == 0 ? l.unit : static_cast<std::int32_t>(between(dice, 0, l.unit));
  return l;
}

mpz_class whole(std::int64_t v) { return static_cast<long>(v); }

// A sphere about a point of a fine grid. Where the lighting's matrix stretches y, so does the shape, and |N| is constant again.
TestFace some_sphere(Dice& dice, std::int64_t radius, std::int32_t side, const Lighting& lighting) {
  const std::int64_t unit = dice() % 2 == 0 ? 16 : between(dice, 1, 64);
  const mpz_class x = whole(between(dice, -unit, unit));
  const mpz_class y = whole(between(dice, -unit, unit));
  const mpz_class r = whole(radius * unit + between(dice, 0, unit));
  // sx (unit x - x0)^2 + sy (unit y - y0)^2 + sx (unit z)^2 = sx r^2, whose gradient's y the matrix multiplies by m / 2^14
  const bool stretched = lighting.matrix[1][1] != 1 << 14;
  const mpz_class m = whole(lighting.matrix[1][1]);
  const mpz_class sx = stretched ? mpz_class(m * m) : mpz_class(1);
  const mpz_class sy = stretched ? mpz_class(1 << 28) : mpz_class(1);
  std::array<mpz_class, 10> c;
  c[0] = c[2] = sx * whole(unit * unit);
  c[1] = sy * whole(unit * unit);
  c[6] = -sx * whole(unit) * x;
  c[7] = -sy * whole(unit) * y;
  c[9] = sx * x * x + sy * y * y - sx * r * r;
  const auto at = [&] { return side / 2 + between(dice, -radius / 2, radius / 2); };
  return make_face(FaceKind::root, c, {at(), at(), 0}, dice() % 3 == 0 ? 1 : -1, dice() % 3 == 0 ? -1 : 1, 0, lighting);
}

std::size_t place_of(std::size_t i, std::size_t j) {
  static constexpr std::uint8_t place[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};
  return place[i][j];
}

// As if written in decimals: exact to within 2^-30 to 2^-48.
void blur(Dice& dice, std::array<mpz_class, 10>& c) {
  const mpz_class unit = mpz_class(1) << static_cast<unsigned>(between(dice, 26, 44));
  for (mpz_class& k : c) k = k * unit + whole(between(dice, -8, 8));
}

// Without z^2, seen along a ruling or an asymptote: 2 p q + r^2, where p and r are no forms of z, or 2 p q + p^2 and a constant.
TestFace some_ruled_quotient(Dice& dice, std::int64_t radius, std::int32_t side, const Lighting& lighting) {
  const bool cone = dice() % 2 == 0;
  std::array<std::array<mpz_class, 4>, 3> form;
  const std::array<std::int64_t, 3> apex{between(dice, -radius, radius), between(dice, -radius, radius), 0};
  for (std::size_t f = 0; f < 3; ++f) {
    for (std::size_t i = 0; i < (f == 1 ? 3 : 2); ++i) form[f][i] = whole(between(dice, -30, 30));
    for (std::size_t i = 0; i < 3; ++i) form[f][3] -= form[f][i] * whole(apex[i]);
  }
  const auto& [p, q, r] = form;
  std::array<mpz_class, 10> c;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j)
      c[place_of(i, j)] = p[i] * q[j] + p[j] * q[i] + (cone ? r[i] * r[j] : p[i] * p[j]);
  }
  if (!cone) c[9] += whole(between(dice, -1, 1) * radius * radius * 300);
  if (dice() % 2 == 0) blur(dice, c);
  c[2] = 0;
  return make_face(FaceKind::rational, c, {side / 2, side / 2, 0}, 0, dice() % 2 == 0 ? 1 : -1, 0, lighting);
}

// A cylinder or a cone, or almost one, its apex on the page or off it: a sum of two squares of integer forms, less a third or a constant.
TestFace some_ruled_face(Dice& dice, std::int64_t radius, std::int32_t side, const Lighting& lighting) {
  const bool cone = dice() % 2 == 0;
  const std::int64_t size = dice() % 4 == 0 ? 1000 : 30;
  std::array<mpz_class, 10> c;
  std::array<std::int64_t, 3> apex{between(dice, -radius, radius), between(dice, -radius, radius), 0};
  mpz_class length;
  for (int term = 0; term < (cone ? 3 : 2); ++term) {
    std::array<mpz_class, 4> l;
    for (int i = 0; i < 3; ++i) l[static_cast<std::size_t>(i)] = whole(between(dice, -size, size));
    if (dice() % 8 == 0) l[dice() % 3] = 0;
    for (std::size_t i = 0; i < 3; ++i) l[3] -= l[i] * whole(apex[i]);
    const int sign = term == 2 ? -1 : 1;
    length += l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) c[place_of(i, j)] += sign * l[i] * l[j];
    }
  }
  if (!cone) c[9] -= length * whole(radius * radius) / whole(between(dice, 2, 12));
  if (dice() % 2 == 0) blur(dice, c);
  int light_sign = dice() % 2 == 0 ? 1 : -1;
  if (c[2] < 0) {
    for (mpz_class& k : c) k = -k;
    light_sign = -light_sign;
  }
  return make_face(c[2] == 0 ? FaceKind::rational : FaceKind::root, c, {side / 2, side / 2, 0},
                   dice() % 2 == 0 ? 1 : -1, light_sign, 0, lighting);
}

TEST(SphereContour, GivesTheDotsOfTheDotByDotShader) {
  Dice dice(30);
  Tally tally;
  for (int trial = 0; trial < testing::trials(1500); ++trial) {
    const Lighting lighting = some_lighting(dice);
    const std::int64_t radius = dice() % 4 == 0 ? between(dice, 100, 600) : between(dice, 4, 60);
    const auto side = static_cast<std::int32_t>(2 * radius + 4);
    const TestFace face = some_sphere(dice, radius, side, lighting);
    expect_same_dots(face, lighting, some_levels(dice), side, dice, 4, trial, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(500000U));
  EXPECT_LT(tally.declined * 2, tally.dots);
  RecordProperty("declined", std::to_string(tally.declined * 100 / tally.dots));
}

// Line after line, as the engine asks: one line's survey serves those after it.
void expect_same_dots_line_by_line(Dice& dice,
                                   TestFace (*some_face)(Dice&, std::int64_t, std::int32_t, const Lighting&),
                                   FaceKind kind) {
  Tally tally;
  std::uint64_t straight = 0;
  for (int trial = 0; trial < testing::trials(200); ++trial) {
    const Lighting lighting = dice() % 4 == 0 ? random_lighting(dice) : some_lighting(dice);
    const std::int64_t radius = dice() % 8 == 0 ? between(dice, 100, 400) : between(dice, 20, 80);
    const auto side = static_cast<std::int32_t>(2 * radius + 4);
    const TestFace face = some_face(dice, radius, side, lighting);
    if (face.active.kind != kind) continue;
    const std::int32_t levels = some_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, side);
    if (exact == nullptr) continue;
    Contours canvas(lighting, levels, side, side, format_of(trial), screen_of(trial));
    const auto left_cut = static_cast<std::int32_t>(between(dice, 1, 5));
    for (std::int32_t y = 0; y < side; ++y) {
      for (DotRun run : runs_of(face, y, side)) {
        if (trial % 3 == 0)
          run.x0 = std::min(run.x1, run.x0 + (y / 8 % 2) * (run.x1 - run.x0) / left_cut);  // something in front
        const auto by_dots = canvas.shade(face, *exact, false, y, run);
        const auto by_contours = canvas.shade(face, *exact, true, y, run);
        if (by_contours.empty()) continue;  // a line through an apex
        ASSERT_EQ(by_contours, by_dots) << "trial " << trial << " line " << y << " dots " << run.x0 << ".." << run.x1
                                        << " levels " << levels;
        tally.dots += by_dots.size();
      }
    }
    straight += canvas.contours.straight.entries > 0 ? 1 : 0;
  }
  EXPECT_GT(tally.dots, testing::trials(300000U));
  EXPECT_GT(straight, testing::trials(40U));
}

TEST(StraightContour, GivesTheDotsOfTheDotByDotShader) {
  Dice dice(31);
  expect_same_dots_line_by_line(dice, &some_ruled_face, FaceKind::root);
}

TEST(StraightContour, GivesTheDotsOfFacesWhoseDepthIsAQuotient) {
  Dice dice(32);
  expect_same_dots_line_by_line(dice, &some_ruled_quotient, FaceKind::rational);
}

Lighting plain_lighting() {
  Lighting l;
  for (int i = 0; i < 3; ++i) l.matrix[i][i] = 1 << 14;
  l.light = {9000, -14000, -20000};
  l.unit = l.parallel = 1 << 16;
  return l;
}

int lines_not_straight(const std::array<mpz_class, 10>& c, std::int32_t side) {
  const Lighting lighting = plain_lighting();
  const FaceKind kind = c[2] == 0 ? FaceKind::rational : FaceKind::root;
  const TestFace face = make_face(kind, c, {side / 2, side / 2, 0}, -1, 1, 0, lighting);
  const ExactModule* exact = exact_for({&face}, lighting, 65, side);
  return exact == nullptr ? side : Contours(lighting, 65, side, side).lines_not_straight(face, *exact);
}

// One survey serves all lines of a cylinder, also where D lacks all that is not of x; and a cone's, round the apex, all but a few.
TEST(StraightContour, DeclinesFewLines) {
  // x^2 + z^2 = 150^2
  EXPECT_EQ(lines_not_straight({1, 0, 1, 0, 0, 0, 0, 0, 0, -22500}, 400), 0);
  // 9 Z^2 + 2 X Z = 2 X^2 + 3 Y^2 with X = 4 x - 1, Y = 4 y + 2, Z = 4 z, a ring of rulings about the apex
  const std::array<mpz_class, 10> cone{-32, -48, 144, 0, 0, 16, 8, -24, -4, -14};
  EXPECT_LT(lines_not_straight(cone, 600), 16);
  // So within 2^-40.
  std::array<mpz_class, 10> rounded = cone;
  for (mpz_class& k : rounded) k = (k << 40) + 3;
  EXPECT_LT(lines_not_straight(rounded, 600), 16);
  // Along an asymptote: 2 (3 x + y) z = 15000; and (x - 7)^2 + 2 (y + 30) (z + 9) = 0, whose image is the page on one side of a line at a time.
  EXPECT_EQ(lines_not_straight({0, 0, 0, 0, 1, 3, 0, 0, 0, -15000}, 400), 0);
  const std::array<mpz_class, 10> ruling{1, 0, 0, 0, 1, 0, -7, 9, 30, 589};
  EXPECT_LT(lines_not_straight(ruling, 600), 16);
  rounded = ruling;
  for (mpz_class& k : rounded) k <<= 40;
  for (const std::size_t i : {0, 1, 3, 4, 5, 6, 7, 8, 9}) rounded[i] += 3;
  EXPECT_LT(lines_not_straight(rounded, 600), 100);
}

// The highest level only on the ruling that faces the light, a column of dots, between two dots of the level below.
TEST(StraightContour, ShowsALevelThatOnlyTouchesOnABilevelPage) {
  Lighting lighting = plain_lighting();
  lighting.light = {0, 0, -(1 << 15)};
  constexpr std::int32_t side = 200;
  for (std::int32_t column = 0; column < cell_side; ++column) {
    const TestFace face = make_face(FaceKind::root, {1, 0, 1, 0, 0, 0, 0, 0, 0, -6400},
                                    {side / 2 + column, side / 2, 0}, -1, 1, 0, lighting);
    const ExactModule* exact = exact_for({&face}, lighting, 65, side);
    ASSERT_NE(exact, nullptr);
    Contours canvas(lighting, 65, side, side, DotFormat::bilevel);
    for (std::int32_t y = 0; y < 3 * cell_side; ++y) {
      for (const DotRun& run : runs_of(face, y, side)) {
        ASSERT_EQ(canvas.shade(face, *exact, true, y, run), canvas.shade(face, *exact, false, y, run))
            << "column " << column << " line " << y;
      }
    }
    EXPECT_GT(canvas.contours.straight.entries, 0);
  }
}

// D is a square on the line through an apex.
TEST(StraightContour, KnowsTheLineWithACorner) {
  const auto corner_line = [](const std::array<mpz_class, 10>& c) {
    const TestFace face = make_face(FaceKind::root, c, {100, 200, 0}, -1, 1, 0, plain_lighting());
    return corner_line_of(face.active, 130, 160);
  };
  EXPECT_EQ(corner_line({-2, -3, 9, 0, 0, 1, 0, 0, 0, 0}), 200);                // 9 z^2 + 2 x z = 2 x^2 + 3 y^2
  EXPECT_EQ(corner_line({-2, -3, 9, 0, 0, 1, 0, 21, 0, -147}), 207);            // its apex 7 lines on
  EXPECT_EQ(corner_line({-32, -48, 144, 0, 0, 16, 8, -24, -4, -14}), no_line);  // half a line on, a quarter of a dot
  EXPECT_EQ(corner_line({1, 0, 1, 0, 0, 0, 0, 0, 0, -22500}), no_line);         // x^2 + z^2 = 150^2
  EXPECT_EQ(corner_line({-1, 0, 1, 0, 0, 0, 0, 0, 0, 0}), all_lines);           // z^2 = x^2
}

}  // namespace
}  // namespace halfspace
