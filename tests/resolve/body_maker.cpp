#include "tests/resolve/body_maker.hpp"

#include <algorithm>

namespace halfspace::test {
namespace {

IntegerHalfSpace random_plane(Dice& dice) {
  const long size = dice.one_in(4) ? 3 : 1;
  const std::array<long, 4> c{dice.between(-size, size), dice.between(-size, size), dice.between(-size, size),
                              dice.between(-9, 9)};  // braces: thrown in this order everywhere
  return plane(c[0], c[1], c[2], c[3]);
}

SquaredForm random_form(Dice& dice) {
  return {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1), dice.between(-4, 4), dice.one_in(4) ? -1 : 1};
}

// Spheres, cylinders, cones, plane pairs, double planes, points, empty ones and quadrics of any kind.
IntegerHalfSpace random_quadric(Dice& dice) {
  switch (dice.between(0, 5)) {
    case 0: {
      const std::array<long, 4> s{dice.between(-6, 6), dice.between(-6, 6), dice.between(-6, 6), dice.between(-1, 150)};
      return sphere(s[0], s[1], s[2], s[3]);
    }
    case 1: {
      const std::vector<SquaredForm> forms{random_form(dice), random_form(dice)};
      return sum_of_squares(forms, dice.one_in(3) ? 0 : -dice.between(1, 100));
    }
    case 2: {
      const long slope = dice.between(1, 3);
      SquaredForm axis = random_form(dice);
      axis.sign = -1;
      const std::vector<SquaredForm> forms{
          {slope, 0, 0, dice.between(-4, 4)}, {0, slope, 0, dice.between(-4, 4)}, axis};
      return sum_of_squares(forms, dice.one_in(2) ? 0 : dice.between(-30, 30));
    }
    case 3: {
      const std::vector<SquaredForm> forms{random_form(dice)};
      return sum_of_squares(forms, dice.one_in(2) ? 0 : -dice.between(0, 60));
    }
    case 4: {  // a paraboloid or a parabolic cylinder: no z^2
      std::array<long, 10> c{dice.between(-1, 1), dice.between(-1, 1), 0, dice.between(-1, 1)};
      for (std::size_t i = 6; i < 9; ++i) c[i] = dice.between(-8, 8);
      c[9] = dice.between(-40, 40);
      return quadric(c);
    }
    default: {
      std::array<long, 10> c{};
      for (std::size_t i = 0; i < 6; ++i) c[i] = dice.between(-2, 2);
      for (std::size_t i = 6; i < 9; ++i) c[i] = dice.between(-6, 6);
      c[9] = dice.between(-99, 20);
      if (dice.one_in(12)) std::fill_n(c.begin(), 6, 0);
      return quadric(c);
    }
  }
}

}  // namespace

IntegerHalfSpace plane(long a, long b, long c, long d) {
  IntegerHalfSpace h;
  h.kind = HalfSpaceKind::plane;
  h.c = {a, b, c, d};
  return h;
}

IntegerHalfSpace quadric(std::array<long, 10> c) {
  IntegerHalfSpace h;
  h.kind = HalfSpaceKind::quadric;
  std::copy(c.begin(), c.end(), h.c.begin());
  return h;
}

IntegerHalfSpace sphere(long x, long y, long z, long radius_squared) {
  return sum_of_squares({{1, 0, 0, -x}, {0, 1, 0, -y}, {0, 0, 1, -z}}, -radius_squared);
}

IntegerHalfSpace sum_of_squares(const std::vector<SquaredForm>& forms, long constant) {
  std::array<long, 10> c{};
  c[9] = constant;
  for (const SquaredForm& f : forms) {
    const std::array<long, 10> square{f.a * f.a, f.b * f.b, f.c * f.c, f.a * f.b, f.b * f.c,
                                      f.a * f.c, f.a * f.d, f.b * f.d, f.c * f.d, f.d * f.d};
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += f.sign * square[i];
  }
  return quadric(c);
}

IntegerHalfSpace complement_of(IntegerHalfSpace h) {
  h.complement = !h.complement;
  return h;
}

IntegerHalfSpace transparent(IntegerHalfSpace h) {
  h.transparent = true;
  return h;
}

IntegerScene page_with(std::vector<IntegerHalfSpace> half_spaces, int width, int height) {
  IntegerScene scene;
  scene.width = width;
  scene.height = height;
  scene.scissor = {0, 0, width - 1, height - 1};
  IntegerBody body;
  body.name = "body";
  body.origin = {width / 2, height / 2, 0};
  for (std::size_t i = 0; i < half_spaces.size(); ++i) half_spaces[i].name.append("h").append(std::to_string(i));
  body.half_spaces = std::move(half_spaces);
  body.x0 = 0;
  body.y0 = 0;
  body.x1 = width - 1;
  body.y1 = height - 1;
  scene.bodies.push_back(std::move(body));
  return scene;
}

long Dice::between(long low, long high) {
  return low + static_cast<long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
}

std::vector<IntegerHalfSpace> random_body(Dice& dice, int most_quadrics) {
  std::vector<IntegerHalfSpace> half_spaces;
  const long count = dice.between(1, 8);
  int quadrics = 0;
  for (long i = 0; i < count; ++i) {
    IntegerHalfSpace h;
    if (!half_spaces.empty() && dice.one_in(12)) {
      h = half_spaces[static_cast<std::size_t>(dice.between(0, static_cast<long>(half_spaces.size()) - 1))];
    } else if (quadrics < most_quadrics && dice.one_in(2)) {
      h = random_quadric(dice);
      ++quadrics;
    } else {
      h = random_plane(dice);
    }
    h.complement = dice.one_in(3);
    h.transparent = dice.one_in(6);
    half_spaces.push_back(h);
  }
  return half_spaces;
}

std::vector<IntegerHalfSpace> random_quadrics(Dice& dice, int most) {
  std::vector<IntegerHalfSpace> half_spaces;
  const long count = dice.between(2, most);
  for (long i = 0; i < count; ++i) {
    IntegerHalfSpace h = random_quadric(dice);
    h.complement = dice.one_in(3);
    h.transparent = dice.one_in(6);
    half_spaces.push_back(std::move(h));
  }
  return half_spaces;
}

std::vector<IntegerHalfSpace> magnified(std::vector<IntegerHalfSpace> half_spaces, long factor) {
  for (IntegerHalfSpace& h : half_spaces) {
    const bool is_plane = h.kind == HalfSpaceKind::plane;
    for (std::size_t i = is_plane ? 3 : 6; i < 10; ++i) h.c[i] *= factor;
    if (!is_plane) h.c[9] *= factor;
  }
  return half_spaces;
}

}  // namespace halfspace::test
