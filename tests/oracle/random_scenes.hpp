// random_scenes.hpp - scenes out of a seed: the same seed gives the same scene on every machine.
//   1 to 3 bodies that may meet, mate or coincide (bodies: random_bodies.hpp).
#pragma once

#include <cstdint>
#include <string>

#include "host/flatten/integer_scene.hpp"

namespace halfspace::oracle {

// A UniQuadrix text: orthographic, oblique or perspective, with lights from everywhere; coefficients small
// integers, some moved by 1e-3 to 1e-9. Most have a window; about one in ten is fitted to the page and has
// none.
std::string random_scene(std::uint64_t seed);

// One or two bodies of quadrics that meet, fitted to the page.
std::string random_meeting_scene(std::uint64_t seed);

// Integers at once, with small coefficients: exact ties and tangencies abound. size x size dots.
IntegerScene random_integer_scene(std::uint64_t seed, int size = 64);

}  // namespace halfspace::oracle
