// molecule.hpp - two pictures made of spheres and cylinders, each written twice: for us and for Raster3D.
//   balls and sticks  15 spheres on a helix and the 15 rods that join them to the next and the last to the first
//   space filling     4000 atoms of four sizes that overlap as bonded ones do, in a ball
// Frame   x right, y up, z away from the eye; the window is the square of half side 1. All is drawn from fixed seeds.
// Light   ambient 0.2, parallel 0.8 from (-0.5, 0.9, -0.8): Raster3D's light source, on our axes.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace halfspace {

using Point = std::array<double, 3>;

struct Ball {
  Point centre;
  double radius = 0;
};

// With flat ends.
struct Rod {
  Point from, to;
  double radius = 0;
};

struct Molecule {
  std::vector<Ball> balls;
  std::vector<Rod> rods;
};

[[nodiscard]] Molecule balls_and_sticks();
[[nodiscard]] Molecule space_filling(int atoms);

[[nodiscard]] std::string as_uniquadrix(const Molecule& molecule);

// A square picture of `side` dots, one sample a dot, no shadows.
[[nodiscard]] std::string as_raster3d(const Molecule& molecule, int side);

}  // namespace halfspace
