// exact_root.hpp - where a ray meets a half-space's surface, and what holds there, in exact integers.
//   form  a z^2 + 2 b z + c: a half-space on the ray of one dot (a plane's is doubled, which keeps sign and
//   roots) root  z = (p + r sqrt(D)) / d with d > 0, r in {-1, 0, 1}, all integers, z local to the body
// Every question is the sign of U + V sqrt(D1) + W sqrt(D2) with integers U, V, W: squared at most twice.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::oracle {

struct ExactForm {
  mpz_class a, b, c;
};

struct ExactRoot {
  mpz_class p, d, disc;
  int r = 0;
};

// The half-space's value at the local dot (x, y) as a polynomial in the local z.
ExactForm restrict_to_ray(const IntegerHalfSpace& half_space, std::int64_t x, std::int64_t y);

// b^2 - a c.
mpz_class discriminant(const ExactForm& form);

// Sheet 0 is the front (smaller z) or the only root, 1 the back. The root must exist.
ExactRoot root_of(const ExactForm& form, int sheet);

// The sign of the form at the root.
int sign_at(const ExactForm& form, const ExactRoot& root);

// The sign of (z1 + origin1) - (z2 + origin2).
int compare_depths(const ExactRoot& z1, std::int64_t origin1, const ExactRoot& z2, std::int64_t origin2);

// Whether (levels - 1) * intensity >= k at the root of that half-space: integer_scene.hpp, IntegerLighting.
bool reaches_level(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& half_space,
                   std::int64_t x, std::int64_t y, const ExactRoot& root, int k);

}  // namespace halfspace::oracle
