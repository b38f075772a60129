// quote.hpp - names of the input as a message shows them, and the name that was probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

// The text in single quotes; unprintable bytes as \xNN, and at most 40 bytes of it.
[[nodiscard]] std::string quote(std::string_view text);

// "a, b, c"
[[nodiscard]] std::string list(const std::vector<std::string_view>& words);

// "; did you mean 'x'?" for the candidate that is at most two letters off, or "".
// Cost   Declines more than 1000 candidates and words over 40 bytes, so that a wrong scene stays cheap.
[[nodiscard]] std::string did_you_mean(std::string_view written, const std::vector<std::string_view>& candidates);

}  // namespace halfspace
