// number.hpp - reads one decimal of a scene, keeping its text for those who read it exactly.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "host/scene/scene.hpp"

namespace halfspace {

// Takes  [+-] digits [. digits] [e [+-] digits], digits on one side of the point being enough.
// Gives  the Number, its text without a leading '+' ("0" for any zero); or what is wrong and what would be right.
// Bound  The text is at most 400 bytes, so that its exact value has fewer than 1200 decimal digits.
[[nodiscard]] std::variant<Number, std::string> read_number(std::string_view text);

}  // namespace halfspace
