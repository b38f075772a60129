// keywords.hpp - the words of the language that are no ids.
// Source   Ressler 1985, 2.1. A synonym (2.1.9) is one more row of a table here.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "host/scene/scene.hpp"

namespace halfspace {

enum class Statement : std::uint8_t { plane, quadric, body, definition, enddef, instance, array, light, view };

[[nodiscard]] std::optional<Statement> find_statement(std::string_view word);

struct ViewKeyRule {
  std::string_view word;
  ViewKey key;
  std::size_t numbers;       // how many it takes
  std::string_view meaning;  // of the numbers
  std::string_view options;  // letters that may follow '='
};

// Null when the word is no view parameter.
[[nodiscard]] const ViewKeyRule* find_view_key(std::string_view word);

// A reserved word is refused as an id: it marks where a statement or a parameter starts.
[[nodiscard]] bool is_reserved(std::string_view word);

// All of them, in the order of docs/language.md, for messages.
[[nodiscard]] std::vector<std::string_view> statement_words();
[[nodiscard]] std::vector<std::string_view> view_words();

}  // namespace halfspace
