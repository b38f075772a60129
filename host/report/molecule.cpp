#include "host/report/molecule.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace halfspace {
namespace {

// Numerical Recipes' quick generator: the same on every machine.
class Dice {
 public:
  double unit() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) * 0x1p-24;
  }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint32_t state_ = 1985;
};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// |x - p|^2 - ((x - p).u)^2 = r^2 and the planes of its ends, p = `from`, u the axis.
std::string rod_text(const Rod& rod, std::size_t i) {
  Point u = difference(rod.to, rod.from);
  const double length = std::sqrt(dot(u, u));
  for (double& x : u) x /= length;
  const Point& p = rod.from;
  const double along = dot(p, u);
  std::string text =
      fmt::format("quadric c{} <{:.15g} {:.15g} {:.15g}", i, 1 - u[0] * u[0], 1 - u[1] * u[1], 1 - u[2] * u[2]);
  text += fmt::format(" {:.15g} {:.15g} {:.15g}", -u[0] * u[1], -u[1] * u[2], -u[0] * u[2]);
  for (int axis = 0; axis < 3; ++axis) text += fmt::format(" {:.15g}", along * u[axis] - p[axis]);
  text += fmt::format(" {:.15g}>;\n", dot(p, p) - along * along - rod.radius * rod.radius);
  text += fmt::format(
      "plane e{0} <{1:.15g} {2:.15g} {3:.15g} {4:.15g}>; plane s{0} <{1:.15g} {2:.15g} {3:.15g} {5:.15g}>;\n", i, u[0],
      u[1], u[2], -dot(rod.to, u), -along);
  return text + fmt::format("body rod{0} (c{0} e{0} !s{0});\n", i);
}

}  // namespace

Molecule balls_and_sticks() {
  constexpr int count = 15;
  Molecule molecule;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i * 2 / count;
    const double reach = 0.45 + 0.25 * std::cos(3 * turn / 2);
    molecule.balls.push_back(
        {{reach * std::cos(turn), reach * std::sin(turn), 0.35 * std::sin(5 * turn / 2)}, 0.11 + 0.02 * (i % 3)});
  }
  for (int i = 0; i < count; ++i) {
    molecule.rods.push_back({molecule.balls[i].centre, molecule.balls[(i + 1) % count].centre, 0.045});
  }
  return molecule;
}

// Bondi's radii of C, N, O and S as they occur in a protein; a ball of such atoms at a protein's density, 13 atoms (without
// hydrogen) in 246 cubic Angstrom.
Molecule space_filling(int atoms) {
  constexpr std::array radii{1.70, 1.70, 1.70, 1.55, 1.52, 1.70, 1.70, 1.55, 1.52, 1.80};
  const double reach = std::cbrt(atoms * 246.0 / 13 * 3 / (4 * std::numbers::pi));
  const double scale = 0.95 / (reach + 1.8);
  Dice dice;
  Molecule molecule;
  while (static_cast<int>(molecule.balls.size()) < atoms) {
    const Point p{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
    if (dot(p, p) > 1) continue;
    molecule.balls.push_back({{p[0] * reach * scale, p[1] * reach * scale, p[2] * reach * scale},
                              radii[molecule.balls.size() % radii.size()] * scale});
  }
  return molecule;
}

std::string as_uniquadrix(const Molecule& molecule) {
  std::string text = "definition ball; quadric q <1 1 1 0 0 0 0 0 0 -1>; body (q); enddef;\n";
  for (const Ball& ball : molecule.balls) {
    text += fmt::format("instance (ball =sa {:.9f} =tx {:.9f} =ty {:.9f} =tz {:.9f});\n", ball.radius, ball.centre[0],
                        ball.centre[1], ball.centre[2]);
  }
  for (std::size_t i = 0; i < molecule.rods.size(); ++i) text += rod_text(molecule.rods[i], i);
  return text + "light .2; light .8 -.5 .9 -.8; view dop 0 0 -1 whw 1 whh 1;\n";
}

// z points to the eye there, and the picture is one unit wide; "0" as the eye's distance is a parallel view.
std::string as_raster3d(const Molecule& molecule, int side) {
  std::string text = fmt::format(
      "halfspace\n{0} {0}\n0 0\n1\n0 0 0\nF\n25\n0\n0.2\n0\n0\n-0.5 0.9 0.8\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 2\n"
      "3\n*\n*\n*\n",
      side);
  for (const Ball& ball : molecule.balls) {
    text += fmt::format("2\n{:.9f} {:.9f} {:.9f} {:.9f} 1 1 1\n", ball.centre[0], ball.centre[1], -ball.centre[2],
                        ball.radius);
  }
  for (const Rod& rod : molecule.rods) {
    text += fmt::format("5\n{:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} 1 1 1\n", rod.from[0], rod.from[1],
                        -rod.from[2], rod.radius, rod.to[0], rod.to[1], -rod.to[2], rod.radius);
  }
  return text + "0\n";
}

}  // namespace halfspace
