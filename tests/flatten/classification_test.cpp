// Every kind of quadric keeps its rank through rounding, and stays within its bound: the integers against the truth.
#include <vector>

#include "host/flatten/quantise.hpp"
#include "host/flatten/spectrum.hpp"
#include "host/flatten/transform.hpp"
#include "tests/flatten/flatten_fixture.hpp"

namespace halfspace {
namespace {

// The rank of the leading n x n part of a quadric's homogeneous matrix, by exact elimination.
int rank_of(const IntegerForm& form, std::size_t n) {
  std::vector<std::vector<mpq_class>> m(n, std::vector<mpq_class>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = form.c[quadric_index[i][j]];
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < n && rank < n; ++column) {
    std::size_t pivot = rank;
    while (pivot < n && m[pivot][column] == 0) ++pivot;
    if (pivot == n) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < n; ++i) {
      const mpq_class factor = m[i][column] / m[rank][column];
      for (std::size_t j = column; j < n; ++j) m[i][j] -= factor * m[rank][j];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

struct Kind {
  const char* name;
  std::array<int, 10> c;  // of unit size about the origin
  int rank, second_order_rank;
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

const Kind kinds[] = {
    {"Ellipsoid", {1, 2, 3, 0, 0, 0, 0, 0, 0, -1}, 4, 3},
    {"Sphere", {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}, 4, 3},
    {"EmptyEllipsoid", {1, 2, 3, 0, 0, 0, 0, 0, 0, 1}, 4, 3},
    {"OneSheet", {1, 2, -3, 0, 0, 0, 0, 0, 0, -1}, 4, 3},
    {"TwoSheets", {1, 2, -3, 0, 0, 0, 0, 0, 0, 1}, 4, 3},
    {"EllipticParaboloid", {1, 2, 0, 0, 0, 0, 0, 0, 1, 0}, 4, 2},
    {"HyperbolicParaboloid", {1, -2, 0, 0, 0, 0, 0, 0, 1, 0}, 4, 2},
    {"Cone", {1, 2, -3, 0, 0, 0, 0, 0, 0, 0}, 3, 3},
    {"Point", {1, 2, 3, 0, 0, 0, 0, 0, 0, 0}, 3, 3},
    {"EllipticCylinder", {1, 2, 0, 0, 0, 0, 0, 0, 0, -1}, 3, 2},
    {"EmptyCylinder", {1, 2, 0, 0, 0, 0, 0, 0, 0, 1}, 3, 2},
    {"HyperbolicCylinder", {1, -2, 0, 0, 0, 0, 0, 0, 0, -1}, 3, 2},
    {"ParabolicCylinder", {1, 0, 0, 0, 0, 0, 0, 1, 0, 0}, 3, 1},
    {"PlanesThatMeet", {1, -2, 0, 0, 0, 0, 0, 0, 0, 0}, 2, 2},
    {"Line", {1, 2, 0, 0, 0, 0, 0, 0, 0, 0}, 2, 2},
    {"ParallelPlanes", {1, 0, 0, 0, 0, 0, 0, 0, 0, -1}, 2, 1},
    {"EmptyPlanes", {1, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 2, 1},
    {"PlaneLike", {0, 0, 0, 0, 0, 0, 1, 0, 0, -1}, 2, 0},
    {"DoublePlane", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 1, 1},
    {"Everything", {0, 0, 0, 0, 0, 0, 0, 0, 0, -1}, 1, 0},
    {"Nothing", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 0, 0},
};

Number number(const std::string& text) { return {text, std::stod(text)}; }

struct Placed {
  RealHalfSpace shape;
  Matrix4 inverse = identity_matrix;

  [[nodiscard]] RealHalfSpace on_page() const { return normalised(transformed(shape, inverse)); }
};

// The kind, `size` dots large, turned by odd angles and moved to (x, y, z).
Placed placed(const Kind& kind, const std::string& size, const std::array<std::string, 3>& at) {
  Placed result;
  result.shape.kind = HalfSpaceKind::quadric;
  for (std::size_t i = 0; i < 10; ++i) result.shape.c[i] = kind.c[i];
  const std::vector<Transform> transforms{ScaleAllTransform{number(size)},
                                          RotateTransform{Axis::x, number("23.7")},
                                          RotateTransform{Axis::y, number("-41.3")},
                                          RotateTransform{Axis::z, number("77.1")},
                                          TranslateTransform{Axis::x, number(at[0])},
                                          TranslateTransform{Axis::y, number(at[1])},
                                          TranslateTransform{Axis::z, number(at[2])}};
  result.inverse = *inverse_of(transforms);
  return result;
}

std::optional<Quantised> quantise(const Placed& h, const Box& box) {
  auto quantised = quantise(h.shape, h.inverse, region_of(box, 32767));
  if (quantised) quantised->form = seen_from(quantised->form, IntegerPoint{});
  return quantised;
}

Box box_about(const std::array<std::string, 3>& at, Real half) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = decimal_to_real(at[i]) - half;
    box.high[i] = decimal_to_real(at[i]) + half;
  }
  return box;
}

Vector4 gradient_at(const RealHalfSpace& q, const Vector3& p) {
  Vector4 g{};
  for (std::size_t i = 0; i < 4; ++i) {
    g[i] = q.c[quadric_index[i][3]];
    for (std::size_t j = 0; j < 3; ++j) g[i] += q.c[quadric_index[i][j]] * p[j];
  }
  return g;
}

Real value_of(const RealHalfSpace& q, const Vector3& p) {
  const Vector4 g = gradient_at(q, p);
  return g[0] * p[0] + g[1] * p[1] + g[2] * p[2] + g[3];
}

// Points of the true surface on lines along x, in the box: the integer surface passes within the bound of each. The
// distance is taken to first order, so points where the surface is singular are left out.
int check_bound(const Placed& placed_quadric, const Quantised& quantised, const Box& box) {
  const RealHalfSpace truth = placed_quadric.on_page();
  const RealHalfSpace integers = normalised(to_real(quantised.form));
  int checked = 0;
  for (int i = 1; i < 400; ++i) {
    const Real u = Real(i * 37 % 400) / 400;
    const Real v = Real(i) / 400;
    Vector3 p{0, box.low[1] + u * (box.high[1] - box.low[1]), box.low[2] + v * (box.high[2] - box.low[2])};
    const Vector4 g = gradient_at(truth, p);
    const Real a = truth.c[0];
    const Real discriminant = g[0] * g[0] - a * value_of(truth, p);
    if (discriminant < 0 || a == 0) continue;
    for (const int sign : {-1, 1}) {
      p[0] = (-g[0] + sign * square_root(discriminant)) / a;
      if (p[0] < box.low[0] || p[0] > box.high[0]) continue;
      const Vector4 slope = gradient_at(integers, p);
      const Real steepness = 2 * length({slope[0], slope[1], slope[2]});
      const Real bending = 8 * larger(largest({integers.c[0], integers.c[1], integers.c[2]}),
                                      largest({integers.c[3], integers.c[4], integers.c[5]}));
      if (steepness < bending / 4) continue;  // within a few dots of an apex or an axis
      const Real distance = magnitude(value_of(integers, p)) / steepness;
      EXPECT_LE(static_cast<double>(distance), static_cast<double>(quantised.bound) * 1.01 + 1e-12);
      ++checked;
    }
  }
  return checked;
}

class Classification : public ::testing::TestWithParam<Kind> {
 protected:
  static void check(const std::string& size, const std::array<std::string, 3>& at, Real half, double promise,
                    int surface_points = 20) {
    const Kind& kind = GetParam();
    const Placed truth = placed(kind, size, at);
    const Box box = box_about(at, half);
    const auto quantised = quantise(truth, box);
    ASSERT_TRUE(quantised);
    EXPECT_EQ(rank_of(quantised->form, 4), kind.rank);
    EXPECT_EQ(rank_of(quantised->form, 3), kind.second_order_rank);
    EXPECT_LE(static_cast<double>(quantised->bound), promise);
    const int checked = check_bound(truth, *quantised, box);
    const bool has_surface = std::string(kind.name).find("Empty") == std::string::npos && kind.rank > 1;
    if (has_surface && kind.rank > 2 && std::string(kind.name) != "Point") {
      EXPECT_GE(checked, surface_points);
    }
  }
};

TEST_P(Classification, OfABodyInTheMiddle) { check("100.3", {"1056.1", "850.2", "3.7"}, 200, 0x1p-14); }
TEST_P(Classification, OfASmallBody) { check("3.3", {"10.1", "20.2", "-1e3"}, 5, 0x1p-14); }
TEST_P(Classification, OfALargeBody) { check("1903.7", {"2000.1", "1900.2", "5.5"}, 2000, 1.0 / 256); }
TEST_P(Classification, OfTheLargestPage) { check("15111.1", {"16000.1", "15000.2", "5.5"}, 16300, 1.0 / 16); }
TEST_P(Classification, OfAFarBody) { check("100.3", {"1e7", "-1e7", "1e7"}, 200, 0x1p-14); }
TEST_P(Classification, OfASmallFarBody) { check("2.3", {"1e7", "-1e7", "1e7"}, 4, 0x1p-14, 0); }
TEST_P(Classification, OfAHugeSurface) { check("1e9", {"1000.1", "850.2", "3.7"}, 1000, 0x1p-12, 0); }

INSTANTIATE_TEST_SUITE_P(Quadric, Classification, ::testing::ValuesIn(kinds),
                         [](const auto& suite) { return suite.param.name; });

// An ellipsoid with axes a, b, c turned by odd angles.
void check_ellipsoid(const std::array<std::string, 3>& axes) {
  const std::vector<Transform> transforms{
      ScaleTransform{Axis::x, number(axes[0])}, ScaleTransform{Axis::y, number(axes[1])},
      ScaleTransform{Axis::z, number(axes[2])}, RotateTransform{Axis::y, number("33.3")},
      RotateTransform{Axis::z, number("44.4")}};
  const Placed needle{{HalfSpaceKind::quadric, {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}}, *inverse_of(transforms)};
  const auto quantised = quantise(needle, box_about({"0", "0", "0"}, 500));
  ASSERT_TRUE(quantised);
  EXPECT_LE(static_cast<double>(quantised->bound), 0x1p-14);
  EXPECT_EQ(rank_of(quantised->form, 4), 4);
  // The sign of the homogeneous determinant and of the axes: still an ellipsoid.
  const ReducedQuadric reduced = reduce(normalised(to_real(quantised->form)), 500);
  ASSERT_EQ(reduced.count, 3U);
  for (const SquareTerm& term : reduced.squares) EXPECT_GT(static_cast<double>(term.weight), 0);
  EXPECT_LT(static_cast<double>(reduced.constant()), 0);
}

TEST(Quantise, NeedleAndDisc) {
  check_ellipsoid({"500", ".0005", ".0005"});
  check_ellipsoid({"500", "500", ".0005"});
  check_ellipsoid({"500", ".5", ".0005"});
}

// Of radius 10^9, its surface through the page.
TEST(Quantise, AHugeSphere) {
  const Placed truth = placed(kinds[1], "1e9", {"600000512.1", "800000512.2", "7.7"});
  const Box box = box_about({"512", "512", "0"}, 700);
  const auto quantised = quantise(truth, box);
  ASSERT_TRUE(quantised);
  EXPECT_LE(static_cast<double>(quantised->bound), 0x1p-13);
  EXPECT_EQ(quantised->form.c[0], quantised->form.c[2]);
  EXPECT_GT(check_bound(truth, *quantised, box), 20);
}

TEST(Quantise, ATinySphereStaysASphere) {
  const Placed tiny{{HalfSpaceKind::quadric, {1, 1, 1, 0, 0, 0, 0, 0, 0, -power_of_two(-61) / 3}}, identity_matrix};
  const auto quantised = quantise(tiny, box_about({"0", "0", "0"}, 1));
  ASSERT_TRUE(quantised);
  EXPECT_EQ(rank_of(quantised->form, 4), 4);
}

TEST(Quantise, CoefficientsAreNoLargerThanNeeded) {
  const auto bits = [](const mpz_class& v) { return mpz_sizeinbase(v.get_mpz_t(), 2); };
  for (const Kind& kind : kinds) {
    const std::array<std::string, 3> at{"1056.1", "850.2", "3.7"};
    const auto quantised = quantise(placed(kind, "400.3", at), box_about(at, 512));
    ASSERT_TRUE(quantised);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_LE(bits(quantised->form.c[i]), 54U) << kind.name;
  }
}

TEST(Quantise, SmallProportionsAreTakenExactly) {
  const Placed third{{HalfSpaceKind::plane, {Real(1) / 3, Real(2) / 7, 1, Real(-5) / 21}}, identity_matrix};
  const auto plane = quantise(third, box_about({"0", "0", "0"}, 100));
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->form.c[0], 7);
  EXPECT_EQ(plane->form.c[1], 6);
  EXPECT_EQ(plane->form.c[2], 21);
  EXPECT_EQ(plane->form.c[3], -5);
}

}  // namespace
}  // namespace halfspace
