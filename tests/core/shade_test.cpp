// The level of every dot of random faces, by every shader, against GMP.
#include "firmware/core/shade.hpp"

#include <gtest/gtest.h>

#include "firmware/core/exact.hpp"
#include "tests/core/faces.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

constexpr std::int32_t side = 96;

struct Shaded {
  std::vector<std::uint8_t> levels;  // of dots x0 .. x1
  Counters counters;
};

class Canvas {
 public:
  Canvas(const Lighting& lighting, std::int32_t levels, std::int32_t width = side)
      : lighting_(lighting),
        page_{width, side, DotFormat::gray, levels, 0},
        words_(row_words(page_)),
        squares_(static_cast<std::size_t>(levels)),
        table_(make_levels(lighting, levels, squares_)) {}

  [[nodiscard]] const LevelTable& table() const { return table_; }

  Shaded shade(const TestFace& face, const ExactModule& exact, Shader shader, std::int32_t y, DotRun run,
               std::int32_t stride = 1) {
    Shaded result;
    RowPainter painter(page_, words_, {});
    painter.begin(y);
    const ShadeJob job{face.active, lighting_, table_, exact, painter, result.counters, stride};
    if (face.active.kind == FaceKind::root) {
      shade_root_span(job, shader, y, run.x0, run.x1);
    } else {
      shade_rational_span(job, shader, y, run.x0, run.x1);
    }
    result.levels.resize(page_.row_bytes());
    painter.copy_to(result.levels);
    result.levels = {result.levels.begin() + run.x0, result.levels.begin() + run.x1 + 1};
    return result;
  }

 private:
  const Lighting& lighting_;
  Page page_;
  std::vector<std::uint32_t> words_, squares_;
  LevelTable table_;
};

struct Tally {
  std::uint64_t dots = 0, exact = 0;
};

// Every run of the face on line y, whole and cut to a few dots, by every shader: a stride of 1 is exact.
void expect_exact_levels(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t y,
                         Dice& dice, Tally& tally) {
  const ExactModule* exact = exact_for({&face}, lighting, levels, side);
  if (exact == nullptr) return;
  Canvas canvas(lighting, levels);
  for (const DotRun& run : runs_of(face, y, side)) {
    std::vector<std::int32_t> expected;
    for (std::int32_t x = run.x0; x <= run.x1; ++x) expected.push_back(testing::level_at(face, lighting, levels, x, y));
    const auto from = static_cast<std::int32_t>(between(dice, run.x0, run.x1));
    const auto to = static_cast<std::int32_t>(std::min<std::int64_t>(run.x1, from + between(dice, 0, 3)));
    for (const DotRun& part : {run, DotRun{from, to}}) {
      for (const Shader shader : {Shader::isqrt, Shader::jordan, Shader::stride}) {
        const Shaded shaded = canvas.shade(face, *exact, shader, y, part);
        for (std::int32_t x = part.x0; x <= part.x1; ++x) {
          ASSERT_EQ(shaded.levels[static_cast<std::size_t>(x - part.x0)],
                    expected[static_cast<std::size_t>(x - run.x0)])
              << "dot " << x << " of " << part.x0 << ".." << part.x1 << " line " << y << " of " << levels
              << " levels, shader " << static_cast<int>(shader);
        }
        tally.dots += shaded.levels.size();
        tally.exact += shaded.counters.exact_levels;
      }
    }
  }
}

std::int32_t random_levels(Dice& dice) {
  return dice() % 3 == 0 ? 256 : static_cast<std::int32_t>(between(dice, 2, 256));
}

TEST(Shade, SolidsAreExactAtEveryDotAndRarelyAskForExactArithmetic) {
  Dice dice(20);
  Tally tally;
  for (int trial = 0; trial < testing::trials(400); ++trial) {
    const Lighting lighting = random_lighting(dice);
    const TestFace face =
        solid_face(dice, between(dice, 0, side), between(dice, 0, side), between(dice, 1, 90), lighting);
    for (int i = 0; i < 3; ++i) {
      const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
      expect_exact_levels(face, lighting, random_levels(dice), y, dice, tally);
      ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
    }
  }
  EXPECT_GT(tally.dots, testing::trials(100000U));
  EXPECT_LT(tally.exact * 100, tally.dots);
}

TEST(Shade, RandomCoefficientsOfEverySize) {
  Dice dice(21);
  Tally tally;
  for (int trial = 0; trial < testing::trials(1500); ++trial) {
    const Lighting lighting = random_lighting(dice);
    const FaceKind kind = dice() % 2 == 0 ? FaceKind::root : FaceKind::rational;
    const TestFace face = random_face(dice, kind, static_cast<int>(between(dice, 1, 75)), lighting);
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    expect_exact_levels(face, lighting, random_levels(dice), y, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, testing::trials(50000U));
}

// Large coefficients: the surface's polynomials lose low bits, and the filter's margins must cover them.
TEST(Shade, RoundedSurfacesAreExactToo) {
  Dice dice(22);
  Tally tally;
  int rounded_roots = 0, rounded_squares = 0, rounded_lights = 0;
  for (int trial = 0; trial < testing::trials(3000) && tally.dots < testing::trials(60000U); ++trial) {
    const Lighting lighting = random_lighting(dice);
    TestFace face = solid_face(dice, between(dice, 0, side), between(dice, 0, side), between(dice, 5, 90), lighting);
    if (face.active.kind != FaceKind::root) continue;
    const int bits = static_cast<int>(between(dice, 20, 90));
    for (mpz_class& c : face.c) c = (c << static_cast<unsigned>(bits)) + random_bits(dice, bits / 2);
    face = make_face(FaceKind::root, face.c, {face.active.origin_x, face.active.origin_y, face.active.origin_z},
                     face.active.sheet, face.active.light_sign, 0, lighting);
    if (exact_for({&face}, lighting, 256, side) == nullptr) continue;
    rounded_roots += face.active.surface.discriminant.exponent > 0 ? 1 : 0;
    rounded_squares += face.active.surface.square.exponent > 0 ? 1 : 0;
    rounded_lights += face.active.surface.light.exponent > 0 ? 1 : 0;
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    expect_exact_levels(face, lighting, 256, y, dice, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(rounded_roots, testing::trials(50));
  EXPECT_GT(rounded_squares, testing::trials(50));
  RecordProperty("rounded_lights", rounded_lights);
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

struct Special {
  const char* what;
  std::array<mpz_class, 10> c;
  std::array<std::int32_t, 3> light;
};

TEST(Shade, WhereNormalsOrRootsVanish) {
  std::array<mpz_class, 10> double_plane;  // (x + 2 y + 3 z)^2: D = 0 and N = 0 everywhere
  double_plane[0] = 1, double_plane[1] = 4, double_plane[2] = 9, double_plane[3] = 2, double_plane[4] = 6,
  double_plane[5] = 3;
  std::array<mpz_class, 10> near_double = double_plane;
  near_double[9] = -1;
  std::array<mpz_class, 10> saddle;  // 2 x y + z^2: a cone on its side
  saddle[2] = 1, saddle[3] = 1;
  std::array<mpz_class, 10> rational_cone;  // 2 x z + y^2 = 0: rational, apex at the origin
  rational_cone[5] = 1, rational_cone[1] = 1;
  const Special specials[] = {
      {"cone, apex on a dot", diagonal(-1, -1, 1, 0), {300, -500, -900}},
      {"cone lit along its surface", diagonal(1, -2, 1, 0), {0, 1000, 1000}},
      {"narrow cone", diagonal(-10000, -10000, 1, 0), {1, 2, -3000}},
      {"double plane", double_plane, {1, 1, -1}},
      {"two planes a hair apart", near_double, {1, -1, -1}},
      {"saddle", saddle, {77, -55, -33}},
      {"rational cone", rational_cone, {77, -55, -33}},
      {"cylinder lit along its axis", diagonal(0, 1, 1, -900), {1000, 0, 0}},
      {"sphere lit from behind the limb", diagonal(1, 1, 1, -1600), {1000, 0, 0}},
      {"sphere lit grazing", diagonal(1, 1, 1, -1600), {32767, 1, -1}},
      {"sphere lit frontally", diagonal(1, 1, 1, -1600), {0, 0, -1}},
      {"unlit", diagonal(1, 1, 1, -1600), {0, 0, 0}},
  };
  Dice dice(23);
  for (const Special& special : specials) {
    const Lighting lighting = plain_lighting(special.light);
    const FaceKind kind = special.c[2] == 0 ? FaceKind::rational : FaceKind::root;
    Tally tally;
    for (const int sheet : {-1, 1}) {
      for (const int light_sign : {-1, 1}) {
        const TestFace face = make_face(kind, special.c, {48, 48, 5}, sheet, light_sign, 0, lighting);
        for (const std::int32_t y : {0, 8, 47, 48, 49, 88}) {
          expect_exact_levels(face, lighting, 256, y, dice, tally);
          ASSERT_FALSE(HasFatalFailure()) << special.what;
        }
      }
    }
    EXPECT_GT(tally.dots, 0U) << special.what;
  }
}

TEST(Shade, AmbientLightAndNoParallelLight) {
  Dice dice(24);
  for (const auto& [ambient, parallel] : {std::array{0, 0}, {1000, 0}, {0, 1000}, {400, 900}, {1000, 1000}, {7, 1}}) {
    Lighting lighting = plain_lighting({-300, 200, -800});
    lighting.ambient = ambient;
    lighting.parallel = parallel;
    Tally tally;
    const TestFace face = make_face(FaceKind::root, diagonal(1, 1, 1, -1600), {48, 48, 0}, -1, 1, 0, lighting);
    for (std::int32_t y = 8; y < 90; y += 5) {
      expect_exact_levels(face, lighting, 65, y, dice, tally);
      ASSERT_FALSE(HasFatalFailure()) << ambient << " + " << parallel;
    }
  }
}

// As long as a page is wide: the registers' rounding grows with the length, and so must the margins.
TEST(Shade, TheWidestSpan) {
  constexpr std::int32_t width = 32767;
  const Lighting lighting = plain_lighting({-300, 200, -800});
  Canvas canvas(lighting, 256, width);
  const TestFace face =
      make_face(FaceKind::root, diagonal(3, 3, 2, -3L * 16384 * 16384), {16383, 20, 0}, -1, 1, 0, lighting);
  const TestFace flat = [&lighting] {
    std::array<mpz_class, 10> c = diagonal(1, 2, 0, -1000);
    c[8] = -40000;
    return make_face(FaceKind::rational, c, {16383, 20, 0}, 0, 1, 0, lighting);
  }();
  for (const TestFace* f : {&face, &flat}) {
    const DotRun run = runs_of(*f, 30, width).front();
    ASSERT_GT(run.x1 - run.x0, 32000);
    const Shaded shaded = canvas.shade(*f, exact_1152, Shader::isqrt, 30, run);
    for (std::int32_t x = run.x0; x <= run.x1; x += 7) {
      ASSERT_EQ(shaded.levels[static_cast<std::size_t>(x - run.x0)], testing::level_at(*f, lighting, 256, x, 30)) << x;
    }
    EXPECT_LT(shaded.counters.exact_levels, 330U) << "kind " << static_cast<int>(f->active.kind);
  }
}

// The paper's 6.5.1 written down plainly: exact levels at the span's ends and every stride dots, averages between.
std::vector<std::uint8_t> levels_by_strides(const TestFace& face, const Lighting& lighting, std::int32_t levels,
                                            std::int32_t y, DotRun run, std::int32_t largest) {
  const std::int32_t stride = std::min((run.x1 - run.x0) / 16 + 1, largest);
  std::int32_t left = testing::level_at(face, lighting, levels, run.x0, y);
  std::vector<std::uint8_t> shown{static_cast<std::uint8_t>(left)};
  for (std::int32_t x = run.x0; x < run.x1;) {
    const std::int32_t next = std::min(x + stride, run.x1);
    const std::int32_t right = testing::level_at(face, lighting, levels, next, y);
    shown.insert(shown.end(), static_cast<std::size_t>(next - x - 1), static_cast<std::uint8_t>((left + right) / 2));
    shown.push_back(static_cast<std::uint8_t>(right));
    x = next;
    left = right;
  }
  return shown;
}

TEST(Stride, ShowsExactLevelsAtItsDotsAndAveragesBetween) {
  Dice dice(26);
  std::uint64_t computed = 0, dots = 0;
  for (int trial = 0; trial < testing::trials(400); ++trial) {
    const Lighting lighting = random_lighting(dice);
    const TestFace face = dice() % 2 == 0 ? solid_face(dice, between(dice, 0, side), between(dice, 0, side),
                                                       between(dice, 20, 90), lighting)
                                          : random_face(dice, FaceKind::rational, 40, lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* exact = exact_for({&face}, lighting, levels, side);
    if (exact == nullptr) continue;
    Canvas canvas(lighting, levels);
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    for (const DotRun& run : runs_of(face, y, side)) {
      for (const std::int32_t largest : {2, 3, 32767}) {
        const Shaded shaded = canvas.shade(face, *exact, Shader::stride, y, run, largest);
        ASSERT_EQ(shaded.levels, levels_by_strides(face, lighting, levels, y, run, largest))
            << "trial " << trial << " stride " << largest << " dots " << run.x0 << ".." << run.x1;
        computed += shaded.counters.intensities;
        dots += shaded.levels.size();
      }
    }
  }
  EXPECT_GT(dots, testing::trials(50000U));
  EXPECT_LT(computed * 2, dots);
}

// Longer than a walk of the registers, and strides longer than that.
TEST(Stride, GoesOnFromWalkToWalk) {
  constexpr std::int32_t width = 32767;
  const Lighting lighting = plain_lighting({-300, 200, -800});
  Canvas canvas(lighting, 256, width);
  const TestFace face =
      make_face(FaceKind::root, diagonal(3, 3, 2, -3L * 16384 * 16384), {16383, 20, 0}, -1, 1, 0, lighting);
  const DotRun whole = runs_of(face, 30, width).front();
  for (const DotRun run : {whole, DotRun{3000, 5000}, DotRun{3000, 3512}}) {
    for (const std::int32_t largest : {7, 16, 511, 32767}) {
      const Shaded shaded = canvas.shade(face, exact_1152, Shader::stride, 30, run, largest);
      ASSERT_EQ(shaded.levels, levels_by_strides(face, lighting, 256, 30, run, largest)) << largest;
    }
  }
}

TEST(ReachesLevel, AgreesWithGmpInEveryWidthThatHoldsTheFace) {
  Dice dice(25);
  for (int trial = 0; trial < testing::trials(1500); ++trial) {
    const Lighting lighting = random_lighting(dice);
    const TestFace face = dice() % 2 == 0
                              ? solid_face(dice, 40, 40, between(dice, 1, 50), lighting)
                              : random_face(dice, dice() % 2 == 0 ? FaceKind::root : FaceKind::rational, 50, lighting);
    const std::int32_t levels = random_levels(dice);
    const ExactModule* narrowest = exact_for({&face}, lighting, levels, side);
    const auto x = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    if (narrowest == nullptr || !testing::depth_at(face, x, y)) continue;
    const auto k = static_cast<std::int32_t>(between(dice, 0, levels - 1));
    const bool expected = testing::reaches(face, lighting, levels, k, x, y);
    for (const ExactModule* module : {&exact_384, &exact_768, &exact_1152}) {
      if (module->bits < narrowest->bits) continue;
      ASSERT_EQ(module->reaches_level(face.active, lighting, levels, k, x, y), expected)
          << "trial " << trial << " in " << module->bits << " bits";
    }
  }
}

}  // namespace
}  // namespace halfspace
