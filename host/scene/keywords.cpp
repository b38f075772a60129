#include "host/scene/keywords.hpp"

#include <array>
#include <utility>

namespace halfspace {
namespace {

constexpr std::array<std::pair<std::string_view, Statement>, 9> statements{{
    {"plane", Statement::plane},
    {"quadric", Statement::quadric},
    {"body", Statement::body},
    {"definition", Statement::definition},
    {"enddef", Statement::enddef},
    {"instance", Statement::instance},
    {"array", Statement::array},
    {"light", Statement::light},
    {"view", Statement::view},
}};

constexpr std::array<ViewKeyRule, 8> view_keys{{
    {"vrp", ViewKey::vrp, 3, "x y z", ""},
    {"vpn", ViewKey::vpn, 3, "x y z", "vp"},
    {"vup", ViewKey::vup, 3, "x y z", "vp"},
    {"dop", ViewKey::dop, 3, "x y z", "vp"},
    {"cop", ViewKey::cop, 3, "x y z", "ar"},
    {"whh", ViewKey::whh, 1, "size", ""},
    {"whw", ViewKey::whw, 1, "size", ""},
    {"fbp", ViewKey::fbp, 2, "d1 d2", ""},
}};

}  // namespace

std::optional<Statement> find_statement(std::string_view word) {
  for (const auto& [name, statement] : statements) {
    if (name == word) return statement;
  }
  return std::nullopt;
}

const ViewKeyRule* find_view_key(std::string_view word) {
  for (const ViewKeyRule& rule : view_keys) {
    if (rule.word == word) return &rule;
  }
  return nullptr;
}

bool is_reserved(std::string_view word) { return find_statement(word).has_value() || find_view_key(word) != nullptr; }

std::vector<std::string_view> statement_words() {
  std::vector<std::string_view> words;
  words.reserve(statements.size());
  for (const auto& [name, statement] : statements) words.push_back(name);
  return words;
}

std::vector<std::string_view> view_words() {
  std::vector<std::string_view> words;
  words.reserve(view_keys.size());
  for (const ViewKeyRule& rule : view_keys) words.push_back(rule.word);
  return words;
}

}  // namespace halfspace
