// Contours give the dots of the shader that takes them one by one (which shade_test.cpp holds against GMP).
#include "firmware/core/contour.hpp"

#include <gtest/gtest.h>

#include "firmware/core/real.hpp"
#include "tests/core/faces.hpp"

namespace halfspace {
namespace {

using namespace testing;

class Contours {
 public:
  Contours(const Lighting& lighting, std::int32_t levels, std::int32_t width, std::int32_t height)
      : lighting_(lighting),
        page_{width, height, DotFormat::gray, levels, 0},
        words_(row_words(page_)),
        squares_(static_cast<std::size_t>(levels)),
        scratch_(static_cast<std::size_t>(levels)),
        table_(make_levels(lighting, levels, squares_)) {}

  // The run's levels; empty: declined.
  std::vector<std::uint8_t> shade(const TestFace& face, const ExactModule& exact, bool by_contours, std::int32_t y,
                                  DotRun run) {
    RowPainter painter(page_, words_, {});
    painter.begin(y);
    const ShadeJob job{face.active, lighting_, table_, exact, painter, counters, 1, &contours, scratch_};
    if (by_contours) {
      if (!all_contours.shade(job, Shader::contour, y, run.x0, run.x1)) return {};
    } else {
      shade_root_span(job, Shader::isqrt, y, run.x0, run.x1);
    }
    std::vector<std::uint8_t> levels(page_.row_bytes());
    painter.copy_to(levels);
    return {levels.begin() + run.x0, levels.begin() + run.x1 + 1};
  }

  Counters counters;
  FaceContours contours;

 private:
  const Lighting& lighting_;
  Page page_;
  std::vector<std::uint32_t> words_, squares_;
  std::vector<std::int32_t> scratch_;
  LevelTable table_;
};

struct Tally {
  std::uint64_t dots = 0, declined = 0;
};

void expect_same_dots(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t side,
                      Dice& dice, int lines, Tally& tally) {
  const ExactModule* exact = exact_for({&face}, lighting, levels, side);
  if (exact == nullptr) return;
  Contours canvas(lighting, levels, side, side);
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
    default:
      break;
  }
  l.unit = static_cast<std::int32_t>(between(dice, 1, 1 << 16));
  l.ambient = dice() % 2 == 0 ? 0 : static_cast<std::int32_t>(between(dice, 0, l.unit));
  l.parallel = dice() % 2 == 0 ? l.unit : static_cast<std::int32_t>(between(dice, 0, l.unit));
  return l;
}

// A sphere of radius r / 16 dots about a point of the 1/16 dot grid, stretched in y where the lighting's matrix says so.
TestFace some_sphere(Dice& dice, std::int64_t radius, std::int32_t side, const Lighting& lighting) {
  std::array<mpz_class, 10> c;
  const std::int64_t unit = dice() % 2 == 0 ? 16 : between(dice, 1, 64);
  const std::int64_t stretch = lighting.matrix[1][1] == 1 << 14 ? 1 : 2;
  const std::int64_t x = between(dice, -unit, unit);
  const std::int64_t y = between(dice, -unit, unit);
  const std::int64_t r = radius * unit + between(dice, 0, unit);
  // |N| is constant only where the matrix undoes the stretch.
  const mpz_class m = lighting.matrix[1][1];
  const mpz_class ky = stretch == 1 ? mpz_class(1) : mpz_class(1);
  const mpz_class one = 1 << 14;
  const auto u = [](std::int64_t v) { return mpz_class(static_cast<long>(v)); };
  // (unit x - x0)^2 + k (unit y - y0)^2 + (unit z)^2 = r^2 with k = (one / m)^2, times m^2
  const mpz_class sx = stretch == 1 ? mpz_class(1) : mpz_class(m * m);
  const mpz_class sy = stretch == 1 ? mpz_class(1) : mpz_class(one * one);
  (void)ky;
  c[0] = sx * u(unit) * u(unit);
  c[1] = sy * u(unit) * u(unit);
  c[2] = sx * u(unit) * u(unit);
  c[6] = -sx * u(unit) * u(x);
  c[7] = -sy * u(unit) * u(y);
  c[9] = sx * u(x) * u(x) + sy * u(y) * u(y) - sx * u(r) * u(r);
  const std::int64_t at = side / 2;
  return make_face(FaceKind::root, c,
                   {at + between(dice, -radius / 2, radius / 2), at + between(dice, -radius / 2, radius / 2), 0},
                   dice() % 3 == 0 ? 1 : -1, dice() % 3 == 0 ? -1 : 1, 0, lighting);
}

TEST(SphereContour, GivesTheDotsOfTheDotByDotShader) {
  Dice dice(30);
  Tally tally;
  for (int trial = 0; trial < 1500; ++trial) {
    const Lighting lighting = some_lighting(dice);
    const std::int64_t radius = dice() % 4 == 0 ? between(dice, 100, 600) : between(dice, 4, 60);
    const auto side = static_cast<std::int32_t>(2 * radius + 4);
    const TestFace face = some_sphere(dice, radius, side, lighting);
    expect_same_dots(face, lighting, some_levels(dice), side, dice, 4, tally);
    ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
  }
  EXPECT_GT(tally.dots, 500000U);
  EXPECT_LT(tally.declined * 2, tally.dots);
  RecordProperty("declined", std::to_string(tally.declined * 100 / tally.dots));
}

}  // namespace
}  // namespace halfspace
