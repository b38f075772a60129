// Contours of any quadric against the integer root at every dot, itself tested against GMP (shade_test.cpp); and the parts that
// carry the proof: certified roots, and the course of the intensity.
#include <gtest/gtest.h>

#include "firmware/core/contour.hpp"
#include "firmware/core/isqrt.hpp"
#include "firmware/core/level_chord.hpp"
#include "firmware/core/line_section.hpp"
#include "firmware/core/quotient_section.hpp"
#include "firmware/core/ridge_form.hpp"
#include "firmware/core/root_surface.hpp"
#include "tests/core/faces.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

struct Row {
  std::vector<std::uint8_t> levels;
  Counters counters;
};

class Canvas {
 public:
  Canvas(const Lighting& lighting, std::int32_t levels, std::int32_t width)
      : lighting_(lighting),
        page_{width, width, DotFormat::gray, levels, 0},
        words_(row_words(page_)),
        squares_(static_cast<std::size_t>(levels)),
        table_(make_levels(lighting, levels, squares_)) {}

  Row contour(const TestFace& face, const ExactModule& exact, std::int32_t y, DotRun run) {
    return shade(face, exact, y, run, [](const ShadeJob& job, std::int32_t line, DotRun dots) {
      EXPECT_TRUE(general_contour(job, line, dots.x0, dots.x1));
    });
  }
  Row dots(const TestFace& face, const ExactModule& exact, std::int32_t y, DotRun run) {
    return shade(face, exact, y, run, [](const ShadeJob& job, std::int32_t line, DotRun dots) {
      const auto shade_span = job.face.kind == FaceKind::root ? &shade_root_span : &shade_rational_span;
      shade_span(job, Shader::isqrt, line, dots.x0, dots.x1);
    });
  }
  [[nodiscard]] bool by_depth() const { return contours_.general.forms.by_depth; }
  // From now on, what contours know of a face serves its next lines.
  void keep() { keeps_ = true; }
  template <class Shade>
  Row shade(const TestFace& face, const ExactModule& exact, std::int32_t y, DotRun run, Shade shade) {
    Row row;
    RowPainter painter(page_, words_, {});
    painter.begin(y);
    if (!keeps_) contours_ = {};
    shade(ShadeJob{face.active, lighting_, table_, exact, painter, row.counters, 1, &contours_}, y, run);
    row.levels.resize(page_.row_bytes());
    painter.copy_to(row.levels);
    return row;
  }

 private:
  const Lighting& lighting_;
  Page page_;
  std::vector<std::uint32_t> words_, squares_;
  LevelTable table_;
  FaceContours contours_;
  bool keeps_ = false;
};

struct Tally {
  std::uint64_t dots = 0, exact = 0, asked = 0;
};

// Every run of the face on line y, and a random part of it.
void expect_same_dots(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t y,
                      std::int32_t width, Dice& dice, Tally& tally) {
  const ExactModule* exact = exact_for({&face}, lighting, levels, width);
  if (exact == nullptr) return;
  Canvas canvas(lighting, levels, width);
  for (const DotRun& run : runs_of(face, y, width)) {
    const auto from = static_cast<std::int32_t>(between(dice, run.x0, run.x1));
    const auto to = static_cast<std::int32_t>(between(dice, from, run.x1));
    for (const DotRun& part : {run, DotRun{from, to}}) {
      const Row row = canvas.contour(face, *exact, y, part);
      ASSERT_EQ(row.levels, canvas.dots(face, *exact, y, part).levels)
          << "dots " << part.x0 << ".." << part.x1 << " line " << y << " of " << levels << " levels";
      tally.dots += static_cast<std::uint64_t>(part.x1 - part.x0 + 1);
      tally.exact += row.counters.exact_levels;
      tally.asked += row.counters.intensities;
    }
  }
}

std::int32_t random_levels(Dice& dice) {
  static constexpr std::int32_t usual[] = {2, 17, 65, 256};
  return dice() % 2 == 0 ? usual[dice() % 4] : static_cast<std::int32_t>(between(dice, 2, 256));
}

TEST(GeneralContour, SolidsOfEverySize) {
  Dice dice(31);
  Tally tally;
  for (int trial = 0; trial < testing::trials(3000); ++trial) {
    const auto width = static_cast<std::int32_t>(trial % 50 == 0 ? 1000 : between(dice, 8, 200));
    const Lighting lighting = random_lighting(dice);
    const TestFace face =
        solid_face(dice, between(dice, 0, width), between(dice, 0, width), between(dice, 1, width), lighting);
    if (face.active.kind != FaceKind::root) continue;
    const auto y = static_cast<std::int32_t>(between(dice, 0, width - 1));
    expect_same_dots(face, lighting, random_levels(dice), y, width, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(100000U));
}

TEST(GeneralContour, RandomCoefficientsOfEverySize) {
  Dice dice(32);
  Tally tally;
  for (int trial = 0; trial < testing::trials(3000); ++trial) {
    const Lighting lighting = random_lighting(dice);
    const TestFace face = random_face(dice, FaceKind::root, static_cast<int>(between(dice, 1, 75)), lighting);
    const auto y = static_cast<std::int32_t>(between(dice, 0, 95));
    expect_same_dots(face, lighting, random_levels(dice), y, 96, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(50000U));
}

// Depths that are polynomials, such as a paraboloid's seen along its axis, against exact arithmetic by way of the dot by dot shader.
TEST(GeneralContour, FacesWithPolynomialNormals) {
  Dice dice(39);
  Tally tally;
  for (int trial = 0; trial < testing::trials(3000); ++trial) {
    Lighting lighting = random_lighting(dice);
    for (auto& row : lighting.matrix) row[3] = 0;
    const auto width = static_cast<std::int32_t>(trial % 50 == 0 ? 1000 : between(dice, 8, 200));
    std::array<mpz_class, 10> c;
    const int bits = static_cast<int>(between(dice, 1, 75));
    for (const int i : {0, 1, 3, 6, 7, 8, 9}) c[static_cast<std::size_t>(i)] = random_bits(dice, bits);
    if (trial % 2 == 0) {  // as steep as the page is wide, so that many levels are met
      for (const int i : {6, 7, 8}) c[static_cast<std::size_t>(i)] *= width;
      c[9] *= width * width;
    }
    const TestFace face = make_face(FaceKind::rational, c, {between(dice, 0, width), between(dice, 0, width), 0}, 0,
                                    dice() % 2 == 0 ? -1 : 1, 0, lighting);
    ASSERT_TRUE(has_polynomial_normal(face.active, lighting));
    const auto y = static_cast<std::int32_t>(between(dice, 0, width - 1));
    expect_same_dots(face, lighting, random_levels(dice), y, width, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(100000U));
  EXPECT_LT(tally.asked * 4, tally.dots);
}

std::array<mpz_class, 10> diagonal(long a, long b, long c, long k) {
  std::array<mpz_class, 10> q;
  q[0] = a, q[1] = b, q[2] = c, q[9] = k;
  return q;
}

Lighting plain_lighting(std::array<std::int32_t, 3> light) {
  Lighting l;
  for (int i = 0; i < 3; ++i) l.matrix[i][i] = 1 << 14;
  l.light = light;
  l.ambient = 0;
  l.parallel = l.unit = 1000;
  return l;
}

// A face without z^2: with coefficients of any size; or, so that many levels are met, a hyperboloid, a cone or a saddle of some radius
// seen along an asymptote.
TestFace quotient_face(Dice& dice, std::int32_t width, bool is_solid, const Lighting& lighting) {
  std::array<mpz_class, 10> c;
  const int bits = static_cast<int>(between(dice, 1, is_solid ? 20 : 70));
  for (mpz_class& k : c) k = random_bits(dice, bits);
  c[2] = 0;
  if (is_solid) {
    const std::int64_t radius = between(dice, 1, width);
    for (const int i : {6, 7, 8, 9}) c[static_cast<std::size_t>(i)] = 0;
    c[9] = between(dice, -1, 1) * radius * radius * c[0];
  }
  return make_face(FaceKind::rational, c, {between(dice, 0, width), between(dice, 0, width), between(dice, -9, 9)}, 0,
                   dice() % 2 == 0 ? -1 : 1, 0, lighting);
}

TEST(GeneralContour, FacesWhoseDepthIsAQuotient) {
  Dice dice(40);
  Tally tally;
  for (int trial = 0; trial < testing::trials(6000); ++trial) {
    const auto width = static_cast<std::int32_t>(trial % 50 == 0 ? 1000 : between(dice, 8, 200));
    const Lighting lighting = random_lighting(dice);
    const TestFace face = quotient_face(dice, width, trial % 2 == 0, lighting);
    const auto y = static_cast<std::int32_t>(between(dice, 0, width - 1));
    expect_same_dots(face, lighting, random_levels(dice), y, width, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(200000U));
  EXPECT_LT(tally.asked * 4, tally.dots);
  EXPECT_LT(tally.exact * 200, tally.dots);
}

// A line through an apex, one along a ruling, a limb at infinity within the page, light along the surface.
TEST(GeneralContour, DegenerateQuotients) {
  // 10 in the order of face.hpp: x^2, y^2, z^2, xy, yz, xz, x, y, z, 1.
  const std::array<mpz_class, 10> faces[] = {
      {1, 0, 0, 0, 1, 0, 0, 0, 0, 0},       {1, 0, 0, 0, 1, 0, 0, 0, 0, -900},
      {1, 0, 0, 0, 1, 0, 0, 0, 0, 900},     {0, 0, 0, 0, 0, 1, 0, -20, 0, 0},
      {0, 0, 0, 0, 0, 1, -20, 0, 0, 0},     {0, 1, 0, 0, 0, 1, 0, 0, 0, 0},
      {1, 1, 0, 0, 2, 1, 0, 0, 0, -400},    {0, 0, 0, 0, 1, 1, 30, 0, 0, 0},
      {0, 0, 0, 1, 0, 1, 0, 0, 0, 0},       {1000000, 0, 0, 0, 1, 0, 0, 0, 0, 0},
      {1, 0, 0, 0, 1000000, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 1000000, 0, 0, 0, -1}};
  const std::array<std::int32_t, 3> lights[] = {{300, -500, -900}, {0, 1000, 1000}, {1, 2, -3000}, {1000, 0, 0},
                                                {0, 0, -1},        {32767, 1, -1},  {0, 0, 0},     {77, -55, -33}};
  Dice dice(41);
  Tally tally;
  for (const auto& c : faces) {
    for (const auto& light : lights) {
      const Lighting lighting = plain_lighting(light);
      const TestFace face = make_face(FaceKind::rational, c, {48, 48, 5}, 0, 1, 0, lighting);
      for (const std::int32_t y : {0, 8, 47, 48, 49, 88}) {
        expect_same_dots(face, lighting, 65, y, 97, dice, tally);
        ASSERT_FALSE(HasFatalFailure()) << "face " << &c - faces << " light " << &light - lights;
      }
    }
  }
  EXPECT_GT(tally.dots, 40000U);
}

// Hyperboloids seen nearly along their asymptotic cone, where N is a small difference of large terms.
TestFace asymptotic_face(Dice& dice, std::int32_t width, const Lighting& lighting) {
  std::array<mpz_class, 10> c;
  for (std::size_t i = 0; i < 6; ++i) c[i] = between(dice, -(1 << 20), 1 << 20);
  c[2] >>= static_cast<unsigned>(between(dice, 0, 20));
  if (c[2] == 0) c[2] = 1;
  const std::int64_t radius = between(dice, 1, width);
  c[9] = mpz_class(static_cast<long>(between(dice, -(1 << 20), 1 << 20))) * static_cast<long>(radius * radius);
  return make_face(FaceKind::root, c, {between(dice, 0, width), between(dice, 0, width), 0}, dice() % 2 == 0 ? 1 : -1,
                   dice() % 2 == 0 ? 1 : -1, 0, lighting);
}

// Line after line, in one span or two: forms made for a block of lines serve all of them.
TEST(GeneralContour, EveryLineOfAFace) {
  Dice dice(38);
  std::uint64_t dots = 0;
  for (int trial = 0; trial < testing::trials(225); ++trial) {
    const auto width = static_cast<std::int32_t>(trial % 50 == 0 ? 400 : between(dice, 8, 100));
    const Lighting lighting = random_lighting(dice);
    const TestFace face = trial % 2 == 0   ? quotient_face(dice, width, true, lighting)
                          : trial % 3 == 0 ? asymptotic_face(dice, width, lighting)
                                           : solid_face(dice, between(dice, 0, width), between(dice, 0, width),
                                                        between(dice, 1, width), lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, width);
    if (face.active.kind == FaceKind::plane || exact == nullptr) continue;
    Canvas canvas(lighting, levels, width);
    canvas.keep();
    for (std::int32_t y = 0; y < width; ++y) {
      for (const DotRun& run : runs_of(face, y, width)) {
        const std::int32_t cut = dice() % 2 == 0 ? run.x1 : static_cast<std::int32_t>(between(dice, run.x0, run.x1));
        for (const DotRun& part : {DotRun{run.x0, cut}, DotRun{cut, run.x1}}) {
          ASSERT_EQ(canvas.contour(face, *exact, y, part).levels, canvas.dots(face, *exact, y, part).levels)
              << "trial " << trial << " dots " << part.x0 << ".." << part.x1 << " line " << y;
          dots += static_cast<std::uint64_t>(part.x1 - part.x0 + 1);
        }
      }
    }
  }
  EXPECT_GT(dots, testing::trials(200000U));
}

TEST(GeneralContour, LinesOfSightNearAnAsymptote) {
  Dice dice(39);
  std::uint64_t dots = 0;
  std::uint64_t by_depth = 0;
  for (int trial = 0; trial < testing::trials(600); ++trial) {
    const auto width = static_cast<std::int32_t>(trial % 40 == 0 ? 400 : between(dice, 8, 150));
    const Lighting lighting = random_lighting(dice);
    const TestFace face = asymptotic_face(dice, width, lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, width);
    if (face.active.kind != FaceKind::root || exact == nullptr) continue;
    Canvas canvas(lighting, levels, width);
    canvas.keep();
    for (std::int32_t y = 0; y < width; ++y) {
      for (const DotRun& run : runs_of(face, y, width)) {
        ASSERT_EQ(canvas.contour(face, *exact, y, run).levels, canvas.dots(face, *exact, y, run).levels)
            << "trial " << trial << " dots " << run.x0 << ".." << run.x1 << " line " << y;
        dots += static_cast<std::uint64_t>(run.x1 - run.x0 + 1);
        if (canvas.by_depth()) by_depth += static_cast<std::uint64_t>(run.x1 - run.x0 + 1);
      }
    }
  }
  EXPECT_GT(dots, testing::trials(100000U));
  EXPECT_GT(by_depth, testing::trials(10000U));
}

// Large coefficients: the surface's polynomials lose low bits, and every margin must cover them.
TEST(GeneralContour, RoundedSurfaces) {
  Dice dice(33);
  Tally tally;
  for (int trial = 0; trial < testing::trials(1500); ++trial) {
    const Lighting lighting = random_lighting(dice);
    TestFace face = solid_face(dice, between(dice, 0, 96), between(dice, 0, 96), between(dice, 5, 90), lighting);
    if (face.active.kind != FaceKind::root) continue;
    const int bits = static_cast<int>(between(dice, 20, 90));
    for (mpz_class& c : face.c) c = (c << static_cast<unsigned>(bits)) + random_bits(dice, bits / 2);
    face = make_face(FaceKind::root, face.c, {face.active.origin_x, face.active.origin_y, face.active.origin_z},
                     face.active.sheet, face.active.light_sign, 0, lighting);
    const auto y = static_cast<std::int32_t>(between(dice, 0, 95));
    expect_same_dots(face, lighting, 256, y, 96, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(20000U));
}

// Where a form vanishes, or nearly: apexes, rulings along the line, needles and discs, light along the surface.
TEST(GeneralContour, DegenerateFaces) {
  std::array<mpz_class, 10> double_plane;
  double_plane[0] = 1, double_plane[1] = 4, double_plane[2] = 9, double_plane[3] = 2, double_plane[4] = 6,
  double_plane[5] = 3;
  std::array<mpz_class, 10> near_double = double_plane;
  near_double[9] = -1;
  std::array<mpz_class, 10> saddle;
  saddle[2] = 1, saddle[3] = 1;
  std::array<mpz_class, 10> paraboloid = diagonal(1, 2, 1, -900);
  paraboloid[6] = 15, paraboloid[7] = -9;
  const std::array<mpz_class, 10> faces[] = {diagonal(1, 1, 1, -1600),
                                             diagonal(-1, -1, 1, 0),
                                             diagonal(1, -2, 1, 0),
                                             diagonal(-10000, -10000, 1, 0),
                                             double_plane,
                                             near_double,
                                             saddle,
                                             paraboloid,
                                             diagonal(0, 1, 1, -900),
                                             diagonal(1, 0, 1, -900),
                                             diagonal(1, 1000000, 1000000, -1600000000),
                                             diagonal(1000000, 1, 1, -1600000000),
                                             diagonal(1, 1, 1000000, -1600),
                                             diagonal(1, -1, 1, -400),
                                             diagonal(-1, 1, 1, 400),
                                             diagonal(-1, -1, 1, -400)};
  const std::array<std::int32_t, 3> lights[] = {{300, -500, -900}, {0, 1000, 1000}, {1, 2, -3000},
                                                {1000, 0, 0},      {0, 0, -1},      {32767, 1, -1},
                                                {0, 0, 0},         {0, 1000, 0},    {77, -55, -33}};
  Dice dice(34);
  Tally tally;
  for (const auto& c : faces) {
    for (const auto& light : lights) {
      const Lighting lighting = plain_lighting(light);
      for (const int signs : {0, 1, 2, 3}) {
        const TestFace face = make_face(FaceKind::root, c, {48, 48, 5}, (signs & 1) != 0 ? 1 : -1,
                                        (signs & 2) != 0 ? 1 : -1, 0, lighting);
        for (const std::int32_t y : {0, 8, 47, 48, 49, 88}) {
          expect_same_dots(face, lighting, 65, y, 97, dice, tally);
          ASSERT_FALSE(HasFatalFailure()) << "face " << &c - faces << " light " << &light - lights;
        }
      }
    }
  }
  EXPECT_GT(tally.dots, 100000U);
}

// As long as a page is wide: several sections.
TEST(GeneralContour, TheWidestSpan) {
  constexpr std::int32_t width = 32767;
  const Lighting lighting = plain_lighting({-300, 200, -800});
  const TestFace face =
      make_face(FaceKind::root, diagonal(3, 3, 2, -3L * 16384 * 16384), {16383, 20, 0}, -1, 1, 0, lighting);
  Dice dice(35);
  Tally tally;
  expect_same_dots(face, lighting, 256, 30, width, dice, tally);
  EXPECT_GT(tally.dots, 32000U);
}

struct ChordTally {
  int places = 0, close = 0, kept = 0;
};

// Where the chord's ends have different levels, dots as far as its error before a place must still have the one, those beyond the other.
// `row` has the true levels.
template <class Dot, class Chord, class Section>
void expect_chord_holds(const ShadeJob& job, const Section& line, const std::vector<std::uint8_t>& row, DotRun part,
                        ChordTally& tally) {
  const auto [from, to] = part;
  const auto level_at_dot = [&](std::int32_t x) { return row[static_cast<std::size_t>(x)]; };
  const Dot a(line, from - line.middle(), 128);
  const Dot b(line, to - line.middle(), 128);
  const Chord chord(line, a, b);
  for (std::int32_t k = job.table.ambient_level + 1; k <= job.table.top_level; ++k) {
    const std::uint64_t square = job.table.squares[static_cast<std::size_t>(k)];
    if (square < 1U << 20) continue;  // its root has too few bits here
    const auto bar = static_cast<std::uint32_t>(isqrt(square << 32 >> 2));
    for (const int sign : {-1, 1}) {
      if (!chord.keeps_sign(sign, bar, a.above(bar), b.above(bar))) continue;
      ++tally.kept;
      for (std::int32_t x = from; x <= to; ++x) {
        ASSERT_EQ(level_at_dot(x) >= k, sign > 0) << "level " << k << " dot " << x;
      }
    }
    if ((level_at_dot(from) >= k) == (level_at_dot(to) >= k)) continue;
    const std::int32_t sign = level_at_dot(to) >= k ? 1 : -1;
    Chord up = chord;
    if (sign < 0) up.mirror();
    const LevelPlace place = up.place(bar, sign * a.above(bar), sign * b.above(bar));
    if (place.error == LevelPlace::unknown) continue;
    ++tally.places;
    if (place.error < 1 << 13) ++tally.close;
    for (std::int32_t x = from; x <= to; ++x) {
      const bool as_from = (level_at_dot(x) >= k) == (level_at_dot(from) >= k);
      const std::int32_t at = (x - from) * (1 << 16);
      const bool is_before = at < place.at - place.error;
      const bool is_beyond = at > place.at + place.error;
      ASSERT_TRUE(as_from ? !is_beyond : !is_before) << "level " << k << " dot " << x;
    }
  }
}

TEST(LevelChord, SaysNoMoreThanHolds) {
  Dice dice(37);
  ChordTally roots;
  ChordTally quotients;
  for (int trial = 0; trial < testing::trials(12000); ++trial) {
    const std::int32_t width = trial % 8 < 2 ? 1000 : 200;
    const Lighting lighting = random_lighting(dice);
    const TestFace face = trial % 2 == 0   ? quotient_face(dice, width, true, lighting)
                          : trial % 3 == 0 ? asymptotic_face(dice, width, lighting)
                                           : solid_face(dice, between(dice, 0, width), between(dice, 0, width),
                                                        between(dice, width / 8, width), lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, width);
    const bool is_root = face.active.kind == FaceKind::root;
    if ((!is_root && trial % 2 != 0) || exact == nullptr) continue;
    const auto y = static_cast<std::int32_t>(between(dice, 0, width - 1));
    Canvas canvas(lighting, levels, width);
    for (const DotRun& run : runs_of(face, y, width)) {
      if (run.x1 - run.x0 < 2) continue;
      const std::vector<std::uint8_t> row = canvas.dots(face, *exact, y, run).levels;
      canvas.shade(face, *exact, y, run, [&](const ShadeJob& job, std::int32_t line_y, DotRun dots) {
        const auto from = static_cast<std::int32_t>(between(dice, dots.x0, dots.x1 - 2));
        const auto to = static_cast<std::int32_t>(between(dice, from + 2, std::min(dots.x1, from + 40)));
        if (is_root) {
          SectionForms& forms = job.contours->general.forms;
          forms.cover(job, line_y, dots.x0, dots.x1);
          if (forms.may_be_dark) return;
          const LineForms on_line = forms.on(line_y);
          const LineSection line(forms, on_line);
          expect_chord_holds<LevelDot, LevelChord>(job, line, row, {from, to}, roots);
        } else {
          QuotientForms forms{};
          if (!forms.cover(job, line_y, dots.x0, dots.x1)) return;
          forms.turn(quotient_sign(job.face, dots.x0, line_y));
          const QuotientSection line(forms, forms.on(line_y));
          expect_chord_holds<QuotientDot, QuotientChord>(job, line, row, {from, to}, quotients);
        }
      });
      ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
    }
  }
  for (const ChordTally& tally : {roots, quotients}) {
    EXPECT_GT(tally.places, testing::trials(1500));
    EXPECT_GT(tally.close * 5, tally.places * 2);
    EXPECT_GT(tally.kept, 10 * tally.places);
  }
}

// On line after line a span of few dots beside the outline of a large face: chords alone trace most of them.
TEST(GeneralContour, RimsOfLargeFaces) {
  Dice dice(42);
  Tally tally;
  for (int trial = 0; trial < testing::trials(120); ++trial) {
    constexpr std::int32_t lines = 16;
    const auto width = static_cast<std::int32_t>(between(dice, 400, 1000));
    const Lighting lighting = random_lighting(dice);
    const TestFace face = trial % 4 == 0   ? quotient_face(dice, width, true, lighting)
                          : trial % 4 == 1 ? asymptotic_face(dice, width, lighting)
                                           : solid_face(dice, between(dice, 0, width), between(dice, 0, width),
                                                        between(dice, width / 3, width), lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, width);
    if (face.active.kind == FaceKind::plane || exact == nullptr) continue;
    Canvas canvas(lighting, levels, width);
    canvas.keep();
    const auto most = static_cast<std::int32_t>(between(dice, 2, 80));
    const auto top = static_cast<std::int32_t>(between(dice, 0, width - lines));
    for (std::int32_t y = top; y < top + lines; ++y) {
      for (const DotRun& run : runs_of(face, y, width)) {
        for (const DotRun& part :
             {DotRun{run.x0, std::min(run.x1, run.x0 + most)}, DotRun{std::max(run.x0, run.x1 - most), run.x1}}) {
          const Row row = canvas.contour(face, *exact, y, part);
          ASSERT_EQ(row.levels, canvas.dots(face, *exact, y, part).levels)
              << "trial " << trial << " dots " << part.x0 << ".." << part.x1 << " line " << y;
          tally.dots += static_cast<std::uint64_t>(part.x1 - part.x0 + 1);
          tally.asked += row.counters.intensities;
        }
      }
    }
  }
  EXPECT_GT(tally.dots, testing::trials(50000U));
  EXPECT_LT(tally.asked * 3, tally.dots);
}

// The point of it: few dots of a large face are asked for themselves.
TEST(GeneralContour, FollowsBoundariesNotDots) {
  const Lighting lighting = plain_lighting({-300, 200, -800});
  Dice dice(36);
  Tally tally;
  const TestFace face =
      make_face(FaceKind::root, diagonal(3, 2, 5, -3L * 400 * 400), {500, 500, 0}, -1, 1, 0, lighting);
  for (std::int32_t y = 100; y < 900; y += 7) expect_same_dots(face, lighting, 65, y, 1000, dice, tally);
  EXPECT_LT(tally.asked * 50, tally.dots);
  EXPECT_LT(tally.exact * 5000, tally.dots);
}

}  // namespace
}  // namespace halfspace
