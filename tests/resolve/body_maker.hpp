// body_maker.hpp - half-spaces, bodies and one-body scenes for the resolver's tests, in few words.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::test {

[[nodiscard]] IntegerHalfSpace plane(long a, long b, long c, long d);
[[nodiscard]] IntegerHalfSpace quadric(std::array<long, 10> c);
[[nodiscard]] IntegerHalfSpace sphere(long x, long y, long z, long radius_squared);

// sum of sign_i * (a x + b y + c z + d)^2 + constant
struct SquaredForm {
  long a, b, c, d;
  int sign = 1;
};
[[nodiscard]] IntegerHalfSpace sum_of_squares(const std::vector<SquaredForm>& forms, long constant);

[[nodiscard]] IntegerHalfSpace complement_of(IntegerHalfSpace h);
[[nodiscard]] IntegerHalfSpace transparent(IntegerHalfSpace h);

// A page of width x height dots with one body whose origin is the page's centre and whose box is the page.
[[nodiscard]] IntegerScene page_with(std::vector<IntegerHalfSpace> half_spaces, int width = 40, int height = 40);

// The same for every host and library: only the engine's own numbers are used.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] long between(long low, long high);
  [[nodiscard]] bool one_in(long n) { return between(1, n) == 1; }

 private:
  std::mt19937_64 engine_;
};

// Coefficients small on purpose: tangencies, common points and coincident surfaces abound.
[[nodiscard]] std::vector<IntegerHalfSpace> random_body(Dice& dice, int most_quadrics);

// Two to `most` quadrics, some complements, some transparent.
[[nodiscard]] std::vector<IntegerHalfSpace> random_quadrics(Dice& dice, int most);

// The same body, `factor` times as large.
[[nodiscard]] std::vector<IntegerHalfSpace> magnified(std::vector<IntegerHalfSpace> half_spaces, long factor);

}  // namespace halfspace::test
