// quantisation.hpp - how far an integer picture lies from the scene's text: the promise oracle's question, with a figure for an answer.
// Radius  For each dot the least of the radii 2^-20, 2^-19 .. 2^-4 dots within which some true surface, or an edge of it, may have moved to
//         give the dot its level (give or take half a level); 0 where the dot's centre alone does.
// Levels  Where the centre does, how far the level is from that of the true face there: 0 for the level itself, at most 1/2.
// Cost    About 1 us for a dot and body; a dot whose centre does not do takes some ms.
#pragma once

#include "host/flatten/integer_scene.hpp"
#include "host/scene/scene.hpp"
#include "tests/hard/drawing.hpp"

namespace halfspace::testing {

struct QuantisationError {
  double bound = 0;   // dots, as the flattener states it
  double radius = 0;  // dots; 1 when no radius does
  double levels = 0;

  void extend(const QuantisationError& other);  // the larger of each
};

// `levels`: the whole page. The text must give both half-sizes of its window.
[[nodiscard]] QuantisationError quantisation_error(const Scene& scene, const IntegerScene& integers,
                                                   const Levels& levels);

}  // namespace halfspace::testing
