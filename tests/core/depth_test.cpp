// Depths: the filter's error bound, the order of two faces along a run, and the exact comparison, against GMP.
#include "firmware/core/depth.hpp"

#include <gtest/gtest.h>

#include "firmware/core/exact.hpp"
#include "firmware/core/radical_plane.hpp"
#include "tests/core/faces.hpp"
#include "tests/sanitized.hpp"

namespace halfspace {
namespace {

using namespace testing;

constexpr std::int32_t side = 80;

TestFace any_face(Dice& dice, const Lighting& lighting) {
  for (;;) {
    const auto kind = static_cast<FaceKind>(between(dice, 0, 2));
    const int bits = static_cast<int>(between(dice, 4, 58));
    TestFace face = dice() % 2 == 0 ? solid_face(dice, between(dice, 0, side), between(dice, 0, side),
                                                 between(dice, 3, 60), lighting)
                                    : random_face(dice, kind, bits, lighting);
    if (exact_for({&face}, lighting, 65, side) != nullptr) return face;
  }
}

DepthSample sample_at(ActiveFace& face, std::int32_t x, std::int32_t y, std::int32_t reach) {
  Counters counters;
  bound_depth(face, y, std::max(0, x - reach), x + reach, counters);
  return DepthLine(face, y).at(x);
}

DepthOrder order_of(TestFace& f, TestFace& g, std::int32_t y, DotRun run, const ExactModule& exact,
                    Counters& counters) {
  for (TestFace* face : {&f, &g}) bound_depth(face->active, y, run.x0, run.x1, counters);
  const bool rational = f.active.kind == FaceKind::rational || g.active.kind == FaceKind::rational;
  DepthProof& proof = rational ? f.active.proofs[0] : proven_order(f.active, g.active, y, run.x0, run.x1);
  return {f.active, g.active, proof, y, run.x0, run.x1, exact, counters};
}

// |z - p| d <= error d, z and error in 2^-16 dot: two signs decide.
TEST(SampleDepth, TheTrueDepthLiesWithinItsError) {
  Dice dice(10);
  int samples = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    TestFace face = any_face(dice, random_lighting(dice));
    const auto x = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto exact = testing::depth_at(face, x, y);
    const DepthSample sample = sample_at(face.active, x, y, 20);
    if (!exact || sample.error < 0) continue;
    ++samples;
    const mpz_class scale = mpz_class(1) << depth_fraction;
    for (const int side_of : {-1, 1}) {
      const mpz_class limit = to_mpz(sample.z + side_of * sample.error);
      const int sign = sign_of_sum(exact->p * scale - limit * exact->d, exact->s * scale, exact->q);
      ASSERT_NE(sign, side_of) << "kind " << static_cast<int>(face.active.kind) << " z " << sample.z << " error "
                               << sample.error << " trial " << trial;
    }
  }
  EXPECT_GT(samples, 2000);
}

TEST(SampleDepth, OrdinarySolidsAreKnownToAThousandthOfADot) {
  Dice dice(11);
  const Lighting lighting = random_lighting(dice);
  for (int trial = 0; trial < 2000; ++trial) {
    TestFace face = solid_face(dice, 40, 40, 30, lighting);
    if (face.active.kind != FaceKind::root || !testing::depth_at(face, 41, 39)) continue;
    const DepthSample sample = sample_at(face.active, 41, 39, 0);
    ASSERT_GE(sample.error, 0);
    ASSERT_LT(sample.error, 64) << "z " << sample.z;
  }
}

// On every dot that a block holds, also those that nobody asked for.
TEST(DepthBlock, HoldsTheTrueDepthOfAllItsDots) {
  Dice dice(14);
  int dots = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    TestFace face = any_face(dice, random_lighting(dice));
    if (face.active.kind == FaceKind::rational) continue;
    const auto a = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto b = static_cast<std::int32_t>(between(dice, a, side - 1));
    make_block(face.active, static_cast<std::int32_t>(between(dice, 0, side - 1)), a, b);
    const DepthBlock& block = face.active.block;
    if (block.error < 0) continue;
    ASSERT_LE(block.x0, a);
    ASSERT_GE(block.x1, b);
    for (int i = 0; i < 20; ++i) {
      const auto x = static_cast<std::int32_t>(i == 0 ? block.x0 : between(dice, block.x0, block.x1));
      const auto y = static_cast<std::int32_t>(i == 1 ? block.y1 : between(dice, block.y0, block.y1));
      const auto exact = testing::depth_at(face, x, y);
      if (!exact) continue;
      ++dots;
      ASSERT_GE(sign_of_sum(exact->p - to_mpz(block.low) * exact->d, exact->s, exact->q), 0) << "trial " << trial;
      ASSERT_LE(sign_of_sum(exact->p - to_mpz(block.high) * exact->d, exact->s, exact->q), 0) << "trial " << trial;
      const DepthSample sample = DepthLine(face.active, y).at(x);
      const mpz_class scale = mpz_class(1) << depth_fraction;
      for (const int side_of : {-1, 1}) {
        const mpz_class limit = to_mpz(sample.z + side_of * sample.error);
        ASSERT_NE(sign_of_sum(exact->p * scale - limit * exact->d, exact->s * scale, exact->q), side_of)
            << "trial " << trial << " dot " << x << ", " << y;
      }
    }
  }
  EXPECT_GT(dots, 15000);
}

TEST(ProvenOrder, HoldsOnAllDotsOfTheProof) {
  Dice dice(15);
  const Lighting lighting = random_lighting(dice);
  int proven = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    TestFace f = solid_face(dice, between(dice, 20, 60), between(dice, 20, 60), between(dice, 10, 60), lighting);
    TestFace g = solid_face(dice, between(dice, 20, 60), between(dice, 20, 60), between(dice, 10, 60), lighting);
    if (trial % 3 == 0) g = random_face(dice, FaceKind::plane, 6, lighting);
    if (f.active.kind == FaceKind::rational || g.active.kind == FaceKind::rational) continue;
    f.active.order = 1;
    g.active.order = 2;
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto a = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto b = static_cast<std::int32_t>(between(dice, a, side - 1));
    for (TestFace* face : {&f, &g}) make_block(face->active, y, a, b);
    const DepthProof& proof = proven_order(f.active, g.active, y, a, b);
    const int nearer = proof.nearer;
    ASSERT_TRUE(proof.holds(y, a, b));
    ASSERT_EQ(&proven_order(f.active, g.active, proof.y1, proof.x0, proof.x1), &proof) << "the proof is kept";
    if (nearer == 0) continue;
    for (int i = 0; i < 20; ++i) {
      const auto px = static_cast<std::int32_t>(between(dice, proof.x0, proof.x1));
      const auto py = static_cast<std::int32_t>(between(dice, proof.y0, proof.y1));
      const auto zf = testing::depth_at(f, px, py);
      const auto zg = testing::depth_at(g, px, py);
      if (!zf || !zg) continue;
      ++proven;
      ASSERT_EQ(testing::compare(*zf, *zg), nearer) << "trial " << trial << " dot " << px << ", " << py;
    }
  }
  EXPECT_GT(proven, 5000);
}

// The dots of a run on one line from left to right: the order turns that way alone, where find_turn says.
void expect_turn(const TestFace& f, const TestFace& g, DepthProof& proof, std::int32_t y, DotRun run) {
  Counters counters;
  const std::int32_t found = find_turn(f.active, g.active, proof, y, run.x0, run.x1, counters);
  int last = -proof.turn;
  for (std::int32_t x = run.x0; x <= run.x1; ++x) {
    const int sign = testing::compare(*testing::depth_at(f, x, y), *testing::depth_at(g, x, y));
    ASSERT_TRUE(sign == last || last == -proof.turn) << "dot " << x << " line " << y;
    last = sign;
    if (found < 0) continue;
    ASSERT_EQ(sign, x < found ? -proof.turn : proof.turn) << "dot " << x << " line " << y;
  }
}

TEST(ProvenOrder, TurnsOnceOnAllLinesOfTheProof) {
  Dice dice(17);
  const Lighting lighting = random_lighting(dice);
  int changes = 0;
  int constant = 0;
  for (int trial = 0; trial < trials(6000); ++trial) {
    const auto solid = [&] {
      return solid_face(dice, between(dice, 10, 70), between(dice, 20, 60), between(dice, 20, 60), lighting);
    };
    TestFace f = solid();
    TestFace g = trial % 4 == 0 ? random_face(dice, FaceKind::plane, 6, lighting) : solid();
    if (f.active.kind == FaceKind::rational || g.active.kind == FaceKind::rational) continue;
    f.active.order = 1;
    g.active.order = 2;
    const auto first = static_cast<std::int32_t>(between(dice, 0, side - 1));
    const auto a = static_cast<std::int32_t>(between(dice, 0, 20));
    const auto b = static_cast<std::int32_t>(between(dice, a + 34, side - 1));
    for (TestFace* face : {&f, &g}) make_block(face->active, first, a, b);
    DepthProof& proof = proven_order(f.active, g.active, first, a, b);
    if (proof.turn == 0) continue;
    ASSERT_EQ(proof.nearer, 0);
    for (std::int32_t y = proof.y0; y <= proof.y1; ++y) {
      for (const DotRun& one : runs_of(f, y, proof.x1 + 1)) {
        for (const DotRun& other : runs_of(g, y, proof.x1 + 1)) {
          const DotRun both{std::max<std::int32_t>({one.x0, other.x0, proof.x0}), std::min(one.x1, other.x1)};
          if (both.x0 > both.x1) continue;
          expect_turn(f, g, proof, y, both);
          ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
          (both.x0 < proof.crossing && proof.crossing <= both.x1 ? changes : constant) += 1;
        }
      }
    }
  }
  EXPECT_GT(changes, trials(1000));
  EXPECT_GT(constant, trials(1000));
}

TEST(CompareDepth, AgreesWithGmp) {
  Dice dice(12);
  const Lighting lighting = random_lighting(dice);
  int ties = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const TestFace f = any_face(dice, lighting);
    TestFace g = any_face(dice, lighting);
    // Every third time the same surface, multiplied, or shifted by the least amount.
    if (trial % 3 == 0) {
      auto c = f.c;
      for (mpz_class& k : c) k *= 3;
      if (dice() % 2 == 0) c[f.active.kind == FaceKind::plane ? 3 : 9] += between(dice, -1, 1);
      g = make_face(f.active.kind, c, {f.active.origin_x, f.active.origin_y, f.active.origin_z}, f.active.sheet, 1, 7,
                    lighting);
    }
    const ExactModule* exact = exact_for({&f, &g}, lighting, 65, side);
    if (exact == nullptr) continue;
    for (int i = 0; i < 8; ++i) {
      const auto x = static_cast<std::int32_t>(between(dice, 0, side - 1));
      const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
      const auto zf = testing::depth_at(f, x, y);
      const auto zg = testing::depth_at(g, x, y);
      if (!zf || !zg) continue;
      const int expected = testing::compare(*zf, *zg);
      ties += expected == 0 ? 1 : 0;
      ASSERT_EQ(exact->compare_depth(f.active, g.active, x, y), expected)
          << "trial " << trial << " dot " << x << ", " << y;
      ASSERT_EQ(exact->compare_depth(g.active, f.active, x, y), -expected);
    }
  }
  EXPECT_GT(ties, 100);
}

// A second face close to the first: the same surface moved, tilted or turned to its other sheet.
TestFace neighbour(Dice& dice, const TestFace& f, const Lighting& lighting) {
  auto c = f.c;
  const std::size_t last = f.active.kind == FaceKind::plane ? 4 : 10;
  for (std::size_t i = 0; i < last; ++i) {
    if (i != 2 && dice() % 3 == 0) c[i] += between(dice, -2, 2);
  }
  const int sheet = dice() % 3 == 0 ? -f.active.sheet : f.active.sheet;
  return make_face(
      f.active.kind, c,
      {f.active.origin_x + between(dice, -1, 1), f.active.origin_y, f.active.origin_z + between(dice, -1, 1)}, sheet, 1,
      static_cast<std::uint32_t>(dice() % 1000), lighting);
}

void expect_dot_by_dot(TestFace& f, TestFace& g, const ExactModule& exact, std::int32_t y, DotRun run) {
  Counters counters;
  DepthOrder order = order_of(f, g, y, run, exact, counters);
  std::int32_t x = run.x0;
  while (!order.done()) {
    const DepthOrder::Piece piece = order.next();
    ASSERT_GE(piece.end, x);
    for (; x <= piece.end; ++x) {
      const int sign = testing::compare(*testing::depth_at(f, x, y), *testing::depth_at(g, x, y));
      const bool first = sign != 0 ? sign < 0 : f.active.order < g.active.order;
      ASSERT_EQ(piece.first, first) << "dot " << x << " of " << run.x0 << ".." << run.x1 << " line " << y;
    }
  }
  ASSERT_EQ(x, run.x1 + 1) << "the pieces cover the run";
}

TEST(DepthOrder, PiecesEqualTheExactOrderDotByDot) {
  Dice dice(13);
  const Lighting lighting = random_lighting(dice);
  int dots = 0;
  for (int trial = 0; trial < 400 || dots < 20000; ++trial) {
    ASSERT_LT(trial, 4000) << "too few runs are shared";
    TestFace f = any_face(dice, lighting);
    TestFace g = trial % 2 == 0 ? any_face(dice, lighting) : neighbour(dice, f, lighting);
    const ExactModule* exact = exact_for({&f, &g}, lighting, 65, side);
    if (exact == nullptr) continue;
    const auto y = static_cast<std::int32_t>(between(dice, 0, side - 1));
    for (const DotRun& a : runs_of(f, y, side)) {
      for (const DotRun& b : runs_of(g, y, side)) {
        const DotRun both{std::max(a.x0, b.x0), std::min(a.x1, b.x1)};
        if (both.x0 > both.x1) continue;
        dots += both.x1 - both.x0 + 1;
        expect_dot_by_dot(f, g, *exact, y, both);
        ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
      }
    }
  }
}

// What the radical plane tells of a run, dot by dot: of lines to come, then of this one. False: nothing of this one.
bool expect_inner_dots(TestFace& f, TestFace& g, std::int32_t y, DotRun run, int& proven) {
  DepthProof& proof = proven_order(f.active, g.active, y, run.x0, run.x1);
  if (proof.radical.fraction == RadicalPlane::missing) return false;
  if (proof.nearer != 0) {
    ++proven;
    for (std::int32_t x = run.x0; x <= run.x1; ++x) {
      EXPECT_EQ(testing::compare(*testing::depth_at(f, x, y), *testing::depth_at(g, x, y)), proof.nearer)
          << "dot " << x << " line " << y;
    }
  }
  TestFace& inner = proof.inner < 0 ? f : g;
  TestFace& outer = proof.inner < 0 ? g : f;
  InnerDots dots;
  if (!find_inner_dots(inner.active, proof, y, run.x0, run.x1, dots)) return false;
  for (std::int32_t x = run.x0; x <= run.x1; ++x) {
    const int sign = testing::compare(*testing::depth_at(inner, x, y), *testing::depth_at(outer, x, y));
    EXPECT_EQ(sign, dots.from <= x && x <= dots.to ? -1 : 1) << "dot " << x << " line " << y;
  }
  return true;
}

// Balls, and ellipsoids of one shape, in integers that are coarse, so that they also touch, tie and meet on dots: down their lines, with what
// earlier ones have found.
TEST(DepthOrder, OfTwoSpheresOneIsNearerOnNeighbouringDots) {
  Dice dice(16);
  const Lighting lighting;
  std::array<std::int64_t, 6> shape{1, 1, 1};
  const auto ball = [&](std::uint32_t order, int sheet) {
    std::array<mpz_class, 10> c;
    const mpz_class a = 1 << between(dice, 0, 3);
    for (std::size_t i = 0; i < shape.size(); ++i) c[i] = a * mpz_class(shape[i]);
    for (int i = 6; i < 9; ++i) c[static_cast<std::size_t>(i)] = between(dice, -6, 6);
    c[9] = -a * mpz_class(between(dice, 4, 700));
    return make_face(FaceKind::root, c, {between(dice, 20, 44), between(dice, 20, 44), between(dice, -9, 9)}, sheet, 1,
                     order, lighting);
  };
  int changes = 0;
  int parted = 0;
  int proven = 0;
  for (int trial = 0; trial < trials(600); ++trial) {
    if (trial % 3 == 0) {
      for (std::size_t i = 0; i < shape.size(); ++i) shape[i] = i < 3 ? between(dice, 3, 6) : between(dice, -1, 1);
    } else {
      shape = {1, 1, 1};
    }
    TestFace f = ball(1, dice() % 4 == 0 ? 1 : -1);
    TestFace g = ball(2, dice() % 4 == 0 ? 1 : -1);
    const ExactModule* exact = exact_for({&f, &g}, lighting, 65, side);
    ASSERT_NE(exact, nullptr);
    for (std::int32_t y = 0; y < side; ++y) {
      const auto runs_f = runs_of(f, y, side);
      const auto runs_g = runs_of(g, y, side);
      if (runs_f.empty() || runs_g.empty()) continue;
      const DotRun both{std::max(runs_f[0].x0, runs_g[0].x0), std::min(runs_f[0].x1, runs_g[0].x1)};
      if (both.x0 > both.x1) continue;
      expect_dot_by_dot(f, g, *exact, y, both);
      parted += expect_inner_dots(f, g, y, both, proven) ? 1 : 0;
      ASSERT_FALSE(HasFailure()) << "trial " << trial;
      changes += f.active.proofs[0].crossing >= 0 ? 1 : 0;
    }
  }
  EXPECT_GT(changes, trials(1000));
  EXPECT_GT(parted, trials(1000));
  EXPECT_GT(proven, trials(1000));
}

// Every dot ties, on the longest run there is: each is decided by itself, and the stack of runs must hold them all.
TEST(DepthOrder, TheLongestTieFitsTheStackAndGoesToTheLowerOrder) {
  const Lighting lighting;
  std::array<mpz_class, 10> c;
  c[0] = c[1] = c[2] = 1;
  c[9] = -mpz_class(40000) * 40000;
  for (const std::int32_t length : {1, 2, 3, 32766, 32767}) {
    for (const std::uint32_t order : {3U, 5U}) {
      TestFace f = make_face(FaceKind::root, c, {16000, 10, 0}, -1, 1, order, lighting);
      TestFace g = make_face(FaceKind::root, c, {16000, 10, 0}, -1, 1, 4, lighting);
      Counters counters;
      DepthOrder pieces = order_of(f, g, 10, {0, length - 1}, exact_384, counters);
      std::int32_t x = 0;
      while (!pieces.done()) {
        const auto piece = pieces.next();
        ASSERT_EQ(piece.first, order < 4);
        x = piece.end + 1;
      }
      ASSERT_EQ(x, length);
    }
  }
}

TEST(DepthOrder, CrossingsCostTheirLogarithmNotTheRun) {
  const Lighting lighting;
  std::array<mpz_class, 10> sphere;
  sphere[0] = sphere[1] = sphere[2] = 1;
  sphere[9] = -mpz_class(20000) * 20000;
  std::array<mpz_class, 10> plane;
  plane[2] = 3;
  plane[0] = 1;
  plane[3] = 30000;
  TestFace f = make_face(FaceKind::root, sphere, {16000, 10, 0}, -1, 1, 0, lighting);
  TestFace g = make_face(FaceKind::plane, plane, {16000, 10, 0}, 0, 1, 1, lighting);
  Counters counters;
  DepthOrder pieces = order_of(f, g, 10, {0, 32000}, exact_384, counters);
  while (!pieces.done()) (void)pieces.next();
  EXPECT_LT(counters.depth_samples, 600U);
  EXPECT_LT(counters.exact_depths, 8U);
}

}  // namespace
}  // namespace halfspace
