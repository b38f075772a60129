// mutate.hpp - a hard case a little, or much, changed: a seed names the change.
//   Coefficients are moved by 10^-12 to 10^3, doubled, cleared, negated; bodies placed anew, or bounded by one
//   half-space more; lights and views replaced.
#pragma once

#include <string>

#include "host/flatten/integer_scene.hpp"
#include "tests/oracle/dice.hpp"

namespace halfspace::testing {

// `text` has no definitions of its own: all its bodies go into one, which is placed by random transforms.
[[nodiscard]] std::string mutated_text(const std::string& text, oracle::Dice& dice);

// Bodies may borrow half-spaces from those of the donor.
void mutate(IntegerScene& scene, const IntegerScene& donor, oracle::Dice& dice);

}  // namespace halfspace::testing
